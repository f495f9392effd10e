// A tracer that makes the mistakes it is told to: what each of the catalogue looks like.
//
// With no mistake it is the slides' code. Each mistake changes one line. It is written once for
// every number type and every scene that has the members of fos::Scene.
#pragma once

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

#include "finish.hpp"
#include "mistaken_hit.hpp"
#include "mistaken_light.hpp"
#include "mistakes.hpp"

namespace fos {

template <typename T, typename Scene>
class MistakenTracer {
 public:
  using Vec = glm::vec<3, T>;

  /// What a pixel sees.
  struct Seen {
    int sphere = 0;  ///< its number in the file, from 1; 0 is the background
    T I = 1;
    Vec color{0};  ///< what trace_ray returns
    T t = 0;       ///< of the hit
  };

  /// `terms` are Term bits, 0 for the plain color. Keeps a reference to the scene.
  MistakenTracer(const Scene& scene, unsigned terms, const MistakeSet& mistakes)
      : scene_(scene),
        terms_(terms),
        mistakes_(mistakes),
        ending_(ending_of(mistakes)),
        hits_(scene_, mistakes_),
        light_(scene_, terms, mistakes_) {}
  MistakenTracer(const MistakenTracer&) = delete;  // its parts refer to it
  MistakenTracer& operator=(const MistakenTracer&) = delete;

  /// The ray O + t D, t in [t_min, t_max].
  Seen trace(const Vec& O, Vec D, T t_min, T t_max) const {
    if (is(Mistake::upside_down)) D.y = -D.y;
    if (is(Mistake::t_min_ignored)) t_min = 0;
    if (is(Mistake::t_min_behind)) t_min = -std::numeric_limits<T>::infinity();
    const auto hit = hits_.closest_hit(O, D, t_min, t_max);
    if (hit.sphere == 0) {
      const Vec& color = scene_.background_color;
      const Vec first =
          scene_.spheres.empty() ? color : ended<T>(ending_, scene_.spheres[0].color, 1);
      return {0, 1, background<T>(mistakes_, color, first)};
    }
    const auto& sphere = scene_.spheres[static_cast<std::size_t>(hit.sphere) - 1];
    if (terms_ == 0) return {hit.sphere, 1, ended<T>(ending_, sphere.color, 1), hit.t};

    const Vec P = point(O, D, hit.t);
    Vec N = normal(P, sphere.center, O, D);
    if (is(Mistake::every_length_is_3)) {
      N = N / T(3);
    } else if (!is(Mistake::N_not_normalised)) {
      N = N / length(N);
    }
    T I = is(Mistake::P_and_N_swapped) ? light_.lighting(N, P, sphere.center, O, D)
                                       : light_.lighting(P, N, sphere.center, O, D);
    I = total<T>(mistakes_, I);
    return {hit.sphere, I, ended<T>(ending_, sphere.color, I), hit.t};
  }

 private:
  bool is(Mistake mistake) const { return mistakes_.has(mistake); }

  Vec point(const Vec& O, const Vec& D, T t) const {
    if (is(Mistake::P_without_O)) return t * D;
    if (is(Mistake::P_without_t)) return O + D;
    if (is(Mistake::O_and_D_swapped)) return D + t * O;
    if (is(Mistake::P_along_unit_D)) return O + t * (D / length(D));
    return O + t * D;
  }

  Vec normal(const Vec& P, const Vec& C, const Vec& O, const Vec& D) const {
    if (is(Mistake::N_inward)) return C - P;
    if (is(Mistake::N_is_P)) return P;
    if (is(Mistake::N_is_D)) return D;
    if (is(Mistake::N_to_camera)) return O - P;
    if (is(Mistake::N_turned_to_camera) && dot(P - C, D) > 0) return C - P;
    return P - C;
  }

  const Scene& scene_;
  unsigned terms_;
  MistakeSet mistakes_;
  std::optional<Mistake> ending_;
  MistakenHit<T, Scene> hits_;
  MistakenLight<T, Scene> light_;
};

}  // namespace fos
