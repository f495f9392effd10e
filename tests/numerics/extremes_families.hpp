// The families by their subject, each in a file of its own.
#pragma once

#include "extremes.hpp"

namespace fos::numerics {

// extremes_lights.cpp
Family point_light_far();
Family sun();
Family replaced();
Family light_near_surface();
Family direction_length();
Family bright();
Family many_lights();
// extremes_spheres.cpp
Family floor_radius();
Family sphere_far();
Family unit_of_length();
Family grazing();
Family ties();
Family terminator();
Family camera_and_sphere();
Family canvas_limits();
// extremes_shadows.cpp
Family shadows();
// extremes_far.cpp
Family falloff();
Family lost_P();
// extremes_sums.cpp
Family sums();

}  // namespace fos::numerics
