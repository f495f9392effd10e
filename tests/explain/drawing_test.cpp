#include "drawing.hpp"

#include "catch2.hpp"
#include "layout.hpp"
#include "page.hpp"

using namespace fos;

namespace {

std::string drawn(double degrees) {
  std::string out;
  for (const std::string& line : draw_angle(degrees, {})) out += line + '\n';
  return out;
}

/// Where a character stands first: row and column, or -1, -1.
std::pair<int, int> place(const std::vector<std::string>& lines, std::string_view character) {
  for (std::size_t row = 0; row < lines.size(); ++row) {
    const std::size_t at = lines[row].find(character);
    if (at == std::string::npos) continue;
    return {static_cast<int>(row), static_cast<int>(columns_of(lines[row].substr(0, at)))};
  }
  return {-1, -1};
}

}  // namespace

TEST_CASE("an angle of 45 degrees") {
  CHECK(drawn(45) ==
        "              N\n"
        "              │\n"
        "              │     L\n"
        "              │   ··\n"
        "              │ ··\n"
        "    ──────────┴──────────────\n"
        "            P\n");
}

TEST_CASE("every angle is drawn in its place, in few lines") {
  const std::string longest(40, 'x');
  for (int degrees = 0; degrees <= 180; ++degrees) {
    INFO(degrees);
    const std::vector<std::string> lines = draw_angle(degrees, {longest, longest});
    CHECK(lines.size() <= 9);
    for (const std::string& line : lines) CHECK(columns_of(line) <= 80);
    const auto [surface, P] = place(lines, "┴");
    const auto [row, column] = place(lines, "L");
    CHECK(place(lines, "N") == std::pair{0, P});
    CHECK(column > P);
    CHECK(place(lines, "P").first == surface + 1);
    if (degrees < 80) CHECK(row < surface);
    if (degrees > 100) CHECK(row > surface);
    CHECK(place(lines, "x").first == 1);
  }
}
