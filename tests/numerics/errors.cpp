#include "errors.hpp"

#include <algorithm>
#include <cmath>

#include "fos/nearest.hpp"

namespace fos::numerics {
namespace {

using Color = std::array<long double, 3>;
using Bytes = std::array<std::uint8_t, 3>;

/// Gathers errors pixel by pixel.
class Tally {
 public:
  void add_error(long double error) { errors_of_I_.push_back(error); }

  Errors result() {
    ErrorsOfI& I = errors.I.emplace();
    if (errors_of_I_.empty()) return errors;
    const auto last = static_cast<double>(errors_of_I_.size() - 1);
    const auto place = errors_of_I_.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * last));
    std::nth_element(errors_of_I_.begin(), place, errors_of_I_.end());
    I.percentile_99 = *place;
    I.max = *std::max_element(place, errors_of_I_.end());
    for (const long double error : errors_of_I_) I.mean += error;
    I.mean /= static_cast<long double>(errors_of_I_.size());
    return errors;
  }

  Errors errors;

 private:
  std::vector<long double> errors_of_I_;
};

Bytes to_bytes(const Color& channels) {
  return {to_byte(channels[0]), to_byte(channels[1]), to_byte(channels[2])};
}

bool is_finite(const Color& color) {
  return std::isfinite(color[0]) && std::isfinite(color[1]) && std::isfinite(color[2]);
}

/// color × I, each product rounded to T.
template <class T>
Color product(const Color& color, T I) {
  Color result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const T channel = static_cast<T>(color[i]) * I;
    result[i] = channel;
  }
  return result;
}

long double distance(long double I, const Wide& truth) {
  return std::abs((I - truth.high) - truth.low);
}

}  // namespace

template <class T>
Colors colors_of(const SceneText& scene) {
  Colors colors;
  const auto add = [&](const DecimalTriple& color) {
    colors.push_back({nearest<T>(color[0]), nearest<T>(color[1]), nearest<T>(color[2])});
  };
  add(scene.background_color);
  for (const SphereText& sphere : scene.spheres) add(sphere.color);
  return colors;
}

template <class T>
Errors errors_of(const Canvas<T>& canvas, const Truth& truth, const Colors& colors) {
  Tally tally;
  for (std::size_t i = 0; i < canvas.size(); ++i) {
    const TruePixel& right = truth.pixels[i];
    const std::int32_t sphere = canvas.sphere[i];
    const T I = sphere == 0 ? T{1} : canvas.I[i];
    if (sphere != right.sphere) ++tally.errors.wrong_spheres;
    const Color channels = product(colors[static_cast<std::size_t>(sphere)], I);
    if (!std::isfinite(I) || !is_finite(channels)) {
      ++tally.errors.not_finite;
      ++tally.errors.wrong_bytes;
      continue;
    }
    if (to_bytes(channels) != right.bytes) ++tally.errors.wrong_bytes;
    if (sphere == right.sphere && sphere != 0) tally.add_error(distance(I, right.I));
  }
  return tally.result();
}

template Colors colors_of<float>(const SceneText&);
template Colors colors_of<double>(const SceneText&);
template Colors colors_of<long double>(const SceneText&);
template Errors errors_of(const Canvas<float>&, const Truth&, const Colors&);
template Errors errors_of(const Canvas<double>&, const Truth&, const Colors&);
template Errors errors_of(const Canvas<long double>&, const Truth&, const Colors&);

Errors errors_of(const Canvas<IntervalNumber>& canvas, const Truth& truth, const Colors& colors) {
  Tally tally;
  for (std::size_t i = 0; i < canvas.size(); ++i) {
    const TruePixel& right = truth.pixels[i];
    const std::int32_t sphere = canvas.sphere[i];
    if (sphere < 0) {
      ++tally.errors.open_spheres;
      ++tally.errors.open_bytes;
      continue;
    }
    if (sphere != right.sphere) ++tally.errors.wrong_spheres;
    const IntervalNumber I = sphere == 0 ? IntervalNumber(1) : canvas.I[i];
    if (!I.is_finite()) {
      ++tally.errors.not_finite;
      ++tally.errors.open_bytes;
      continue;
    }
    const Color& color = colors[static_cast<std::size_t>(sphere)];
    const long double low = I.low();
    const long double high = I.high();
    const Bytes bytes = to_bytes(product(color, low));
    if (bytes != to_bytes(product(color, high))) {
      ++tally.errors.open_bytes;
    } else if (bytes != right.bytes) {
      ++tally.errors.wrong_bytes;
    }
    if (sphere == right.sphere && sphere != 0) tally.add_error((high - low) / 2);
  }
  return tally.result();
}

Errors errors_of(const Frame& frame, const Truth& truth, const Colors& colors) {
  const long double unit = frame.header.precision == Precision::binary32   ? 0x1p-23L
                           : frame.header.precision == Precision::binary64 ? 0x1p-52L
                                                                           : 0x1p-63L;
  Tally tally;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const TruePixel& right = truth.pixels[i];
    const Color channels{frame.channels[3 * i], frame.channels[3 * i + 1],
                         frame.channels[3 * i + 2]};
    if (!is_finite(channels)) {
      ++tally.errors.not_finite;
      ++tally.errors.wrong_bytes;
      continue;
    }
    const bool bytes_right = to_bytes(channels) == right.bytes;
    if (!bytes_right) ++tally.errors.wrong_bytes;
    const Color& color = colors[static_cast<std::size_t>(right.sphere)];
    const auto brightest =
        static_cast<std::size_t>(std::max_element(color.begin(), color.end()) - color.begin());
    const bool black = color[brightest] == 0;
    const long double I = right.sphere == 0 || black ? 1 : channels[brightest] / color[brightest];
    bool consistent = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double expected = color[k] * I;
      // The color and the product were rounded, and so was the brightest channel.
      if (std::abs(channels[k] - expected) > 8 * unit * std::abs(expected)) consistent = false;
    }
    // White is also the color of a white background.
    if (right.sphere != 0 && !bytes_right && channels == colors[0]) consistent = false;
    if (!consistent) {
      ++tally.errors.wrong_spheres;
    } else if (right.sphere != 0 && !black) {
      tally.add_error(distance(I, right.I));
    }
  }
  return tally.result();
}

Errors errors_of(const std::vector<std::uint8_t>& rgb, const Truth& truth) {
  Errors errors;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const Bytes& right = truth.pixels[i].bytes;
    if (!std::equal(right.begin(), right.end(), rgb.begin() + static_cast<std::ptrdiff_t>(3 * i))) {
      ++errors.wrong_bytes;
    }
  }
  return errors;
}

}  // namespace fos::numerics
