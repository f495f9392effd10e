// The body of a reference file: everything that the header lines and the scene do not say.
#pragma once

#include <span>
#include <string>

#include "reference_file.hpp"

namespace fos::reference {

std::string encode_body(Reference reference);

/// Fills in pixels and ambiguous pixels; width and height are there. Throws ReferenceError.
void decode_body(std::span<const char> bytes, Reference& reference);

}  // namespace fos::reference
