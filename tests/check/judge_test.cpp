#include "judge.hpp"

#include <cmath>
#include <limits>

#include "catch2.hpp"
#include "report.hpp"

using namespace fos;

namespace {

constexpr int step = -40;
std::int64_t quanta(double term) { return std::llround(std::ldexp(term, -step)); }

/// Four pixels: background; sphere 1 with I = 0.2 + 0.5 + 0.25; sphere 1 or, at float, background;
/// sphere 2 with I far over 1.
reference::Reference made_up() {
  reference::Reference reference;
  reference.scene_text =
      "canvas_size = 4 x 1\nbackground_color = (1, 2, 3)\n"
      "sphere { center = (0, 0, 3) radius = 1 color = (200, 100, 0) }\n"
      "sphere { center = (5, 0, 3) radius = 1 color = (255, 100, 10) }\n"
      "light { type = ambient intensity = 0.2 }\n"
      "light { type = point intensity = 1 position = (0, 0, 0) }\n"
      "light { type = directional intensity = 1 direction = (0, 0, 1) }\n";
  reference.width = 4;
  reference.height = 1;
  reference.step = step;
  reference.pixels.resize(4);
  // Widths: code w means 2^(step + w - 1). Float 2^-20, double 2^-40.
  const std::array<reference::WidthCodes, 2> widths{reference::WidthCodes{21, 21},
                                                    reference::WidthCodes{1, 1}};
  reference.pixels[1] = {1, quanta(0.5), quanta(0.25), widths};
  reference.pixels[2] = {1, quanta(0.5), quanta(0.25), widths};
  reference.pixels[3] = {2, quanta(2), quanta(0), widths};
  reference.ambiguous[0].push_back({2, true, {{0, 0, 0, {}}}});
  return reference;
}

constexpr unsigned all_terms = ambient_term | point_term | directional_term;

Frame right_frame(Precision precision) {
  Frame frame;
  frame.header = {4, 1, precision};
  frame.append({{1, 2, 3, 190, 95, 0, 190, 95, 0, 561, 220, 22}, {0, 0, 0, 0}});
  return frame;
}

const Judge& judge() {
  static const Judge combined(made_up(), all_terms);
  return combined;
}

/// The verdict on the right frame with one channel changed.
Verdict with(std::size_t channel, long double value, Precision precision = Precision::binary64) {
  Frame frame = right_frame(precision);
  frame.channels[channel] = value;
  return judge().judge(frame);
}

}  // namespace

TEST_CASE("the right frame passes at every precision, without a note") {
  for (const Precision precision :
       {Precision::binary32, Precision::binary64, Precision::extended}) {
    const Verdict verdict = judge().judge(right_frame(precision));
    CHECK(verdict.passes());
    CHECK(verdict.only_float.pixels == 0);
  }
}

TEST_CASE("terms are summed as the stage has them") {
  Frame frame = right_frame(Precision::binary64);
  const auto passes = [&](unsigned terms, long double I) {
    for (const std::size_t pixel : {std::size_t{1}, std::size_t{2}}) {
      frame.channels[3 * pixel] = 200 * I;
      frame.channels[3 * pixel + 1] = 100 * I;
    }
    // The last pixel has a point term, and is right where that counts.
    const long others = (terms & point_term) != 0 ? 0 : 1;
    return Judge(made_up(), terms).judge(frame).wrong.pixels == others;
  };
  CHECK(passes(0, 1.0L));
  CHECK(passes(ambient_term, 0.2L));
  CHECK(passes(ambient_term | point_term, 0.7L));
  CHECK_FALSE(passes(ambient_term | point_term, 0.71L));
  CHECK(passes(ambient_term | directional_term, 0.45L));
  CHECK_FALSE(passes(ambient_term, 0.45L));
}

TEST_CASE("a channel is right within its interval and wrong outside") {
  // w = 2 (2^-40 + 2^-40) in double, times 200: about 7e-10; 2 (2^-20 + 2^-20) in float: 7.6e-4.
  CHECK(with(3, 190 + 5e-10L).passes());
  CHECK(with(3, 190 - 5e-10L).only_float.pixels == 0);
  const Verdict coarse = with(3, 190 + 5e-4L);
  CHECK(coarse.passes());
  CHECK(coarse.only_float.pixels == 1);
  CHECK(coarse.only_float.first.column == 1);
  CHECK(with(3, 190 + 5e-4L, Precision::binary32).only_float.pixels == 0);
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const Verdict wrong = with(3, 190 + 1e-2L, precision);
    CHECK_FALSE(wrong.passes());
    CHECK(wrong.wrong.pixels == 1);
  }
}

TEST_CASE("a channel of 0 and the background have no room") {
  CHECK_FALSE(with(5, 1e-6L).passes());
  CHECK_FALSE(with(0, 1.001L).passes());
}

TEST_CASE("an alternative is right at its precision only") {
  Frame frame = right_frame(Precision::binary32);
  for (std::size_t i = 0; i < 3; ++i) frame.channels[6 + i] = frame.channels[i];
  CHECK(judge().judge(frame).passes());
  frame.header.precision = Precision::binary64;
  const Verdict verdict = judge().judge(frame);
  CHECK(verdict.passes());
  CHECK(verdict.only_float.pixels == 1);
  for (std::size_t i = 0; i < 3; ++i) frame.channels[3 + i] = frame.channels[i];
  CHECK(judge().judge(frame).wrong.pixels == 1);
}

TEST_CASE("above 255 there is only white, below 0 there is no black") {
  CHECK(with(9, 255).passes());
  CHECK(with(9, 1e9L).passes());
  CHECK_FALSE(with(9, 254.9L).passes());
  CHECK_FALSE(with(10, 221).passes());
  CHECK_FALSE(with(5, -1).passes());
}

TEST_CASE("what is not finite is found first, and never right") {
  for (const long double value : {std::numeric_limits<long double>::quiet_NaN(),
                                  std::numeric_limits<long double>::infinity()}) {
    const Verdict verdict = with(9, value);
    CHECK_FALSE(verdict.passes());
    CHECK(verdict.not_finite.pixels == 1);
    CHECK(verdict.not_finite.first.column == 3);
    CHECK(verdict.wrong.pixels == 0);
  }
}

TEST_CASE("an unwritten pixel is not right, even with the right color") {
  Frame frame = right_frame(Precision::binary64);
  frame.unwritten[0] = 1;
  const Verdict verdict = judge().judge(frame);
  CHECK_FALSE(verdict.passes());
  CHECK(verdict.unwritten.pixels == 1);
}

TEST_CASE("where the derivation says nothing, anything finite passes and is counted") {
  reference::Reference reference = made_up();
  reference.ambiguous[1].push_back({1, false, {}});
  const Judge lenient(reference, all_terms);
  Frame frame = right_frame(Precision::binary64);
  frame.channels[3] = 7;
  CHECK(lenient.judge(frame).passes());
  CHECK(lenient.judge(frame).not_judged.pixels == 1);
  frame.channels[3] = std::numeric_limits<long double>::quiet_NaN();
  CHECK_FALSE(lenient.judge(frame).passes());
}

TEST_CASE("a verdict in words names the pixel, what was expected and what came") {
  setenv("FOS_LANG", "en", 1);
  Frame frame = right_frame(Precision::binary64);
  frame.channels[4] = 30.25L;
  const std::string words = describe(judge(), frame, judge().judge(frame), "made up");
  CHECK_THAT(words,
             ContainsSubstring("made up: 1 of 4 pixels are wrong; the first is column 1, row 0"));
  CHECK_THAT(words, ContainsSubstring("expected  (190, 95, 0)  bytes 190 95 0  (sphere 1)"));
  CHECK_THAT(words, ContainsSubstring("came      (190, 30.25, 0)  bytes 190 30 0"));
  CHECK(describe(judge(), right_frame(Precision::binary64),
                 judge().judge(right_frame(Precision::binary64)), "made up")
            .empty());
}
