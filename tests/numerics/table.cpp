#include "table.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "fos/text.hpp"

namespace fos::numerics {
namespace {

// Marks, name, ns/px, ±%, ratio, three errors, three counts: 80 columns.
constexpr const char* layout = "{:<3}{:<17}{:>6}{:>4}{:>6}{:>8}{:>8}{:>8}{:>7}{:>7}{:>6}\n";

/// Three digits, as `0.571`, `57.1`, `571`.
std::string short_number(double value) {
  return fmt::format("{:.{}f}", value, value < 1 ? 3 : value < 10 ? 2 : value < 100 ? 1 : 0);
}

/// Two digits, as `4.8e-5`.
std::string short_error(long double error) {
  if (error == 0) return "0";
  std::string text = fmt::format("{:.1e}", error);
  const std::size_t sign = text.find('e') + 1;
  if (text.size() > sign + 2 && text[sign + 1] == '0') text.erase(sign + 1, 1);
  return text;
}

/// `2?` where some of them are open only.
std::string count(long wrong, long open) {
  return fmt::format("{}{}", wrong + open, open > 0 ? "?" : "");
}

std::string line(const Measured& row) {
  const Errors& errors = row.errors;
  const auto error = [&](long double ErrorsOfI::*which) {
    return errors.I ? short_error(*errors.I.*which) : std::string("-");
  };
  const std::string marks = std::string(row.frontier ? "*" : "") + (row.fastest_right ? "=" : "");
  const double half = (row.ns.third_quartile - row.ns.first_quartile) / 2;
  return fmt::format(layout, marks, row.name, short_number(row.ns.median),
                     fmt::format("{:.0f}", std::min(100 * half / row.ns.median, 999.0)),
                     short_number(row.ratio), error(&ErrorsOfI::max),
                     error(&ErrorsOfI::percentile_99), error(&ErrorsOfI::mean),
                     count(errors.wrong_bytes, errors.open_bytes),
                     count(errors.wrong_spheres, errors.open_spheres), errors.not_finite);
}

std::string heading() {
  return fmt::format("{:<36}{:^24}{:>20}\n", "", say(text::trade_heading_error),
                     say(text::trade_heading_wrong)) +
         fmt::format(layout, "", "", say(text::trade_heading_ns), say(text::trade_heading_spread),
                     say(text::trade_heading_ratio), say(text::trade_heading_max),
                     say(text::trade_heading_99), say(text::trade_heading_mean),
                     say(text::trade_heading_bytes), say(text::trade_heading_spheres),
                     say(text::trade_heading_not_finite));
}

std::string legend(const Study& study) {
  std::string out;
  for (const Text& line :
       {text::trade_legend_marks, text::trade_legend_ns, text::trade_legend_ratio,
        text::trade_legend_error, text::trade_legend_bytes, text::trade_legend_sphere,
        text::trade_legend_slides, text::trade_legend_prepared}) {
    out += say(line) + '\n';
  }
  if (!study.stage.empty()) out += say(text::trade_legend_yours) + '\n';
  return out;
}

/// `a; b` without those that are empty.
std::string joined(const std::vector<std::string>& parts) {
  std::string out;
  for (const std::string& part : parts) {
    if (!part.empty()) out += (out.empty() ? "" : "; ") + part;
  }
  return out;
}

std::string quoted(const std::string& field) {
  std::string out = "\"";
  for (const char c : field) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

}  // namespace

std::string table_of(const Study& study) {
  std::string out =
      say(text::trade_title, {study.scene, std::to_string(study.width),
                              std::to_string(study.height), std::to_string(study.rounds)}) +
      '\n';
  if (!study.stage.empty()) out += say(text::trade_title_stage, {study.stage}) + '\n';
  out += joined({study.processor, study.compiler, "SIMD: " + study.simd}) + '\n';
  if (study.factor > 1) {
    out +=
        say(text::trade_smaller, {std::to_string(study.own_width), std::to_string(study.own_height),
                                  std::to_string(study.factor)}) +
        '\n';
  }
  for (const std::string& note : study.notes) out += note + '\n';
  out += '\n' + heading();
  for (const Measured& row : study.rows) out += line(row);
  return out + '\n' + legend(study);
}

std::string csv_of(const Study& study) {
  std::string out =
      "rung,ns_per_pixel_median,ns_per_pixel_quartile_1,ns_per_pixel_quartile_3,ratio_to_double,"
      "max_error,percentile_99_error,mean_error,wrong_bytes,wrong_spheres,open_bytes,open_spheres,"
      "not_finite,"
      "frontier,fastest_with_right_bytes,rounds,width,height,factor,scene,stage,processor,compiler,"
      "simd\r\n";
  const auto error = [](const Errors& errors, long double ErrorsOfI::*which) {
    return errors.I ? fmt::format("{}", *errors.I.*which) : std::string();
  };
  for (const Measured& row : study.rows) {
    const Errors& errors = row.errors;
    out += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{:d},{:d},{},{},{},{},{},{},{},{},{}\r\n", row.id,
        row.ns.median, row.ns.first_quartile, row.ns.third_quartile, row.ratio,
        error(errors, &ErrorsOfI::max), error(errors, &ErrorsOfI::percentile_99),
        error(errors, &ErrorsOfI::mean), errors.wrong_bytes, errors.wrong_spheres,
        errors.open_bytes, errors.open_spheres, errors.not_finite, row.frontier, row.fastest_right,
        study.rounds, study.width, study.height, study.factor, quoted(study.scene),
        quoted(study.stage), quoted(study.processor), quoted(study.compiler), quoted(study.simd));
  }
  return out;
}

}  // namespace fos::numerics
