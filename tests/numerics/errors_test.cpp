// How errors are counted, for canvases, for frames that say neither sphere nor I, and for bytes.
#include "errors.hpp"

#include "catch2.hpp"

using namespace fos;
using namespace fos::numerics;

namespace {

// Background white, a red sphere, a grey one, a black one.
const Colors colors{{255, 255, 255}, {255, 10, 0}, {100, 100, 100}, {0, 0, 0}};

TruePixel truth_at(int sphere, long double I) {
  TruePixel pixel{sphere, {I, 0}, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const long double channel = colors[static_cast<std::size_t>(sphere)][i];
    pixel.bytes[i] = to_byte(sphere == 0 ? channel : channel * I);
  }
  return pixel;
}

Truth truth(std::vector<TruePixel> pixels) {
  const int width = static_cast<int>(pixels.size());
  return {width, 1, std::move(pixels)};
}

Frame frame(const std::vector<std::array<long double, 3>>& pixels) {
  Frame out;
  out.header = {static_cast<int>(pixels.size()), 1, Precision::binary64};
  for (const auto& pixel : pixels)
    out.channels.insert(out.channels.end(), pixel.begin(), pixel.end());
  return out;
}

}  // namespace

TEST_CASE("a canvas: right, off, another sphere, no number") {
  Canvas<double> canvas(5, 1);
  canvas.sphere = {1, 1, 2, 0, 1};
  canvas.I = {0.5, 0.25, 0.5, 99, std::numeric_limits<double>::quiet_NaN()};
  const Errors errors = errors_of(canvas,
                                  truth({truth_at(1, 0.5L), truth_at(1, 0.5L), truth_at(1, 0.5L),
                                         truth_at(0, 1), truth_at(1, 0.5L)}),
                                  colors);
  CHECK(errors.wrong_spheres == 1);
  CHECK(errors.wrong_bytes == 3);
  CHECK(errors.not_finite == 1);
  CHECK(errors.I->max == 0.25L);
  CHECK(errors.I->mean == 0.125L);  // of the two right spheres; the background has no I
}

TEST_CASE("an error beyond the digits of long double's first part is seen") {
  Canvas<long double> canvas(1, 1);
  canvas.sphere = {1};
  canvas.I = {0.5L};
  Truth exact = truth({truth_at(1, 0.5L)});
  exact.pixels[0].I.low = 1e-25L;
  CHECK(errors_of(canvas, exact, colors).I->max == 1e-25L);
}

TEST_CASE("99 of 100") {
  Canvas<double> canvas(200, 1);
  std::vector<TruePixel> pixels;
  for (std::size_t i = 0; i < 200; ++i) {
    canvas.sphere[i] = 1;
    canvas.I[i] = i < 2 ? 0.75 : 0.5;
    pixels.push_back(truth_at(1, 0.5L));
  }
  const Errors errors = errors_of(canvas, truth(pixels), colors);
  CHECK(errors.I->max == 0.25L);
  CHECK(errors.I->percentile_99 == 0.25L);
  canvas.I[1] = 0.5;
  CHECK(errors_of(canvas, truth(pixels), colors).I->percentile_99 == 0);
}

TEST_CASE("intervals: half their width; open is not wrong, wrong is") {
  Canvas<IntervalNumber> canvas(4, 1);
  canvas.sphere = {1, -1, 1, 1};
  canvas.I = {{0.5, 0.5 + 0x1p-20}, {}, {0.4, 0.6}, {0.7, 0.7}};
  const Errors errors = errors_of(
      canvas, truth({truth_at(1, 0.5L), truth_at(1, 0.5L), truth_at(1, 0.5L), truth_at(1, 0.5L)}),
      colors);
  CHECK(errors.open_spheres == 1);
  CHECK(errors.open_bytes == 2);
  CHECK(errors.wrong_bytes == 1);
  CHECK(errors.I->max == (static_cast<long double>(0.6) - 0.4) / 2);
}

TEST_CASE("a frame: I comes back from the brightest channel") {
  const Errors errors = errors_of(frame({{127.5L, 5, 0}, {128.0L, 128.0L * 10 / 255, 0}}),
                                  truth({truth_at(1, 0.5L), truth_at(1, 0.5L)}), colors);
  CHECK(errors.wrong_spheres == 0);
  CHECK_THAT(static_cast<double>(errors.I->max), WithinAbs(0.5 / 255, 1e-15));
}

TEST_CASE("a frame: what is not the sphere's color times a number is another sphere") {
  const Errors errors = errors_of(
      frame({{50, 50, 50}, {255, 255, 255}, {127.5L, 6, 0}, {255, 255, 255}, {0, 0, 0}, {9, 0, 0}}),
      truth({truth_at(1, 0.5L), truth_at(1, 0.5L), truth_at(1, 0.5L), truth_at(2, 0.5L),
             truth_at(3, 0.5L), truth_at(0, 1)}),
      colors);
  // Grey, white and a wrong green for red; the white background for grey; not the black; red for
  // background.
  CHECK(errors.wrong_spheres == 5);
  CHECK(errors_of(frame({{255, 255, 255}}), truth({truth_at(0, 1)}), colors).wrong_spheres == 0);
  const long double nan = std::numeric_limits<long double>::quiet_NaN();
  CHECK(errors_of(frame({{nan, 0, 0}}), truth({truth_at(1, 1)}), colors).not_finite == 1);
}

TEST_CASE("bytes") {
  const Truth right = truth({truth_at(1, 0.5L), truth_at(0, 1)});
  CHECK(errors_of({128, 5, 0, 255, 255, 255}, right).wrong_bytes == 0);
  CHECK(errors_of({128, 5, 0, 255, 255, 254}, right).wrong_bytes == 1);
  CHECK_FALSE(errors_of({128, 5, 0, 255, 255, 255}, right).I);
}
