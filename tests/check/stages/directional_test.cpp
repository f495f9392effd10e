// directional: I_A + the sum over the directional lights, with one L for the whole scene.
//
// lit() looks at P = (0, 0, 2), where N = (0, 0, -1).
#include "stage_test.hpp"

namespace fos {

#define AMBIENT "light { type = ambient  intensity = 0.1 }"

StageTest directional_test() {
  return {
      {
          {{"L parallel to N: all of the light is reflected",
            "L παράλληλο στο N: ανακλάται όλο το φως"},
           {lit({100, 50, 25},
                "light { type = directional  intensity = 0.5  direction = (0, 0, -3) }")}},

          {{"L perpendicular to N: none of it", "L κάθετο στο N: δεν ανακλάται καθόλου"},
           {lit({20, 10, 5},
                AMBIENT "light { type = directional  intensity = 0.5  direction = (5, 0, 0) }")}},

          {{"beyond 90 degrees the light is ignored", "πάνω από 90 μοίρες το φως αγνοείται"},
           {lit({20, 10, 5},
                AMBIENT "light { type = directional  intensity = 0.5  direction = (0, 0, 3) }")}},

          // <N, L> / (|N| |L|) = 3/5: I = 0.1 + 0.5 * 3/5 = 0.4.
          {{"between them it is the cosine, whatever the length of L",
            "ανάμεσα σε αυτά είναι το συνημίτονο, όσο κι αν είναι το μέτρο του L"},
           {lit({80, 40, 20},
                AMBIENT "light { type = directional  intensity = 0.5  direction = (4, 0, -3) }"),
            lit({80, 40, 20}, AMBIENT
                "light { type = directional  intensity = 0.5  direction = (0.4, 0, -0.3) }"),
            lit({80, 40, 20}, AMBIENT
                "light { type = directional  intensity = 0.5  direction = (4e9, 0, -3e9) }")}},

          // 0.5 * 3/5 + 0.25 * 1 + 0 (from behind) = 0.55.
          {{"every directional light adds its term",
            "κάθε κατευθυνόμενο φως προσθέτει τον όρο του"},
           {lit({110, 55, 27.5},
                "light { type = directional  intensity = 0.5   direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.25  direction = (0, 0, -1) }"
                "light { type = directional  intensity = 0.5   direction = (0, 0, 1) }")}},

          {{"L is the same wherever P is, and N has length 1",
            "το L είναι το ίδιο όπου κι αν είναι το P, και το N έχει μέτρο 1"},
           {ahead({60, 30, 15},
                  "sphere { center = (0, 0, 70)  radius = 5  color = (200, 100, 50) }"
                  "light { type = directional  intensity = 0.5  direction = (4, 0, -3) }")}},

          {{"point lights are for other stages", "τα σημειακά φώτα είναι για άλλα στάδια"},
           {lit({20, 10, 5},
                AMBIENT "light { type = point  intensity = 0.5  position = (0, 0, 0) }")}},

          {{"without any light it is dark", "χωρίς κανένα φως είναι σκοτάδι"},
           {lit({0, 0, 0}, "")}},

          {{"ambient light alone is I_A", "το περιβάλλον φως μόνο του είναι I_A"},
           {lit({60, 30, 15}, "light { type = ambient  intensity = 0.3 }")}},

          // 3/5 of each of 0.05, 0.1, 0.15, 0.2 and 0.25.
          {{"five lights of a kind are five terms", "πέντε όμοια φώτα είναι πέντε όροι"},
           {lit({90, 45, 22.5},
                "light { type = directional  intensity = 0.05  direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.1   direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.15  direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.2   direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.25  direction = (4, 0, -3) }")}},

          {{"more light than white is cut off in each channel by itself",
            "περισσότερο φως από το λευκό κόβεται σε κάθε κανάλι χωριστά"},
           {lit({300, 150, 75},
                "light { type = directional  intensity = 1.5  direction = (0, 0, -1) }")}},

          // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5), L = (1, 4, 4),
          // <N, L> = 4/5: I = 0.2 + 0.2 * 0.8 / sqrt(33) = 0.22785. The light comes from behind the
          // scene, so most of what faces the camera gets none: I = 0.2.
          {{"pixels of the lecture's scene", "pixel από τη σκηνή του μαθήματος"},
           {lecture_pixel(300, 349, {58.102, 0, 0}), lecture_pixel(300, 400, {51, 0, 0})}},
      },
      {},
  };
}

}  // namespace fos
