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
  std::function<void(int frames)> render;      ///< the whole frame so often, by one thread
  std::function<Errors(const Truth&)> errors;  ///< of the frame that render made last
  /// The rung whose time is taken off this one's, in every round.
  std::optional<std::size_t> toll = std::nullopt;
};

/// `once` so many times.
template <class Once>
std::function<void(int frames)> repeated(Once once) {
  return [once = std::move(once)](int frames) {
    for (int i = 0; i < frames; ++i) once();
  };
}

/// All rungs of ours, cheapest to most exact, with their scene rounded and prepared. Throws
/// std::range_error for numbers beyond 10^±10000.
std::vector<Rung> ladder(const SceneText& scene);

/// The rung that all times are compared with.
inline constexpr const char* baseline_id = "double";

}  // namespace fos::numerics
