#include "fos/scene_text.hpp"

#include <filesystem>
#include <fstream>

#include "catch2.hpp"

using namespace fos;

namespace {

/// The first line of what is said about a wrong scene, or "" for a valid one.
std::string error_in(std::string_view source) {
  setenv("FOS_LANG", "en", 1);
  try {
    parse_scene_text(source, "f");
    return "";
  } catch (const SceneError& error) {
    const std::string what = error.what();
    return what.substr(0, what.find('\n'));
  }
}

constexpr const char* sphere = "sphere { center = (0, 0, 3) radius = 1 color = (1, 2, 3) }\n";

}  // namespace

TEST_CASE("a scene is read, in the order of the file") {
  const SceneText scene = parse_scene_text(
      "canvas_size = 30 x 20 viewport_size = 1.5 x 1\n"
      "projection_plane_d = 2  camera_position = (1, -2, .5)\n"
      "sphere { color = (10, 20.5, 255) radius = 5. center = (-1, 0, 3e1) } # comment\n"
      "light { intensity = 0.2 type = ambient }\n"
      "light { type = directional direction = (0, -1, 0) intensity = 1 }\n"
      "light { type = point intensity = 0 position = (2, 1, 0) }\n"
      "background_color = (0, 0, 0)",
      "f");
  CHECK(scene.canvas_width == 30);
  CHECK(scene.canvas_height == 20);
  CHECK(scene.viewport_size[0].text == "1.5");
  CHECK(scene.projection_plane_d.text == "2");
  CHECK(scene.camera_position[2].text == ".5");
  CHECK(scene.background_color[0].is_zero());
  REQUIRE(scene.spheres.size() == 1);
  CHECK(scene.spheres[0].center[2].text == "3e1");
  CHECK(scene.spheres[0].radius.place.line == 3);
  CHECK(scene.spheres[0].radius.place.column == 43);
  CHECK(scene.spheres[0].color[1].text == "20.5");
  REQUIRE(scene.lights.size() == 3);
  CHECK(scene.lights[0].kind == LightKind::ambient);
  CHECK(scene.lights[1].kind == LightKind::directional);
  CHECK(scene.lights[1].vector[1].negative);
  CHECK(scene.lights[2].kind == LightKind::point);
}

TEST_CASE("an empty file is a valid scene with the defaults") {
  const SceneText scene = parse_scene_text("", "f");
  CHECK(scene.canvas_width == 600);
  CHECK(scene.canvas_height == 600);
  CHECK(scene.viewport_size[0].text == "1");
  CHECK(scene.camera_position[0].is_zero());
  CHECK(scene.background_color[1].text == "255");
  CHECK(scene_warnings(scene).size() == 2);
}

TEST_CASE("white space, comments, line ends and a byte-order mark are free") {
  CHECK(error_in("\xEF\xBB\xBF# Σκηνή\r\n\r\nsphere\r\n{center=(0,0,3)radius=1 color=(1,2,3)}")
            .empty());
  CHECK(error_in("canvas_size=1x1# at the end of the file").empty());
  CHECK(error_in("canvas_size\t=\n16384 # κόμμα\n x # x\n 1e0").empty());
}

TEST_CASE("each wrong file is told by line and column, and what would be right") {
  struct Case {
    std::string source, error;
  };
  const std::string s = sphere;
  const Case cases[] = {
      {"light { type = point intensty = 3 }",
       "f:1:22: error: unknown key 'intensty'; did you mean 'intensity'?"},
      {"colour = 3",
       "f:1:1: error: unknown key 'colour'; there is: canvas_size, viewport_size, "
       "projection_plane_d, camera_position, background_color"},
      {"\n  spheer { }", "f:2:3: error: unknown block 'spheer'; did you mean 'sphere'?"},
      {"light { type = ambient intensity = 1 }\nlight { type = ambient intensity = 1 }",
       "f:2:1: error: a second ambient light; the first is in line 1: there is one I_A, so add the "
       "intensities"},
      {"sphere { radius = 1 radius = 2 }",
       "f:1:21: error: 'radius' is given twice; the first is in "
       "line 1"},
      {"canvas_size = 1 x 1\n\ncanvas_size = 2 x 2",
       "f:3:1: error: 'canvas_size' is given twice; the first is in line 1"},
      {"sphere { center = (0, 0, 3) radius = 1 }", "f:1:1: error: this sphere has no 'color'"},
      {"light { intensity = 1 }", "f:1:1: error: this light has no 'type'"},
      {"light { type = point intensity = 1 }", "f:1:1: error: this light has no 'position'"},
      {"light { type = ambient intensity = 1 position = (0, 0, 0) }",
       "f:1:38: error: a light of type ambient has no 'position'"},
      {"light { type = point intensity = 1 position = (0, 0, 0) direction = (0, 0, 1) }",
       "f:1:57: error: a light of type point has no 'direction'"},
      {"light { type = spot }",
       "f:1:16: error: unknown type of light 'spot'; there is: ambient, point, directional"},
      {"light { type = 3 }", "f:1:16: error: 'type' is one of: ambient, point, directional"},
      {"projection_plane_d = 0", "f:1:22: error: 'projection_plane_d' must be greater than 0"},
      {"viewport_size = 1 x -1", "f:1:21: error: 'viewport_size' must be greater than 0"},
      {"sphere { center = (0, 0, 3) radius = -0.5 color = (1, 2, 3) }",
       "f:1:38: error: 'radius' must be greater than 0"},
      {"light { type = ambient intensity = -1e-9 }",
       "f:1:36: error: 'intensity' must not be negative: light only adds"},
      {"background_color = (0, 0, 255.0000000000000000000001)",
       "f:1:27: error: a channel of 'background_color' is between 0 and 255"},
      {"background_color = (0, -1, 0)",
       "f:1:24: error: a channel of 'background_color' is between 0 and 255"},
      {"light { type = directional intensity = 1 direction = (0, -0.0, 0e5) }",
       "f:1:55: error: 'direction' must not be (0, 0, 0): it points from the surface toward the "
       "light"},
      {"canvas_size = 0 x 1", "f:1:15: error: 'canvas_size' is two whole numbers from 1 to 16384"},
      {"canvas_size = 1 x 16385",
       "f:1:19: error: 'canvas_size' is two whole numbers from 1 to 16384"},
      {"canvas_size = 1.5 x 1",
       "f:1:15: error: 'canvas_size' is two whole numbers from 1 to 16384"},
      {"canvas_size = 600", "f:1:15: error: 'canvas_size' is a size, such as 600 x 600"},
      {"camera_position = 1",
       "f:1:19: error: 'camera_position' is three numbers, such as (0, -1, 3)"},
      {"projection_plane_d = (1, 2, 3)",
       "f:1:23: error: 'projection_plane_d' is one number, such as 0.6"},
      {"projection_plane_d = nan",
       "f:1:22: error: 'projection_plane_d' is one number, such as 0.6"},
      {"camera_position = (1, 2)",
       "f:1:24: error: expected three numbers in brackets with commas "
       "between them, such as (0, -1, 3)"},
      {"camera_position = (1, 2, 3, 4)",
       "f:1:27: error: expected three numbers in brackets with "
       "commas between them, such as (0, -1, 3)"},
      {"canvas_size = 600 x",
       "f:1:20: error: expected the second number of a size, such as 600 x 600"},
      {"projection_plane_d = 1.2.3",
       "f:1:22: error: '1.2.3' is not a number: write 12, -0.5 or 1.5e3"},
      {"projection_plane_d = 1e9999",
       "f:1:22: error: this number has too many digits or too large an exponent: at most 400 "
       "characters and 5000"},
      {"projection_plane_d = 0,5",
       "f:1:23: error: unexpected ',': decimals are written with a point "
       "(0.5), and nothing separates settings"},
      {"projection_plane_d 1", "f:1:20: error: expected '=' or '{' after 'projection_plane_d'"},
      {s + "light { type ambient }", "f:2:14: error: expected '=' after 'type'"},
      {"light { type = }",
       "f:1:16: error: expected a value for 'type': a number, a size such as 600 x "
       "600, three numbers (x, y, z), or a word"},
      {s + "light {\n  type = ambient\n", "f:4:1: error: expected a key or '}'"},
      {s + "}",
       "f:2:1: error: expected a setting such as 'canvas_size = 600 x 600', or 'sphere {' or "
       "'light {'"},
      {"# σχόλιο\n# ελληνικά: \xFF",
       "f:2:13: error: byte 0xFF is not text: a scene file is UTF-8 text"},
      {std::string("a\0b", 3), "f:1:2: error: byte 0x00 is not text: a scene file is UTF-8 text"},
      {std::string(max_scene_bytes + 1, ' '),
       "f:1:1: error: the file is over 1 MiB: no scene needs that much"},
  };
  for (const Case& each : cases) {
    INFO(each.source.substr(0, 100));
    CHECK(error_in(each.source) == each.error);
  }
}

TEST_CASE("the line is shown with a caret under the character, not the byte") {
  setenv("FOS_LANG", "en", 1);
  try {
    parse_scene_text("# γραμμή\n\tlight { type = αβγ }", "σκηνή.scene");
    FAIL("not refused");
  } catch (const SceneError& error) {
    CHECK(
        std::string(error.what()) ==
        "σκηνή.scene:2:17: error: expected a value for 'type': a number, a size such as 600 x 600, "
        "three numbers (x, y, z), or a word\n"
        "   light { type = αβγ }\n"
        "                  ^");
  }
}

TEST_CASE("errors speak Greek") {
  setenv("FOS_LANG", "el", 1);
  CHECK_THROWS_WITH(parse_scene_text("light { type = point intensty = 3 }", "f"),
                    ContainsSubstring("f:1:22: σφάλμα: άγνωστο κλειδί «intensty»· μήπως εννοείς "
                                      "«intensity»;"));
  setenv("FOS_LANG", "en", 1);
}

TEST_CASE("a file that is not there, a folder, and an endless one are refused") {
  setenv("FOS_LANG", "en", 1);
  CHECK_THROWS_AS(read_scene_text("no/such.scene"), SceneError);
  CHECK_THROWS_WITH(read_scene_text(std::filesystem::temp_directory_path()),
                    ContainsSubstring("directory"));
  CHECK_THROWS_AS(read_scene_text("/dev/zero"), SceneError);
}
