// A rung of the ladder: one way to make the picture of one scene.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "errors.hpp"
#include "fos/scene_text.hpp"

namespace fos::numerics {

struct Rung {
  std::string id;                              ///< in CSV
  std::string name;                            ///< in the person's language
  std::function<void()> render;                ///< one whole frame, by one thread
  std::function<Errors(const Truth&)> errors;  ///< of the frame that render made last
  /// Where another process renders: the processor time that it has used so far, in nanoseconds.
  std::function<double()> elsewhere = [] { return 0.0; };
  /// The rung whose time is taken off this one's, in every round.
  std::optional<std::size_t> toll = std::nullopt;
};

/// All rungs of ours, cheapest to most exact, with their scene rounded and prepared. Throws
/// std::range_error for numbers beyond 10^±10000.
std::vector<Rung> ladder(const SceneText& text);

/// The rung that all times are compared with.
inline constexpr const char* baseline_id = "double";

}  // namespace fos::numerics
