// Whatever scene to_scene takes, at random over all that Real reaches, stays finite in the slides'
// formulas.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "catch2.hpp"
#include "common/slides.hpp"
#include "scene_of_any_size.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

/// Scenes whose numbers are anywhere that Real reaches, but near enough to each other that many of
/// them are taken.
class AnyScene {
 public:
  std::string operator()() {
    const double unit = uniform(-range, range);
    const double view_size = unit + uniform(-40, 40);
    std::string scene = view(size(view_size, 20), size(view_size, 20));
    if (chance()) scene += "camera_position = " + triple(unit) + "\n";
    for (int i = 0; i < 2; ++i) {
      scene += "sphere { color = (9, 9, 9) center = " + triple(unit) +
               " radius = " + decimal(size(unit, 12)) + " }\n";
    }
    scene += "light { type = point intensity = " + decimal(size(uniform(-range, range), 1)) +
             " position = " + triple(unit) + " }\n";
    scene += "light { type = directional intensity = 1 direction = " +
             triple(uniform(-2 * range, 2 * range)) + " }\n";
    return scene;
  }

 private:
  static constexpr double range = std::numeric_limits<Real>::max_exponent / 2.0;
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance() { return uniform(0, 1) < 0.5; }
  Wide size(double exponent, double spread) {
    const double any = exponent + uniform(-spread, spread);
    return std::exp2(static_cast<Wide>(std::clamp(any, -16000.0, 16000.0)));
  }
  std::string triple(double exponent) {
    std::string all;
    for (int i = 0; i < 3; ++i) {
      const Wide number = size(exponent, chance() ? 8 : 60) * (chance() ? 1 : -1);
      // The last is never 0: a direction must not be.
      all += (i > 0 ? ", " : "") + (i < 2 && chance() ? "0" : decimal(number));
    }
    return "(" + all + ")";
  }
  std::mt19937 random_{3};
};

}  // namespace

TEST_CASE("whatever scene is taken stays finite") {
  AnyScene any;
  int taken = 0;
  for (int i = 0; i < 20000; ++i) {
    const SceneText text = parse_scene_text("canvas_size = 3 x 3\n" + any(), "f");
    if (!refusal(text).empty()) continue;
    ++taken;
    if (slides_stay_finite(to_scene(text))) continue;
    FAIL_CHECK(text.source);
  }
  INFO(taken);
  CHECK(taken > 1000);
}
