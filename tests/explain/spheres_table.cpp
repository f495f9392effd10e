#include "spheres_table.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "fos/text.hpp"
#include "number_text.hpp"

namespace fos {
namespace {

constexpr std::size_t most_lines = 8;

/// The smallest t that counts, if one does: where the sphere stands among the others.
double order(const SphereMet& met) {
  constexpr double last = 1e300;
  double t = last;
  for (std::size_t i = 0; i < 2; ++i) {
    if (met.counts[i]) t = std::min(t, met.roots[i].low.get_d());
  }
  return t;
}

std::string counts(const SphereMet& met) {
  if (met.counts[0] && met.counts[1]) return "t1, t2";
  if (!met.counts[0] && !met.counts[1]) return "-";
  return met.counts[0] ? "t1" : "t2";
}

std::string cells(const std::string& sphere, const std::string& discriminant, const std::string& t1,
                  const std::string& t2, const std::string& rest) {
  std::string out =
      fmt::format("  {:>6}{:>14}{:>14}{:>14}   {}", sphere, discriminant, t1, t2, rest);
  out.erase(out.find_last_not_of(' ') + 1);
  return out;
}

std::string line(const Chain& chain, std::size_t i) {
  const SphereMet& met = chain.spheres[i];
  const std::string sphere = std::to_string(i + 1);
  const std::string discriminant =
      decimal_text(reference::Enclosure{met.discriminant, met.discriminant});
  if (sgn(met.discriminant) < 0) {
    return cells(sphere, discriminant, "", "", say(text::explain_missed));
  }
  std::string rest = counts(met);
  if (chain.hit && chain.hit->sphere == static_cast<int>(i + 1)) {
    rest += fmt::format("  <- {}: t{}", say(text::explain_nearest), chain.hit->root + 1);
  }
  return cells(sphere, discriminant, decimal_text(met.roots[0]), decimal_text(met.roots[1]), rest);
}

}  // namespace

void write_spheres(Page& page, const Chain& chain) {
  if (chain.spheres.empty()) {
    page.line(say(text::explain_no_spheres));
    return;
  }
  page.line(say(text::explain_spheres));
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < chain.spheres.size(); ++i) {
    const bool few = chain.spheres.size() <= most_lines;
    if (few || sgn(chain.spheres[i].discriminant) >= 0) shown.push_back(i);
  }
  const std::size_t missed = chain.spheres.size() - shown.size();
  const std::size_t met = shown.size();
  // The first of equal ones is the one that is seen.
  std::stable_sort(shown.begin(), shown.end(), [&](std::size_t a, std::size_t b) {
    return order(chain.spheres[a]) < order(chain.spheres[b]);
  });
  if (shown.size() > most_lines) shown.resize(most_lines);
  std::sort(shown.begin(), shown.end());

  page.line(cells(say(text::explain_sphere_column), "disc", "t1", "t2",
                  say(text::explain_counts_column)));
  for (const std::size_t i : shown) page.line(line(chain, i));
  if (met > shown.size()) {
    page.line(say(text::explain_spheres_more, {std::to_string(met - shown.size())}));
  }
  if (missed > 0) page.line(say(text::explain_spheres_missed, {std::to_string(missed)}));
}

}  // namespace fos
