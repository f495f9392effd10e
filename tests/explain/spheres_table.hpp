// Where a ray meets the spheres, as a table.
#pragma once

#include "chain.hpp"
#include "page.hpp"

namespace fos {

/// A line for each sphere: its discriminant, its two roots, and which of them count. Of many
/// spheres only those that are met, the nearest ones.
void write_spheres(Page& page, const Chain& chain);

}  // namespace fos
