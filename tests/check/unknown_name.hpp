// Names that the compiler does not know: the slides' names, misspelled ones, those of other blocks.
#pragma once

#include <optional>
#include <string>

#include "compile_words.hpp"

namespace fos {

/// Words for an unknown name or member; nothing for an error of another kind.
std::optional<std::string> unknown_name_word(const CompileContext& context);

}  // namespace fos
