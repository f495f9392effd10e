// The pages docs/en/mistakes.md and docs/el/mistakes.md, made from the catalogue.
#pragma once

#include <string>

#include "fos/text.hpp"

namespace fos {

/// The page in a language, as Markdown. Its pictures are ../images/mistakes/ID.png.
std::string mistakes_page(Language language);

}  // namespace fos
