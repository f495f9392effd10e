#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace fos {
namespace {

using reference::Answer;

double number(const Decimal& decimal) { return std::strtod(decimal.text.c_str(), nullptr); }

std::array<double, 3> numbers(const DecimalTriple& triple) {
  return {number(triple[0]), number(triple[1]), number(triple[2])};
}

/// u: half an ulp of 1.
double unit_roundoff(reference::Precision precision) {
  return precision == reference::Precision::float24 ? std::numeric_limits<float>::epsilon() / 2
                                                    : std::numeric_limits<double>::epsilon() / 2;
}

void count(Count& count, Pixel pixel) {
  if (count.pixels++ == 0) count.first = pixel;
}

}  // namespace

Judge::Judge(reference::Reference reference, unsigned terms)
    : reference_(std::move(reference)),
      scene_(parse_scene_text(reference_.scene_text, "scene")),
      terms_(terms) {
  colors_.push_back(numbers(scene_.background_color));
  for (const SphereText& sphere : scene_.spheres) colors_.push_back(numbers(sphere.color));
  for (const LightText& light : scene_.lights) {
    if (light.kind == LightKind::ambient) ambient_ = number(light.intensity);
  }
}

Expected Judge::expect(const Answer& answer, reference::Precision precision) const {
  const double u = unit_roundoff(precision);
  double I = 1;
  double w = 0;
  if (terms_ != 0 && answer.sphere != 0) {
    I = (terms_ & ambient_term) != 0 ? ambient_ : 0;
    if ((terms_ & point_term) != 0) {
      I += answer.point;
      w += reference::margin * answer.point_width;
    }
    if ((terms_ & directional_term) != 0) {
      I += answer.directional;
      w += reference::margin * answer.directional_width;
    }
    w += static_cast<double>(scene_.lights.size() + 2) * u * I;
  }
  Expected expected;
  expected.sphere = answer.sphere;
  for (std::size_t i = 0; i < 3; ++i) {
    const double color = colors_[static_cast<std::size_t>(answer.sphere)][i];
    expected.channels[i] = {std::min(255.0, color * std::max(0.0, I - w) * (1 - 2 * u)),
                            std::min(255.0, color * (I + w) * (1 + 2 * u))};
    expected.bytes[i] = to_byte(color * I);
  }
  return expected;
}

std::vector<Expected> Judge::expected(Pixel pixel, reference::Precision precision) const {
  const reference::Accepted accepted = reference_.accepted(pixel.column, pixel.row, precision);
  if (!accepted.judged) return {};
  std::vector<Expected> answers{expect(accepted.certified, precision)};
  for (const Answer& answer : accepted.alternatives) answers.push_back(expect(answer, precision));
  return answers;
}

bool Judge::accepts(const reference::Accepted& accepted, reference::Precision precision,
                    std::span<const long double, 3> channels) const {
  const auto lies_in = [&](const Answer& answer) {
    const Expected expected = expect(answer, precision);
    for (std::size_t i = 0; i < 3; ++i) {
      const long double channel = std::min(channels[i], 255.0L);
      if (!(expected.channels[i].low <= channel && channel <= expected.channels[i].high)) {
        return false;
      }
    }
    return true;
  };
  return !accepted.judged || lies_in(accepted.certified) ||
         std::any_of(accepted.alternatives.begin(), accepted.alternatives.end(), lies_in);
}

Judge::Judged Judge::judge(const Frame& frame, Pixel pixel) const {
  using reference::Precision;
  const auto channels = frame.pixel(pixel.column, pixel.row);
  if (!is_finite(channels)) return Judged::not_finite;
  if (frame.is_unwritten(pixel.column, pixel.row)) return Judged::unwritten;
  const bool is_float = frame.header.precision == fos::Precision::binary32;
  const auto passes_at = [&](Precision precision, bool& judged) {
    const auto accepted = reference_.accepted(pixel.column, pixel.row, precision);
    judged = accepted.judged;
    return accepts(accepted, precision, channels);
  };
  bool judged = true;
  if (passes_at(is_float ? Precision::float24 : Precision::double53, judged)) {
    return judged ? Judged::right : Judged::not_judged;
  }
  return !is_float && passes_at(Precision::float24, judged) ? Judged::right_to_float
                                                            : Judged::wrong;
}

Verdict Judge::judge(const Frame& frame) const {
  Verdict verdict;
  for (Pixel pixel; pixel.row < reference_.height; ++pixel.row) {
    for (pixel.column = 0; pixel.column < reference_.width; ++pixel.column) {
      switch (judge(frame, pixel)) {
        case Judged::right:
          break;
        case Judged::right_to_float:
          count(verdict.only_float, pixel);
          break;
        case Judged::not_judged:
          count(verdict.not_judged, pixel);
          break;
        case Judged::wrong:
          count(verdict.wrong, pixel);
          break;
        case Judged::unwritten:
          count(verdict.unwritten, pixel);
          break;
        case Judged::not_finite:
          count(verdict.not_finite, pixel);
      }
    }
  }
  return verdict;
}

void Judge::each_wrong(const Frame& frame, const std::function<void(Pixel)>& visit) const {
  for (Pixel pixel; pixel.row < reference_.height; ++pixel.row) {
    for (pixel.column = 0; pixel.column < reference_.width; ++pixel.column) {
      if (judge(frame, pixel) >= Judged::wrong) visit(pixel);
    }
  }
}

const Frame& Judge::exact() const {
  std::call_once(made_exact_, [&] { exact_ = make_exact(); });
  return exact_;
}

Frame Judge::make_exact() const {
  Frame frame;
  frame.header = {reference_.width, reference_.height, Precision::binary64};
  frame.unwritten.resize(reference_.pixels.size());
  frame.channels.reserve(3 * reference_.pixels.size());
  for (int row = 0; row < reference_.height; ++row) {
    for (int column = 0; column < reference_.width; ++column) {
      const auto certified =
          reference_.accepted(column, row, reference::Precision::double53).certified;
      const Expected expected = expect(certified, reference::Precision::double53);
      for (const Interval& channel : expected.channels) {
        frame.channels.push_back((channel.low + channel.high) / 2);
      }
    }
  }
  return frame;
}

}  // namespace fos
