#include "mistaken_answers.hpp"

#include <algorithm>
#include <cmath>

#include "scene_at.hpp"

namespace fos::grading {

MistakenAnswers::MistakenAnswers(const Stage& stage, const Diagnosis& diagnosis) : stage_(&stage) {
  for (const MistakeMade& made : diagnosis.certain) {
    if (made.where != Where::directional_lights) point_.add(made.mistake);
    if (made.where != Where::point_lights) directional_.add(made.mistake);
    if (made.where == Where::everywhere) everywhere_.add(made.mistake);
  }
}

Frame MistakenAnswers::frame_of(const SceneText& text) const {
  const SceneAt<double> scene(text);
  const bool one_kind =
      point_.list() != everywhere_.list() || directional_.list() != everywhere_.list();
  if (!one_kind) return mistaken_frame(scene, stage_->terms, everywhere_);
  // I is a sum: each kind of light by itself, and what both have is counted once.
  Frame frame = mistaken_frame(scene, stage_->terms & ~unsigned{directional_term}, point_);
  const Frame directional =
      mistaken_frame(scene, stage_->terms & ~unsigned{point_term}, directional_);
  const Frame both = mistaken_frame(scene, stage_->terms & unsigned{ambient_term}, everywhere_);
  for (std::size_t i = 0; i < frame.channels.size(); ++i) {
    frame.channels[i] += directional.channels[i] - both.channels[i];
  }
  return frame;
}

bool MistakenAnswers::gives(const SceneText& scene, const Frame& frame) const {
  const Frame expected = frame_of(scene);
  std::size_t off = 0;
  for (std::size_t i = 0; i < frame.channels.size(); ++i) {
    const long double came = std::clamp(frame.channels[i], 0.0L, 255.0L);
    const long double wanted = std::clamp(expected.channels[i], 0.0L, 255.0L);
    if (!(std::abs(came - wanted) <= 0.05L)) ++off;
  }
  return off <= frame.channels.size() / 200;
}

}  // namespace fos::grading
