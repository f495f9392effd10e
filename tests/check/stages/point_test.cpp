// point: I_A + the sum over the point lights.
//
// lit() looks at P = (0, 0, 2), where N = (0, 0, -1).
#include "stage_test.hpp"

namespace fos {

#define AMBIENT "light { type = ambient  intensity = 0.1 }"
// P = (0, 0, 5) and N = (0, 0, 1): a light in the sphere is behind the surface, one beyond is not.
#define AROUND "sphere { center = (0, 0, 0)  radius = 5  color = (200, 100, 50) }" AMBIENT

StageTest point_test() {
  return {
      {
          // L = (0, 0, -2), twice as long as N, so that its length must not matter.
          {{"L parallel to N: all of the light is reflected",
            "L παράλληλο στο N: ανακλάται όλο το φως"},
           {lit({100, 50, 25}, "light { type = point  intensity = 0.5  position = (0, 0, 0) }")}},

          {{"L perpendicular to N: none of it", "L κάθετο στο N: δεν ανακλάται καθόλου"},
           {lit({20, 10, 5},
                AMBIENT "light { type = point  intensity = 0.5  position = (5, 0, 2) }")}},

          {{"beyond 90 degrees the light is ignored", "πάνω από 90 μοίρες το φως αγνοείται"},
           {lit({20, 10, 5},
                AMBIENT "light { type = point  intensity = 0.5  position = (0, 0, 9) }")}},

          // L = (4, 0, -3), |L| = 5, <N, L> = 3: I = 0.1 + 0.5 * 3/5 = 0.4.
          {{"between them it is the cosine", "ανάμεσα σε αυτά είναι το συνημίτονο"},
           {lit({80, 40, 20},
                AMBIENT "light { type = point  intensity = 0.5  position = (4, 0, -1) }")}},

          // 0.5 * 3/5 + 0.25 * 1 + 0 (from behind) = 0.55.
          {{"every point light adds its term", "κάθε σημειακό φως προσθέτει τον όρο του"},
           {lit({110, 55, 27.5},
                "light { type = point  intensity = 0.5   position = (4, 0, -1) }"
                "light { type = point  intensity = 0.25  position = (0, 0, -7) }"
                "light { type = point  intensity = 0.5   position = (0, 0, 9) }")}},

          {{"a larger sphere is lit the same: N has length 1",
            "μια μεγαλύτερη σφαίρα φωτίζεται το ίδιο: το N έχει μέτρο 1"},
           {ahead({60, 30, 15},
                  "sphere { center = (0, 0, 7)  radius = 5  color = (200, 100, 50) }"
                  "light { type = point  intensity = 0.5  position = (4, 0, -1) }")}},

          {{"a light at P itself adds nothing", "ένα φως πάνω στο ίδιο το P δεν προσθέτει τίποτα"},
           {lit({20, 10, 5},
                AMBIENT "light { type = point  intensity = 0.5  position = (0, 0, 2) }")}},

          {{"N points outward inside a sphere too",
            "το N δείχνει προς τα έξω και μέσα σε μια σφαίρα"},
           {ahead({20, 10, 5},
                  AROUND "light { type = point  intensity = 0.5  position = (0, 0, 0) }"),
            ahead({120, 60, 30},
                  AROUND "light { type = point  intensity = 0.5  position = (0, 0, 9) }")}},

          {{"directional lights are for later stages",
            "τα κατευθυνόμενα φώτα είναι για επόμενα στάδια"},
           {lit({20, 10, 5},
                AMBIENT "light { type = directional  intensity = 0.5  direction = (0, 0, -1) }")}},

          {{"without any light it is dark", "χωρίς κανένα φως είναι σκοτάδι"},
           {lit({0, 0, 0}, "")}},

          {{"ambient light alone is I_A", "το περιβάλλον φως μόνο του είναι I_A"},
           {lit({60, 30, 15}, "light { type = ambient  intensity = 0.3 }")}},

          // 3/5 of each of 0.05, 0.1, 0.15, 0.2 and 0.25.
          {{"five lights of a kind are five terms", "πέντε όμοια φώτα είναι πέντε όροι"},
           {lit({90, 45, 22.5},
                "light { type = point  intensity = 0.05  position = (4, 0, -1) }"
                "light { type = point  intensity = 0.1   position = (4, 0, -1) }"
                "light { type = point  intensity = 0.15  position = (4, 0, -1) }"
                "light { type = point  intensity = 0.2   position = (4, 0, -1) }"
                "light { type = point  intensity = 0.25  position = (4, 0, -1) }")}},

          {{"more light than white is cut off in each channel by itself",
            "περισσότερο φως από το λευκό κόβεται σε κάθε κανάλι χωριστά"},
           {lit({300, 150, 75}, "light { type = point  intensity = 1.5  position = (0, 0, 0) }")}},

          // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5), L = (2, 6/5, -12/5),
          // <N, L> = 12/5: I = 0.2 + 0.6 * 2.4 / sqrt(11.2) = 0.63028. On the left of the red
          // sphere no light comes from the point: I = 0.2.
          {{"pixels of the lecture's scene", "pixel από τη σκηνή του μαθήματος"},
           {lecture_pixel(300, 349, {160.722, 0, 0}), lecture_pixel(108, 460, {51, 0, 0})}},
      },
      {},
  };
}

}  // namespace fos
