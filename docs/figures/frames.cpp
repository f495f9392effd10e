// figure_MODULE: the frames that the pages should show. Reads figures, a line of numbers each, and
// writes their pixels one after the other, RGBA: by the library's own loop over the pixels, for the
// pages have another.
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "figure.hpp"
#include "fos/frame.hpp"

namespace {

void append(std::string& bytes, const fos::Color& color) {
  const std::array<long double, 3> pixel{color.r, color.g, color.b};
  for (const long double channel : fos::shown(pixel, false, 0, 0)) {
    bytes += static_cast<char>(fos::to_byte(channel));
  }
  bytes += '\xff';  // opaque
}

}  // namespace

int main() {
  try {
    std::string line;
    while (std::getline(std::cin, line)) {
      std::istringstream words(line);
      std::vector<double> numbers;
      for (std::string word; words >> word;) numbers.push_back(std::stod(word));
      auto figure = fos::figure_of(numbers);
      if (!figure) {
        std::fputs("figure: these numbers are no figure\n", stderr);
        return 2;
      }
      fos::shown_figure() = std::move(*figure);
      std::string bytes;
      fos::render(
          fos::shown_figure().scene, fos::shown_figure().view,
          [&](std::span<const fos::Color> colors, std::span<const std::uint8_t> /*unwritten*/) {
            for (const fos::Color& color : colors) append(bytes, color);
          });
      std::cout << bytes;
    }
    return std::cout.flush() ? 0 : 3;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "figure: %s\n", error.what());
    return 2;
  }
}
