// What can be said of a program's answer at a pixel: findings, no guesses.
#pragma once

#include <string>
#include <vector>

#include "explanation.hpp"

namespace fos {

/// For a ray alone and for a picture up to a row.
inline constexpr Limits alone_limits{std::chrono::seconds(2), 0};
inline constexpr Limits picture_limits{std::chrono::seconds(5), 0};

/// Sentences, each a paragraph; the last ones of an explanation.
std::vector<std::string> conclusion(const Subject& subject, const Chain& chain,
                                    const Comparison& comparison);

int exit_status(const Comparison& comparison);

/// Two numbers with the digits that tell them apart, 7 at least: what is right, and what
/// came.
struct Pair {
  std::string right;
  std::string yours;
};
Pair told_apart(const reference::Enclosure& right, const SeenI& yours);

}  // namespace fos
