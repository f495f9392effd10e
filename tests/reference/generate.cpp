#include "generate.hpp"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "stored_terms.hpp"

namespace fos::reference {
namespace {

constexpr int bits_of_terms = 40;
constexpr int step_refinement = 6;
constexpr int refinements = 2;
constexpr int thread_count = 2;

/// Terms and widths at such steps are normal doubles with much room on both sides.
constexpr int min_step = -900;
constexpr int max_step = 500;

using Row = std::vector<PixelTruth>;

std::vector<Row> certify_rows(const ExactScene& scene, const PixelSource& truth) {
  std::vector<Row> rows(static_cast<std::size_t>(scene.height));
  std::vector<std::exception_ptr> failures(rows.size());
  const auto certify_every_other = [&](int first) {
    for (int row = first; row < scene.height; row += thread_count) {
      const auto i = static_cast<std::size_t>(row);
      try {
        rows[i].reserve(static_cast<std::size_t>(scene.width));
        for (int column = 0; column < scene.width; ++column) {
          rows[i].push_back(truth(column, row));
        }
      } catch (...) {
        failures[i] = std::current_exception();
        return;
      }
    }
  };
  std::thread other(certify_every_other, 1);
  certify_every_other(0);
  other.join();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
  return rows;
}

Reference assemble(const SceneText& scene, int step, std::vector<Row> rows) {
  Reference reference{scene.source, scene.canvas_width, scene.canvas_height, step, {}, {}};
  for (Row& row : rows) {
    for (PixelTruth& truth : row) {
      reference.pixels.push_back(truth.pixel);
      for (std::size_t i = 0; i < precisions.size(); ++i) {
        if (truth.ambiguous[i]) reference.ambiguous[i].push_back(*std::move(truth.ambiguous[i]));
      }
    }
  }
  return reference;
}

}  // namespace

int coarsest_step(const ExactScene& scene) {
  mpq_class point_sum;
  mpq_class directional_sum;
  for (const ExactLight& light : scene.lights) {
    (light.is_point ? point_sum : directional_sum) += light.intensity;
  }
  const mpq_class brightest = std::max(point_sum, directional_sum);
  if (brightest == 0) return -bits_of_terms;
  // The smallest exponent with brightest <= 2^exponent.
  int exponent = static_cast<int>(mpz_sizeinbase(brightest.get_num_mpz_t(), 2)) -
                 static_cast<int>(mpz_sizeinbase(brightest.get_den_mpz_t(), 2)) - 1;
  while (times_power_of_two(1, exponent) < brightest) ++exponent;
  const int step = exponent - bits_of_terms;
  if (step < min_step || step > max_step) {
    throw std::range_error("the lights are too bright or too dark for a double");
  }
  return step;
}

Reference generate(const SceneText& text) {
  return generate(text, [](const ExactScene& scene, int step) {
    return [oracle = std::make_shared<const Oracle>(scene, step)](int column, int row) {
      return oracle->truth(column, row);
    };
  });
}

Reference generate(const SceneText& text, const MakePixelSource& make_source) {
  if (text.canvas_width > max_pixels / text.canvas_height) {
    throw std::range_error("the canvas has more pixels than a reference may have");
  }
  const ExactScene scene = to_exact(text);
  int step = coarsest_step(scene);
  for (int i = 0; i < refinements; ++i, step -= step_refinement) {
    try {
      return assemble(text, step, certify_rows(scene, make_source(scene, step)));
    } catch (const StepError&) {
    }
  }
  return assemble(text, step, certify_rows(scene, make_source(scene, step)));
}

}  // namespace fos::reference
