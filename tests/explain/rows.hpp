// The lines of the chain that can be compared, and those between them: right and yours.
#pragma once

#include "explanation.hpp"
#include "page.hpp"

namespace fos {

/// From the sphere to the byte, up to the first line that differs. Without a comparison, what
/// is right alone.
void write_rows(Page& page, const Subject& subject, const Chain& chain,
                const Comparison* comparison);

}  // namespace fos
