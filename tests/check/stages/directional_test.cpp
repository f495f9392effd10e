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
      {
          {"The sun shines on two points of a scene, some metres from each other. How much "
           "do the directions differ in which the two points see it?",
           "Ο ήλιος φωτίζει δύο σημεία μιας σκηνής, που απέχουν μερικά μέτρα. Πόσο "
           "διαφέρουν οι κατευθύνσεις στις οποίες τον βλέπουν τα δύο σημεία;"},

          {"Slide \"Κατευθυνόμενο φως\": \"Το light vector είναι πάντα το ίδιο\". Which of "
           "the light's two quantities is it? Is P needed for it?",
           "Διαφάνεια «Κατευθυνόμενο φως»: «Το light vector είναι πάντα το ίδιο». Ποιο από "
           "τα δύο μεγέθη του φωτός είναι; Χρειάζεται γι' αυτό το P;"},

          {"light.direction points from the surface toward the light: it is L itself, "
           "nothing is subtracted and no sign is changed. But (1, 4, 4) is not of length 1. "
           "What in the cosine <N, L> / (|N| |L|) sees to that (slide \"Μοντελοποιώντας την "
           "διάχυτη ανάκλαση\")?",
           "Το light.direction δείχνει από την επιφάνεια προς το φως: είναι το ίδιο το L, "
           "τίποτα δεν αφαιρείται και κανένα πρόσημο δεν αλλάζει. Όμως το (1, 4, 4) δεν "
           "έχει μέτρο 1. Τι στο συνημίτονο <N, L> / (|N| |L|) το διορθώνει αυτό (διαφάνεια "
           "«Μοντελοποιώντας την διάχυτη ανάκλαση»);"},

          {"What does a light give that comes from behind the surface, where <N, L> < 0? "
           "Slide \"Η εξίσωση της διάχυτης ανάκλασης\": such terms are ignored, and why? "
           "What would a negative term do to the light of the others?",
           "Τι δίνει ένα φως που έρχεται πίσω από την επιφάνεια, όπου <N, L> < 0; Διαφάνεια "
           "«Η εξίσωση της διάχυτης ανάκλασης»: τέτοιους όρους τους αγνοούμε, και γιατί; Τι "
           "θα έκανε ένας αρνητικός όρος στο φως των άλλων;"},

          {"I_P = I_A + the sum of I_i <N, L_i> / (|N| |L_i|) over the directional lights. "
           "N and the ending of trace_ray are those of `ambient`: P = O + t D, N = CP / "
           "|CP| (slide \"Το παράδειγμα της σφαίρας : Normals\").",
           "I_P = I_A + το άθροισμα των I_i <N, L_i> / (|N| |L_i|) στα κατευθυνόμενα φώτα. "
           "Το N και το τέλος της trace_ray είναι εκείνα του `ambient`: P = O + t D, N = CP "
           "/ |CP| (διαφάνεια «Το παράδειγμα της σφαίρας : Normals»)."},

          {"In words: a Real i begins as scene.ambient_intensity. For each light in "
           "scene.directional_lights: L is its direction; n_dot_l is the dot of N and L; "
           "only if n_dot_l is above 0, i grows by the light's intensity times n_dot_l, "
           "divided by the product of the two lengths (in parentheses). After the loop i is "
           "returned.",
           "Με λόγια: ένα Real i αρχίζει ως scene.ambient_intensity. Για κάθε φως στο "
           "scene.directional_lights: L είναι η κατεύθυνσή του· n_dot_l είναι το dot των N "
           "και L· μόνο αν το n_dot_l είναι πάνω από 0, το i μεγαλώνει κατά την ένταση του "
           "φωτός επί n_dot_l, διά το γινόμενο των δύο μέτρων (σε παρένθεση). Μετά τον "
           "βρόχο επιστρέφεται το i."},
      },
  };
}

}  // namespace fos
