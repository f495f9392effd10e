// The light I of a pixel as a small whole number: what the data hold.
//
// A code stands for a cell of values: 1/512 wide up to |I| = 1 and 1/512 of I above, about a
// quarter of a percent. Beyond |I| = 18 every color shows as white or black, and all is one cell.
#pragma once

#include <cstdint>

namespace fos {

using LightCode = std::uint16_t;

inline constexpr LightCode not_a_number_code = 0xffff;

/// Where I lies on the scale of the codes, a real number: its code is the whole part. NaN for NaN.
double light_scale(double I);

/// The code of I.
LightCode light_code(double I);

/// The values of I that a code stands for, the cell made a tenth wider at both ends: enough for the
/// rounding of a float program.
struct LightCell {
  double low = 0;
  double high = 0;
  double middle() const { return (low + high) / 2; }
};
LightCell light_cell(LightCode code);

}  // namespace fos
