// The tracer that makes mistakes as a stage, for the page that switches one on.
#include <cstddef>
#include <optional>

#include "figure.hpp"
#include "fos/stage.hpp"
#include "mistaken_tracer.hpp"

namespace fos {

Color trace_ray(const Vec3& O, const Vec3& D, Real t_min, Real t_max, const Scene& scene) {
  struct Chosen {
    int mistake;
    unsigned terms;
    const Scene* scene;
    bool operator==(const Chosen&) const = default;
  };
  static std::optional<Chosen> made;
  static std::optional<MistakenTracer<Real, Scene>> tracer;
  const Chosen chosen{shown_figure().mistake, shown_figure().terms, &scene};
  if (made != chosen) {
    MistakeSet mistakes;
    const auto number = static_cast<std::size_t>(chosen.mistake);
    if (0 < number && number <= misconceptions().size()) {
      mistakes.add(misconceptions()[number - 1].mistake);
    }
    tracer.emplace(scene, chosen.terms, mistakes);
    made = chosen;
  }
  return tracer->trace(O, D, t_min, t_max).color;
}

}  // namespace fos
