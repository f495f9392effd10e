#include "rounded_scene.hpp"

namespace fos::reference {

bool is_repeated(const std::vector<ExactSphere>& spheres, std::size_t i) {
  return std::any_of(spheres.begin(), spheres.begin() + static_cast<std::ptrdiff_t>(i),
                     [&](const ExactSphere& earlier) {
                       return earlier.center == spheres[i].center &&
                              earlier.radius == spheres[i].radius;
                     });
}

template class RoundedSceneOf<Interval>;

}  // namespace fos::reference
