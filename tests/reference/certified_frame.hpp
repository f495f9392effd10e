// The certified picture of a stage, as bytes.
#pragma once

#include <cstdint>
#include <vector>

#include "exact_scene.hpp"
#include "reference_file.hpp"
#include "stage_terms.hpp"

namespace fos::reference {

/// Red, green and blue of each pixel, rows from the top, for a stage whose I is the sum of `terms`.
/// The generator has proved that the stored terms give the exact bytes. `scene` is the reference's.
std::vector<std::uint8_t> certified_frame(const ExactScene& scene, const Reference& reference,
                                          Terms terms);

}  // namespace fos::reference
