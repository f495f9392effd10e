// Valid scenes at the extremes: the solution passes its judge at every precision, with nothing but
// what rounding may do; and what the table of extremes counts is what is there to count.
#include <fmt/core.h>

#include <random>

#include "catch2.hpp"
#include "exact_scene.hpp"
#include "extremes_errors.hpp"
#include "extremes_families.hpp"
#include "fos/stage_program.hpp"
#include "generate.hpp"
#include "judge.hpp"
#include "report.hpp"
#include "scene_parts.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

/// Scenes of the families of the table, at random values within what a precision is promised.
class ValidScene {
 public:
  explicit ValidScene(Precision precision) : is_float_(precision == Precision::binary32) {}

  std::vector<std::string> operator()() {
    const double far_light = uniform(0, is_float_ ? 18 : 153);
    const double far_sphere = uniform(0.5, is_float_ ? 2.85 : 7.2);
    const double floor = uniform(1, is_float_ ? 6 : 12);
    const double grazing = uniform(0, is_float_ ? 5 : 12);
    const double near = uniform(1, is_float_ ? 4 : 12);
    const double strong = uniform(-30, is_float_ ? 28 : 100);
    const double camera_z = uniform(-2.5, 1);
    const double unit = uniform(-3, is_float_ ? 6 : 60);
    const std::string lights = ambient("0.2") + directional("0.3", "1, 2, -3");
    return {
        lecture_spheres() + ambient("0.2") + point("0.6", triple(1, 4, 4, far_light)),
        lecture_spheres() + directional("0.6", triple(1, 4, -4, uniform(-1000, 1000))),
        sphere("0, 0, 3", "1") + ambient("0.1") +
            point("0.6", "0.01, 0.02, " + number(2 - std::pow(10, -near))),
        lecture_spheres() + point(tenth(strong), "2, 1, 0") + ambient(tenth(strong)),
        three_spheres() +
            sphere("0, -" + number(std::pow(10, floor) + 1) + ", 0", tenth(floor), 3) + lights +
            point("0.5", "2, 1, 0"),
        viewport(tenth(std::log10(2.6) - far_sphere)) +
            sphere("0.1, 0.2, " + tenth(far_sphere), "1") + lights,
        viewport(tenth(-grazing)) + sphere("0, -1, 3", "1") + lights,
        camera(number(camera_z)) + sphere("0, 0, 0", "2") + ambient("0.2") +
            point("0.6", "3, 4, -5"),
        viewport(tenth(unit), tenth(unit)) + sphere(triple(0, -1, 3, unit), tenth(unit)) +
            sphere(triple(2, 0, 4, unit), tenth(unit), 2) + ambient("0.2") +
            point("0.6", triple(2, 1, 0, unit)),
    };
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  static std::string number(double value) { return fmt::format("{:.17g}", value); }
  /// 10^exponent.
  static std::string tenth(double exponent) {
    const double whole = std::floor(exponent);
    return fmt::format("{:.9f}e{}", std::pow(10, exponent - whole), static_cast<int>(whole));
  }
  static std::string triple(double x, double y, double z, double exponent) {
    const double whole = std::floor(exponent);
    const double scale = std::pow(10, exponent - whole);
    return fmt::format("{0}e{3}, {1}e{3}, {2}e{3}", x * scale, y * scale, z * scale,
                       static_cast<int>(whole));
  }
  bool is_float_;
  std::mt19937 random_{4};
};

std::string program_of(Precision precision) {
  return FOS_SOLUTION + std::string(precision == Precision::binary32   ? "_float"
                                    : precision == Precision::extended ? "_extended"
                                                                       : "");
}

}  // namespace

TEST_CASE("the solution passes on valid scenes at the extremes, at every precision") {
  constexpr unsigned all_terms = ambient_term | point_term | directional_term;
  for (const Precision precision : all_precisions) {
    StageProgram program(program_of(precision), {std::chrono::seconds(60), 60});
    ValidScene valid(precision);
    long judged = 0;
    long all = 0;
    for (int round = 0; round < 5; ++round) {
      for (const std::string& source : valid()) {
        const SceneText scene = parse_scene_text(canvas(15, 14) + source, "scene");
        INFO(name_of(precision) << "\n" << source);
        Frame frame;
        REQUIRE(program.ask(request_for(scene), frame).ending == Ending::complete);
        const Judge judge(reference::generate(scene), all_terms);
        const Verdict verdict = judge.judge(frame);
        INFO(describe(judge, frame, verdict, "scene"));
        CHECK(verdict.passes());
        CHECK(verdict.only_float.pixels == 0);
        const auto pixels = static_cast<long>(frame.unwritten.size());
        all += pixels;
        judged += pixels - verdict.not_judged.pixels;
      }
    }
    INFO(judged << " of " << all << " pixels judged");
    CHECK(judged > all * 9 / 10);
  }
}

TEST_CASE("what the table counts: errors, bytes, spheres, boundary cases, what is not finite") {
  // Column 2, row 0 looks straight ahead, far from the sphere's edge.
  const SceneText scene =
      parse_scene_text(canvas(4, 2) + sphere("0, 0, 4", "1") + ambient("0.499"), "scene");
  const Truth truth = truth_of(scene);
  std::vector<Said> said;
  for (const TruePixel& pixel : truth.pixels) said.push_back({pixel.sphere, pixel.I.high, true});
  const Measure measure(scene, truth);
  REQUIRE(truth.pixels[2].sphere == 1);
  CHECK(measure(said).max < 1e-18);
  CHECK(measure(said).wrong_bytes == 0);
  CHECK_FALSE(measure(said).breaks());

  std::vector<Said> changed = said;
  changed[2].I += 0.001L;
  CHECK(std::abs(measure(changed).max - 0.001) < 1e-12);
  CHECK_FALSE(measure(changed).breaks());
  changed[2].I += 0.001L;
  CHECK(measure(changed).breaks());
  CHECK(measure(changed).wrong_bytes == 1);

  changed = said;
  changed[2].finite = false;
  CHECK(measure(changed).not_finite == 1);
  CHECK(measure(changed).breaks());

  changed = said;
  changed[2].sphere = 0;  // far from any edge
  CHECK(measure(changed).wrong_spheres == 1);
  CHECK(measure(changed).boundary == 0);

  // A ray that is tangent: a thousandth of a pixel away it misses, and neither answer is wrong.
  const SceneText tangent =
      parse_scene_text(canvas(2, 2) + sphere("0, -1, 3", "1") + ambient("0.5"), "scene");
  const Truth touched = truth_of(tangent);
  REQUIRE(touched.pixels[1].sphere == 1);
  changed.assign(4, {});
  for (std::size_t i = 0; i < 4; ++i) changed[i].sphere = touched.pixels[i].sphere;
  for (std::size_t i = 0; i < 4; ++i) changed[i].I = touched.pixels[i].I.high;
  changed[1] = {};
  CHECK(Measure(tangent, touched)(changed).boundary == 1);
  CHECK_FALSE(Measure(tangent, touched)(changed).breaks());
}
