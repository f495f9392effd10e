// The report of the growth, and the scenes that it is measured on. Nothing is timed here.
#include "growth.hpp"

#include <cmath>

#include "catch2.hpp"
#include "certified.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

const std::vector<GrowthSeries>& made_up() {
  static const std::vector<GrowthSeries> series{
      {"spheres",
       &text::growth_spheres,
       &text::growth_spheres_what,
       {{1, 1000, 0.5, 0.1}, {10, 1000, 5, 1}, {100, 1000, 500, 10}}},
      {"canvas", &text::growth_canvas, &text::growth_canvas_what, {{10000, 10000, 0.02, 0.1}}}};
  return series;
}

}  // namespace

TEST_CASE("a line says how the time grew since the one above") {
  setenv("FOS_LANG", "en", 1);
  const std::string table = table_of(made_up());
  CHECK_THAT(table,
             ContainsSubstring("          1         500         0.5                       0.1"));
  CHECK_THAT(table,
             ContainsSubstring("         10       5e+03           5     1.00                1"));
  CHECK_THAT(table,
             ContainsSubstring("        100       5e+05         500     2.00               10"));
}

TEST_CASE("CSV has every point") {
  CHECK(
      csv_of(made_up()) ==
      "series,number,pixels,ns_per_pixel,frame_ms,setup_ms\r\n"
      "spheres,1,1000,500,0.5,0.1\r\nspheres,10,1000,5000,5,1\r\nspheres,100,1000,500000,500,10\r\n"
      "canvas,10000,10000,2,0.02,0.1\r\n");
}

TEST_CASE("the plot has every series and a line to compare with") {
  const std::string script = growth_script(made_up(), true);
  CHECK_THAT(script, ContainsSubstring("$s0 << END\n1 0.5\n10 5\n100 500\nEND\n"));
  CHECK_THAT(script, ContainsSubstring("$s1 << END\n1 0.02\nEND\n"));
  CHECK_THAT(script, ContainsSubstring("pngcairo"));
  CHECK_THAT(growth_script(made_up(), false), ContainsSubstring("terminal svg"));
}

TEST_CASE("spheres and lights are as many as asked, and look equally large together") {
  double first = 0;
  for (const int count : {10, 1000, 10000}) {
    const SceneText scene = parse_scene_text(spheres_in_view(count), "spheres");
    CHECK(scene.spheres.size() == static_cast<std::size_t>(count));
    double area = 0;
    for (const SphereText& sphere : scene.spheres) {
      area += std::pow(std::stod(sphere.radius.text) / std::stod(sphere.center[2].text), 2);
    }
    if (first == 0) first = area;
    CHECK(std::abs(area / first - 1) < 0.02);
    const certified::Renderer renderer(scene, reference::ambient);
    CHECK(renderer.plan().spheres.size() == static_cast<std::size_t>(count));
  }
  CHECK(parse_scene_text(under_lights(10000), "lights").lights.size() == 10001);
}
