// Pictures in a terminal, of half-block characters: two pixels a character.
#pragma once

#include <string>
#include <vector>

#include "fos/bitmap.hpp"
#include "layout.hpp"

namespace fos {

/// The panels side by side, each `columns` wide with its label above, up to a colon, three of 24 in
/// 80 columns. In `full` or `indexed` colors; else in characters that are darker or lighter.
std::string preview(const std::vector<Panel>& panels, int columns, Colors colors);

}  // namespace fos
