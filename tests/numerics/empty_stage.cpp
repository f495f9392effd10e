// What asking a stage costs when the stage does nothing: `./lab trade STAGE` takes it off.
#include "fos/stage.hpp"

namespace fos {

Color trace_ray(const Vec3& /*O*/, const Vec3& /*D*/, Real /*t_min*/, Real /*t_max*/,
                const Scene& scene) {
  return scene.background_color;
}

}  // namespace fos
