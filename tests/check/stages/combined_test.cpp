// combined: I_P = I_A + the sum over all lights of I_i <N, L_i> / (|N| |L_i|).
//
// lit() looks at P = (0, 0, 2), where N = (0, 0, -1).
#include "stage_test.hpp"

namespace fos {

#define AMBIENT "light { type = ambient  intensity = 0.1 }"

StageTest combined_test() {
  return {
      {
          {{"L parallel to N: all of the light is reflected",
            "L παράλληλο στο N: ανακλάται όλο το φως"},
           {lit({150, 75, 37.5},
                "light { type = point        intensity = 0.5   position  = (0, 0, 0) }"
                "light { type = directional  intensity = 0.25  direction = (0, 0, -3) }")}},

          {{"L perpendicular to N: none of it", "L κάθετο στο N: δεν ανακλάται καθόλου"},
           {lit({20, 10, 5},
                AMBIENT "light { type = point        intensity = 0.5   position  = (5, 0, 2) }"
                        "light { type = directional  intensity = 0.25  direction = (0, 2, 0) }")}},

          {{"beyond 90 degrees a light is ignored, and takes nothing from the others",
            "πάνω από 90 μοίρες ένα φως αγνοείται, και δεν αφαιρεί από τα άλλα"},
           {lit({70, 35, 17.5},
                AMBIENT "light { type = point        intensity = 0.5   position  = (0, 0, 9) }"
                        "light { type = directional  intensity = 0.25  direction = (0, 0, 1) }"
                        "light { type = directional  intensity = 0.25  direction = (0, 0, -1) }")}},

          // 0.5 * 3/5 + 0.25 * 4/5 + 0.1 + 0.25 * 3/5 + 0.05 * 1 = 0.8.
          {{"any number of lights, in any order", "όσα φώτα κι αν υπάρχουν, με όποια σειρά"},
           {lit({160, 80, 40},
                "light { type = point        intensity = 0.5   position  = (4, 0, -1) }"
                "light { type = directional  intensity = 0.25  direction = (0, 3, -4) }" AMBIENT
                "light { type = directional  intensity = 0.25  direction = (-4, 0, -3) }"
                "light { type = point        intensity = 0.05  position  = (0, 0, -5) }")}},

          {{"the sum may exceed 1: only the picture cuts it off",
            "το άθροισμα μπορεί να ξεπεράσει το 1: το κόβει μόνο η εικόνα"},
           {ahead({240, 120, 60},
                  "sphere { center = (0, 0, 3)  radius = 1  color = (100, 50, 25) }"
                  "light { type = ambient  intensity = 0.9 }"
                  "light { type = point    intensity = 1.5  position = (0, 0, 0) }")}},

          {{"without any light it is dark", "χωρίς κανένα φως είναι σκοτάδι"},
           {lit({0, 0, 0}, "")}},

          {{"ambient light alone is I_A", "το περιβάλλον φως μόνο του είναι I_A"},
           {lit({60, 30, 15}, "light { type = ambient  intensity = 0.3 }")}},

          // 3/5 of each of 0.05, 0.1, 0.15, 0.2 and 0.25.
          {{"five lights of a kind are five terms, of either kind",
            "πέντε όμοια φώτα είναι πέντε όροι, και στα δύο είδη"},
           {lit({90, 45, 22.5},
                "light { type = point  intensity = 0.05  position = (4, 0, -1) }"
                "light { type = point  intensity = 0.1   position = (4, 0, -1) }"
                "light { type = point  intensity = 0.15  position = (4, 0, -1) }"
                "light { type = point  intensity = 0.2   position = (4, 0, -1) }"
                "light { type = point  intensity = 0.25  position = (4, 0, -1) }"),
            lit({90, 45, 22.5},
                "light { type = directional  intensity = 0.05  direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.1   direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.15  direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.2   direction = (4, 0, -3) }"
                "light { type = directional  intensity = 0.25  direction = (4, 0, -3) }")}},

          // x = 0, y = -50: t = 12/5, P = (0, -1/5, 12/5), N = (0, 4/5, -3/5):
          // I = 0.2 + 0.6 * 2.4 / sqrt(11.2) + 0.2 * 0.8 / sqrt(33) = 0.65813. And just below the
          // sphere's top: 136.501, which a truncation would make 136.
          {{"pixels of the lecture's scene", "pixel από τη σκηνή του μαθήματος"},
           {lecture_pixel(300, 349, {167.824, 0, 0}), lecture_pixel(300, 300, {136.501, 0, 0})}},
      },
      {
          {"You have the terms already: ambient, point, directional. What makes one light "
           "out of many? And does the order matter in which they are taken?",
           "Τους όρους τους έχεις ήδη: περιβάλλον, σημειακό, κατευθυνόμενο φως. Τι κάνει τα "
           "πολλά φώτα ένα; Και παίζει ρόλο με ποια σειρά τα παίρνεις;"},

          {"Slide \"Είδη πηγών - ανακεφαλαίωση\": any number of point and directional "
           "lights, and one ambient. In the sum, then, how many times is I_A?",
           "Διαφάνεια «Είδη πηγών - ανακεφαλαίωση»: αυθαίρετος αριθμός από σημειακά και "
           "κατευθυνόμενα φώτα, και ένα περιβάλλον. Άρα πόσες φορές μπαίνει το I_A στο "
           "άθροισμα;"},

          {"Slide \"Μεταφράζοντας τα παραπάνω σε κώδικα\", ComputeLighting: what is the "
           "only line in which a point light and a directional light differ? What follows "
           "is the same for both: does it have to be written twice?",
           "Διαφάνεια «Μεταφράζοντας τα παραπάνω σε κώδικα», ComputeLighting: σε ποια μόνο "
           "γραμμή διαφέρουν ένα σημειακό και ένα κατευθυνόμενο φως; Ό,τι ακολουθεί είναι "
           "ίδιο και για τα δύο: πρέπει να γραφτεί δύο φορές;"},

          {"The slide goes through scene.Lights and asks each light for its type. Here the "
           "kinds stand apart: scene.ambient_intensity, scene.point_lights, "
           "scene.directional_lights. What becomes of the slide's `if`, and of its one loop?",
           "Η διαφάνεια περνά από όλα τα scene.Lights και ρωτά κάθε φως για το είδος του "
           "(type). Εδώ τα είδη είναι χωριστά: scene.ambient_intensity, scene.point_lights, "
           "scene.directional_lights. Τι γίνονται τα `if` της διαφάνειας, και ο ένας της "
           "βρόχος;"},

          {"I_P = I_A + the sum of I_i <N, L_i> / (|N| |L_i|) over all point and "
           "directional lights (slide \"Η εξίσωση της διάχυτης ανάκλασης\"), a term only "
           "where <N, L_i> is positive. L_i is position minus P for a point light, "
           "direction for a directional one. The sum may well exceed 1: do not cut it off.",
           "I_P = I_A + το άθροισμα των I_i <N, L_i> / (|N| |L_i|) σε όλα τα σημειακά και "
           "κατευθυνόμενα φώτα (διαφάνεια «Η εξίσωση της διάχυτης ανάκλασης»), κάθε όρος "
           "μόνο όπου το <N, L_i> είναι θετικό. Το L_i είναι θέση μείον P στο σημειακό φως, "
           "κατεύθυνση στο κατευθυνόμενο. Το άθροισμα μπορεί να ξεπεράσει το 1: μην το "
           "κόψεις."},

          {"In words: a Real i begins as the ambient intensity. One loop over "
           "scene.point_lights adds its terms as in `point`, a second one over "
           "scene.directional_lights adds its terms to the same i, as in `directional`. "
           "Then i is returned. The ending of trace_ray is that of the stages before.",
           "Με λόγια: ένα Real i αρχίζει ως η ένταση του περιβάλλοντος φωτός. Ένας βρόχος "
           "στο scene.point_lights προσθέτει τους όρους του όπως στο `point`, ένας δεύτερος "
           "στο scene.directional_lights προσθέτει τους δικούς του στο ίδιο i, όπως στο "
           "`directional`. Μετά επιστρέφεται το i. Το τέλος της trace_ray είναι εκείνο των "
           "προηγούμενων σταδίων."},
      },
  };
}

}  // namespace fos
