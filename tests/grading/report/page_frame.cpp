#include "page_frame.hpp"

#include <algorithm>

#include "fos/report_assets.inc"
#include "fos/text.hpp"
#include "json.hpp"

namespace fos::grading {
namespace {

/// The source of a policy that allows just this style or script, from its SHA-256 in hexadecimal.
std::string hash_source(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
  }
  return "'sha256-" + base64(bytes) + "'";
}

}  // namespace

std::string whole_page(std::string_view title, const MarkupWriter& body, bool with_script) {
  const std::string policy = "default-src 'none'; img-src 'self' file: data:; style-src " +
                             hash_source(report_css_sha256) + "; script-src " +
                             (with_script ? hash_source(report_js_sha256) : "'none'") +
                             "; base-uri 'none'; form-action 'none'";
  MarkupWriter out;
  out.raw("<!DOCTYPE html>\n<html").attribute("lang", language() == Language::el ? "el" : "en");
  out.raw(">\n<head>\n<meta charset=\"utf-8\">\n");
  out.raw("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n");
  out.raw(R"(<meta http-equiv="Content-Security-Policy")").attribute("content", policy);
  out.raw(">\n<meta name=\"referrer\" content=\"no-referrer\">\n");
  out.raw("<link rel=\"icon\" href=\"data:,\">\n");
  out.element("title", title).raw("\n<style>").raw(report_css).raw("</style>\n</head>\n<body>\n");
  out.add(body);
  if (with_script) out.raw("<script>").raw(report_js).raw("</script>\n");
  out.raw("</body>\n</html>\n");
  return out.str();
}

std::string_view tone(int points, int most, bool judged) {
  return !judged ? "none" : points >= most ? "good" : points > 0 ? "part" : "bad";
}

void add_meter(MarkupWriter& out, int points, int most) {
  const long filled = most > 0 ? std::clamp(points * 100L / most, 0L, 100L) : 0;
  out.raw(R"(<svg class="meter" viewBox="0 0 100 10" preserveAspectRatio="none")");
  out.raw(R"( aria-hidden="true"><rect class="ground" width="100" height="10"/>)");
  out.raw(R"(<rect class="bar" height="10")").attribute("width", filled).raw("/></svg>");
}

}  // namespace fos::grading
