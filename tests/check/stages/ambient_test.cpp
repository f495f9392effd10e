// ambient: color times I_A, the same at every point.
#include "stage_test.hpp"

namespace fos {

StageTest ambient_test() {
  return {
      {
          {{"color times the ambient intensity", "χρώμα επί την ένταση του περιβάλλοντος φωτός"},
           {lit({60, 30, 15}, "light { type = ambient  intensity = 0.3 }")}},

          {{"without ambient light it is dark", "χωρίς περιβάλλον φως είναι σκοτάδι"},
           {lit({0, 0, 0}, "")}},

          {{"an intensity over 1 is not cut off: only the picture is",
            "μια ένταση πάνω από 1 δεν κόβεται: κόβεται μόνο η εικόνα"},
           {lit({240, 120, 60}, "light { type = ambient  intensity = 1.2 }")}},

          {{"the other kinds of light are for later stages",
            "τα άλλα είδη φωτός είναι για επόμενα στάδια"},
           {lit({60, 30, 15},
                "light { type = ambient      intensity = 0.3 }"
                "light { type = point        intensity = 0.6  position = (0, 0, 0) }"
                "light { type = directional  intensity = 0.6  direction = (0, 0, -1) }")}},

          {{"what is met at t = 1 exactly is lit too",
            "φωτίζεται και ό,τι βρίσκεται ακριβώς στο t = 1"},
           {ahead({60, 30, 15},
                  "sphere { center = (0, 0, 0)  radius = 1  color = (200, 100, 50) }"
                  "light { type = ambient  intensity = 0.3 }")}},

          {{"pixels of the lecture's scene", "pixel από τη σκηνή του μαθήματος"},
           {lecture_pixel(300, 400, {51, 0, 0}), lecture_pixel(500, 300, {0, 0, 51}),
            lecture_pixel(50, 500, {51, 51, 0})}},
      },
      {},
  };
}

}  // namespace fos
