#include "right_answers.hpp"

#include <algorithm>
#include <stdexcept>

#include "generate.hpp"
#include "oracle.hpp"
#include "scene_source.hpp"

namespace fos {
namespace {

using reference::ExactScene;
using reference::Possible;

constexpr std::array<mpfr_prec_t, reference::precisions.size()> significand_bits{24, 53};

/// As reference::generate refines it where a pixel is too close to call.
constexpr int step_refinement = 6;
constexpr int refinements = 2;

/// D = (-1/2 Vw / 1, -1/2 Vh / 1, d): a viewport that no scene file may have, and exact.
void put_on_one_pixel(ExactScene& scene, const reference::Triple<mpq_class>& D) {
  scene.width = scene.height = 1;
  scene.viewport_width = -2 * D[0];
  scene.viewport_height = -2 * D[1];
}

/// A dim light alone may be beyond what doubles carry, and yet be no trouble among the others.
int step_for(const ExactScene& scene, const ExactScene& all_lights) {
  try {
    return reference::coarsest_step(scene);
  } catch (const std::range_error&) {
    return reference::coarsest_step(all_lights);
  }
}

/// The same with the terms of these lights only (indices in ExactScene::lights).
Possible with_terms(const Possible& all, std::span<const std::size_t> lights) {
  Possible some{true, all.background, {}};
  for (const reference::PossibleHit& hit : all.hits) {
    reference::PossibleHit& same = some.hits.emplace_back();
    same.sphere = hit.sphere;
    same.sign = hit.sign;
    for (const std::size_t i : lights) {
      same.terms.push_back(hit.terms[i]);
      some.judged &= hit.terms[i].is_bounded();
    }
  }
  return some;
}

}  // namespace

RightAnswers::RightAnswers(const SceneText& scene, int column, int row)
    : scene_(scene), exact_(reference::to_exact(scene)) {
  const reference::Triple<mpq_class> D = reference::exact_direction(exact_, column, row);
  hit_ = reference::exact_hit(exact_, D);
  for (std::size_t i = 0; i < possible_.size(); ++i) {
    // On the scene's own canvas: what rounding makes of D is part of it.
    possible_[i] = reference::RoundedScene(exact_, significand_bits[i]).possible(column, row);
  }
  put_on_one_pixel(exact_, D);
}

Judge RightAnswers::judge(std::span<const std::size_t> lights, unsigned terms) const {
  ExactScene scene = exact_;
  scene.ambient = 0;
  scene.lights.clear();
  std::vector<std::size_t> others;  // in ExactScene::lights, which has no ambient one
  std::size_t next = 0;
  for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
    const bool is_ambient = scene_.lights[i].kind == LightKind::ambient;
    if (std::find(lights.begin(), lights.end(), i) != lights.end()) {
      if (is_ambient) {
        scene.ambient = exact_.ambient;
      } else {
        scene.lights.push_back(exact_.lights[next]);
        others.push_back(next);
      }
    }
    if (!is_ambient) ++next;
  }
  const std::array<Possible, reference::precisions.size()> possible{
      with_terms(possible_[0], others), with_terms(possible_[1], others)};

  reference::Reference reference;
  reference.scene_text = with_lights(scene_, lights).source;
  reference.width = reference.height = 1;
  reference.step = step_for(scene, exact_);
  reference::PixelTruth truth;
  for (int i = 0;; ++i, reference.step -= step_refinement) {
    try {
      truth = reference::Oracle(scene, reference.step).truth(0, 0, hit_, possible);
      break;
    } catch (const reference::StepError&) {
      if (i == refinements) throw;
    }
  }
  reference.pixels.push_back(truth.pixel);
  for (std::size_t i = 0; i < truth.ambiguous.size(); ++i) {
    if (truth.ambiguous[i]) reference.ambiguous[i].push_back(*truth.ambiguous[i]);
  }
  return {std::move(reference), terms};
}

}  // namespace fos
