// From exact numbers and enclosures to what a reference file holds.
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <optional>

#include "certified_light.hpp"
#include "interval.hpp"
#include "reference_file.hpp"

namespace fos::reference {

/// x * 2^exponent.
mpq_class times_power_of_two(const mpq_class& x, int exponent);

/// The whole multiple of 2^step that is nearest to `x`.
std::int64_t to_multiple(const mpq_class& x, int step);

/// multiple * 2^step.
mpq_class from_multiple(std::int64_t multiple, int step);

/// How far max(0, x) may be from max(0, exact), for an x in `enclosure` and an exact in `exact`. At
/// least `least`, unless the light is surely behind the surface: `exact` is negative, and stays so
/// when it is off by `margin` times the width of the enclosure.
mpq_class term_width(const Interval& enclosure, const Enclosure& exact, const mpq_class& least);

/// The code of a width that is at least `width`, counted from a stored term, which is itself off by
/// up to 2^(step - 1). Nothing for a width far beyond any term.
std::optional<std::uint8_t> width_code(const mpq_class& width, int step);

}  // namespace fos::reference
