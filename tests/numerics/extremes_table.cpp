// The table of extremes in 80 columns, and as CSV.
#include <fmt/core.h>

#include <algorithm>

#include "extremes.hpp"

namespace fos::numerics {
namespace {

std::string error(double value) {
  return value == 0 ? "0" : value < 1e-99 ? "<1e-99" : fmt::format("{:.1e}", value);
}

/// Broken at spaces, at most 80 characters a line.
std::string wrapped(std::string_view words, std::size_t indent = 2) {
  const auto is_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  std::string out(indent, ' ');
  std::size_t column = indent;
  while (!words.empty()) {
    const std::string_view word = words.substr(0, words.find(' '));
    words.remove_prefix(std::min(words.size(), word.size() + 1));
    const auto width =
        static_cast<std::size_t>(std::count_if(word.begin(), word.end(), is_character));
    if (column > indent && column + 1 + width > 80) {
      out += "\n" + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) out += ' ', ++column;
    out += word;
    column += width;
  }
  return out + "\n";
}

/// Reasons for refusal, numbered as they come.
class Reasons {
 public:
  std::string operator()(const std::string& reason) {
    auto known = std::find(all_.begin(), all_.end(), reason);
    if (known == all_.end()) known = all_.insert(all_.end(), reason);
    return say(text::extremes_refused, {std::to_string(known - all_.begin() + 1)});
  }
  std::string list() const {
    std::string out;
    for (std::size_t i = 0; i < all_.size(); ++i)
      out += wrapped(fmt::format("({}) {}", i + 1, all_[i]));
    return out;
  }

 private:
  std::vector<std::string> all_;
};

enum class Columns { all, three_ways, timed };

Columns columns_of(const Family& family, const std::vector<Line>& lines) {
  if (!lines.empty() && lines[0].ways[0].ns > 0) return Columns::timed;
  return family.ways.size() > 2 ? Columns::three_ways : Columns::all;
}

std::string cell(const Answered& answered, Columns columns, Reasons& reasons) {
  const Errors& e = answered.errors;
  if (columns == Columns::timed) {
    return fmt::format("{:>11}{:>8.2f}", error(e.max), answered.ns);
  }
  if (columns == Columns::three_ways) {
    return fmt::format("{:>9}{:>6}{:>5}", error(e.max), e.wrong_bytes, e.not_finite);
  }
  if (!answered.refusal.empty()) return fmt::format("{:>31}", reasons(answered.refusal));
  return fmt::format("{:>8}{:>8}{:>5}{:>5}{:>5}", error(e.max), error(e.mean), e.wrong_bytes,
                     e.wrong_spheres, e.not_finite);
}

std::string headings(const Family& family, Columns columns) {
  const std::size_t width = columns == Columns::all ? 31 : columns == Columns::timed ? 19 : 20;
  std::string ways(18, ' ');
  std::string names = fmt::format("{:<9}{:<9}", say(text::extremes_value), "");
  for (const std::string_view way : family.ways) {
    ways += fmt::format("{:>{}}", fmt::format("- {} -", way), width);
    names += columns == Columns::timed ? fmt::format("{:>11}{:>8}", "max", "ns")
             : columns == Columns::three_ways
                 ? fmt::format("{:>9}{:>6}{:>5}", "max", "byte", "n/f")
                 : fmt::format("{:>8}{:>8}{:>5}{:>5}{:>5}", "max", "mean", "byte", "sph", "n/f");
  }
  return ways + "\n" + names + "\n";
}

std::string why(const Answered& answered) {
  const Errors& e = answered.errors;
  if (!answered.refusal.empty()) return say(text::extremes_why_refused);
  if (e.not_finite > 0) return say(text::extremes_why_not_finite, {std::to_string(e.not_finite)});
  if (e.wrong_spheres > 0)
    return say(text::extremes_why_spheres, {std::to_string(e.wrong_spheres)});
  return say(text::extremes_why_error, {error(e.max)});
}

/// Where one way holds at one precision, and what is next on each side.
std::string summary(const std::vector<const Line*>& sweep, std::size_t way) {
  const auto holds = [&](std::size_t i) {
    return sweep[i]->ways[way].refusal.empty() && !sweep[i]->ways[way].errors.breaks();
  };
  std::size_t first = 0;
  std::size_t size = 0;
  for (std::size_t from = 0, i = 0; i < sweep.size(); ++i) {
    if (!holds(i)) from = i + 1;
    if (i + 1 - from > size) first = from, size = i + 1 - from;
  }
  const auto broken = [&](std::size_t i) {
    return say(text::extremes_breaks, {sweep[i]->parameter, why(sweep[i]->ways[way])});
  };
  if (size == sweep.size()) return say(text::extremes_holds_all);
  if (size == 0) return say(text::extremes_holds_nowhere) + broken(0);
  std::string out =
      say(text::extremes_holds, {sweep[first]->parameter, sweep[first + size - 1]->parameter});
  if (first > 0) out += broken(first - 1);
  if (first + size < sweep.size()) out += broken(first + size);
  return out;
}

}  // namespace

std::string_view name_of(Precision precision) {
  constexpr std::array<std::string_view, 3> names{"float", "double", "extended"};
  return names[static_cast<std::size_t>(precision)];
}

std::string table_of(const Family& family, const std::vector<Line>& lines) {
  const Columns columns = columns_of(family, lines);
  std::string out = wrapped(fmt::format("{}: {}", family.id, say(family.title)), 0);
  out += headings(family, columns);
  Reasons reasons;
  std::string_view last;
  for (const Line& line : lines) {
    out += fmt::format("{:<9}{:<9}", line.parameter == last ? "" : line.parameter,
                       name_of(line.precision));
    for (const Answered& way : line.ways) out += cell(way, columns, reasons);
    out += "\n";
    last = line.parameter;
  }
  out += reasons.list();
  for (const Precision precision : all_precisions) {
    std::vector<const Line*> sweep;
    for (const Line& line : lines) {
      if (line.precision == precision) sweep.push_back(&line);
    }
    for (std::size_t way = 0; way < family.ways.size(); ++way) {
      const std::string name =
          fmt::format("  {:<9}{:<14}", way == 0 ? name_of(precision) : "", family.ways[way]);
      // The name stands where the first line is indented.
      std::string words = wrapped(summary(sweep, way), 25);
      out += name + words.substr(25);
    }
  }
  return out + wrapped(say(family.finding)) + "\n";
}

std::string legend() { return wrapped(say(text::extremes_legend), 0); }

std::string csv_header() {
  return "family,parameter,precision,way,pixels,max_error,mean_error,wrong_bytes,wrong_spheres,"
         "boundary_spheres,not_finite,ns,refusal\n";
}

std::string csv_of(const Family& family, const std::vector<Line>& lines) {
  std::string out;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < line.ways.size(); ++i) {
      const auto& [e, refusal, ns] = line.ways[i];
      std::string quoted;
      for (const char c : refusal) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
      out +=
          fmt::format("{},{},{},{},{},{:.6g},{:.6g},{},{},{},{},{:.4g},\"{}\"\n", family.id,
                      line.parameter, name_of(line.precision), family.ways[i], e.pixels, e.max,
                      e.mean, e.wrong_bytes, e.wrong_spheres, e.boundary, e.not_finite, ns, quoted);
    }
  }
  return out;
}

}  // namespace fos::numerics
