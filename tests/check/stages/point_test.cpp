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
      {
          {"A point light, a lamp, shines on two points of a sphere. Which of the light's "
           "quantities are the same for both points, and what changes from one to the other?",
           "Ένα σημειακό φως, μια λάμπα, φωτίζει δύο σημεία μιας σφαίρας. Ποια μεγέθη του "
           "φωτός είναι ίδια και για τα δύο σημεία, και τι αλλάζει από το ένα στο άλλο;"},

          {"The light vector L changes: it begins at P and ends at the light (slide "
           "\"Σημειακό φως\"). Of the two points, light.position and P, which one is "
           "subtracted from which? Draw it: the arrow points away from the surface.",
           "Αλλάζει το διάνυσμα φωτός L: αρχίζει από το P και τελειώνει στο φως (διαφάνεια "
           "«Σημειακό φως»). Από τα δύο σημεία, light.position και P, ποιο αφαιρείται από "
           "ποιο; Σχεδίασέ το: το βέλος φεύγει από την επιφάνεια."},

          {"Slides \"Μοντελοποιώντας την διάχυτη ανάκλαση\": with L parallel to N all of "
           "the light is reflected, with L perpendicular to N none. Which function of the "
           "angle is 1 at 0 and 0 at 90 degrees? How do N and L give it without the angle "
           "itself?",
           "Διαφάνειες «Μοντελοποιώντας την διάχυτη ανάκλαση»: με L παράλληλο στο N "
           "ανακλάται όλο το φως, με L κάθετο στο N καθόλου. Ποια συνάρτηση της γωνίας "
           "είναι 1 στις 0 μοίρες και 0 στις 90; Πώς τη δίνουν τα N και L, χωρίς να βρεις "
           "την ίδια τη γωνία;"},

          {"The cosine is <N, L> / (|N| |L|): dot and length. L is not of length 1, so its "
           "length must be divided away. And which sign has the cosine beyond 90 degrees, "
           "\"Προσοχή στις γωνίες > 90 μοίρες!\"? On which side of the surface is the light "
           "then?",
           "Το συνημίτονο είναι <N, L> / (|N| |L|): dot και length. Το L δεν έχει μέτρο 1, "
           "άρα πρέπει να διαιρέσεις με το μέτρο του. Και τι πρόσημο έχει το συνημίτονο "
           "πάνω από τις 90 μοίρες («Προσοχή στις γωνίες > 90 μοίρες!»); Σε ποια πλευρά της "
           "επιφάνειας είναι τότε το φως;"},

          {"I_P = I_A + the sum of I_i <N, L_i> / (|N| |L_i|) over the point lights, "
           "without the terms where <N, L_i> is not positive (slide \"Η εξίσωση της "
           "διάχυτης ανάκλασης\"). A sum begins somewhere and grows by each light: what "
           "does it begin with?",
           "I_P = I_A + το άθροισμα των I_i <N, L_i> / (|N| |L_i|) στα σημειακά φώτα, χωρίς "
           "τους όρους όπου το <N, L_i> δεν είναι θετικό (διαφάνεια «Η εξίσωση της διάχυτης "
           "ανάκλασης»). Ένα άθροισμα από κάπου αρχίζει και μεγαλώνει με κάθε φως: από τι "
           "αρχίζει;"},

          {"N is made in trace_ray: from the centre C to P, and of length 1, N = CP / |CP| "
           "(slide \"Το παράδειγμα της σφαίρας : Normals\"). P is on the ray, P = O + t D "
           "with the hit's t. It is the same ending as in `ambient`.",
           "Το N φτιάχνεται στην trace_ray: από το κέντρο C προς το P, και με μέτρο 1, N = "
           "CP / |CP| (διαφάνεια «Το παράδειγμα της σφαίρας : Normals»). Το P είναι πάνω "
           "στην ακτίνα, P = O + t D με το t του hit. Είναι το ίδιο τέλος όπως στο "
           "`ambient`."},

          {"In words: a Real i begins as scene.ambient_intensity. For each light in "
           "scene.point_lights: L is its position minus P; n_dot_l is the dot of N and L; "
           "only if n_dot_l is above 0, i grows by the light's intensity times n_dot_l, "
           "divided by the product of the two lengths (in parentheses). After the loop i is "
           "returned.",
           "Με λόγια: ένα Real i αρχίζει ως scene.ambient_intensity. Για κάθε φως στο "
           "scene.point_lights: L είναι η θέση του μείον P· n_dot_l είναι το dot των N και "
           "L· μόνο αν το n_dot_l είναι πάνω από 0, το i μεγαλώνει κατά την ένταση του "
           "φωτός επί n_dot_l, διά το γινόμενο των δύο μέτρων (σε παρένθεση). Μετά τον "
           "βρόχο επιστρέφεται το i."},
      },
  };
}

}  // namespace fos
