// flat_color: the closest sphere's color, as it is, or the background.
#include "stage_test.hpp"

namespace fos {
namespace {

#define ORANGE "sphere { center = (0, 0, 3)  radius = 1  color = (200, 100, 50) }\n"
#define BLUE "sphere { center = (0, 0, 9)  radius = 2  color = (10, 20, 255) }\n"

constexpr Channels orange{200, 100, 50};
constexpr Channels blue{10, 20, 255};
constexpr Channels background{0, 0, 0};

}  // namespace

StageTest flat_color_test() {
  return {
      {
          {{"a ray that meets a sphere sees its color",
            "μια ακτίνα που συναντά μια σφαίρα βλέπει το χρώμα της"},
           {ahead(orange, ORANGE)}},

          {{"a ray that meets nothing sees the background",
            "μια ακτίνα που δεν συναντά τίποτα βλέπει το φόντο"},
           {ahead(background, "sphere { center = (5, 0, 3)  radius = 1  color = (1, 2, 3) }")}},

          {{"the nearer of two spheres hides the other, in either order in the file",
            "η κοντινότερη από δύο σφαίρες κρύβει την άλλη, με όποια σειρά κι αν γραφτούν"},
           {ahead(orange, ORANGE BLUE), ahead(orange, BLUE ORANGE)}},

          {{"a sphere behind the camera is not seen",
            "μια σφαίρα πίσω από την κάμερα δεν φαίνεται"},
           {ahead(background, "sphere { center = (0, 0, -3)  radius = 1  color = (1, 2, 3) }")}},

          // t is 0.25 and 0.75 there, both below t_min = 1; then 0.75 and 0.95.
          {{"what lies before the projection plane is not seen (t < t_min)",
            "ό,τι είναι πριν από το επίπεδο προβολής δεν φαίνεται (t < t_min)"},
           {ahead(blue, "sphere { center = (0, 0, 0.5)  radius = 0.25  color = (1, 2, 3) }" BLUE),
            ahead(blue, "sphere { center = (0, 0, 0.85)  radius = 0.1  color = (1, 2, 3) }" BLUE)}},

          {{"however far away a sphere is, it is seen",
            "όσο μακριά κι αν είναι μια σφαίρα, φαίνεται"},
           {ahead(blue, "sphere { center = (0, 0, 2e6)  radius = 5e5  color = (10, 20, 255) }")}},

          // The camera is at the centre, so the ray leaves the sphere at t = 1 exactly.
          {{"t_min itself counts: the interval is closed",
            "και το ίδιο το t_min μετράει: το διάστημα είναι κλειστό"},
           {ahead(blue, "sphere { center = (0, 0, 0)  radius = 1  color = (10, 20, 255) }")}},

          {{"from inside a sphere its far side is seen",
            "μέσα από μια σφαίρα φαίνεται η μακρινή της πλευρά"},
           {ahead(blue, "sphere { center = (0, 0, 0)  radius = 5  color = (10, 20, 255) }"),
            ahead(blue, "sphere { center = (0, 0, -2)  radius = 5  color = (10, 20, 255) }")}},

          // The smaller root of the second is behind the camera, so it is not nearer for that.
          {{"from inside a sphere a nearer one hides its far side, in either order in the file",
            "μέσα από μια σφαίρα, μια κοντινότερη κρύβει τη μακρινή της πλευρά, με όποια σειρά"},
           {ahead(orange, ORANGE "sphere { center = (0, 0, 0)  radius = 20  color = (1, 2, 3) }"),
            ahead(orange, "sphere { center = (0, 0, 0)  radius = 20  color = (1, 2, 3) }" ORANGE)}},

          {{"colors are real numbers, the background's too",
            "τα χρώματα είναι πραγματικοί αριθμοί, και του φόντου"},
           {{"canvas_size = 2 x 2  background_color = (0.5, 127.25, 254.75)",
             {1, 0},
             {0.5, 127.25, 254.75}},
            ahead({0.5, 1.25, 9.75},
                  "sphere { center = (0, 0, 3)  radius = 1  color = (0.5, 1.25, 9.75) }")}},

          // The discriminant is 0, in numbers that are exact at any precision and formulation.
          {{"a ray that only touches a sphere meets it",
            "μια ακτίνα που μόλις αγγίζει μια σφαίρα τη συναντά"},
           {ahead(blue, "sphere { center = (3, 0, 4)  radius = 3  color = (10, 20, 255) }")}},

          {{"pixels of the lecture's scene", "pixel από τη σκηνή του μαθήματος"},
           {lecture_pixel(300, 400, {255, 0, 0}), lecture_pixel(500, 300, {0, 0, 255}),
            lecture_pixel(100, 300, {0, 255, 0}), lecture_pixel(50, 500, {255, 255, 0}),
            lecture_pixel(0, 0, {255, 255, 255})}},
      },
      {
          {"The ray is O + t D, one point for each t. Which of them lie on a sphere with "
           "centre C and radius r? What do all points of a sphere have in common?",
           "Η ακτίνα είναι O + t D, ένα σημείο για κάθε t. Ποια από αυτά βρίσκονται πάνω σε "
           "σφαίρα με κέντρο C και ακτίνα r; Τι κοινό έχουν όλα τα σημεία μιας σφαίρας;"},

          {"They are r away from C: |P - C|^2 = r^2 (lecture 3, ray and sphere). Put O + t "
           "D in the place of P. With CO = O - C, what stands before t^2, what before t, "
           "and what is left?",
           "Απέχουν r από το C: |P - C|^2 = r^2 (μάθημα 3, τομή ακτίνας και σφαίρας). Βάλε "
           "το O + t D στη θέση του P. Με CO = O - C, τι πολλαπλασιάζει το t^2, τι το t, "
           "και τι μένει;"},

          {"A quadratic equation a t^2 + b t + c = 0 with a = <D, D>, b = 2 <CO, D>, c = "
           "<CO, CO> - r^2. How many t are there where b^2 - 4ac is negative, zero, "
           "positive? And what does the ray do to the sphere in each of these cases?",
           "Μια δευτεροβάθμια εξίσωση a t^2 + b t + c = 0, με a = <D, D>, b = 2 <CO, D>, c "
           "= <CO, CO> - r^2. Πόσα t υπάρχουν όταν η διακρίνουσα b^2 - 4ac είναι αρνητική, "
           "μηδέν, θετική; Και πώς βρίσκεται τότε η ακτίνα ως προς τη σφαίρα;"},

          {"intersect_ray_sphere: where b^2 - 4ac < 0 it returns twice infinity, otherwise "
           "both roots, (-b + root) / (2a) and (-b - root) / (2a), with std::sqrt for the "
           "root. All of 2a is below the fraction: it needs its parentheses.",
           "intersect_ray_sphere: όπου b^2 - 4ac < 0 επιστρέφει δύο φορές infinity, αλλιώς "
           "και τις δύο ρίζες, (-b + ρίζα) / (2a) και (-b - ρίζα) / (2a), με std::sqrt για "
           "τη ρίζα. Όλο το 2a είναι στον παρονομαστή: θέλει τις παρενθέσεις του."},

          {"trace_ray: of all the t of all spheres, which one does the camera see? And "
           "which do not count at all? Slide \"Μεταφράζοντας τα παραπάνω σε κώδικα\", "
           "TraceRay: what must be true of t1 before it becomes closest_t?",
           "trace_ray: από όλα τα t όλων των σφαιρών, ποιο βλέπει η κάμερα; Και ποια δεν "
           "μετρούν καθόλου; Διαφάνεια «Μεταφράζοντας τα παραπάνω σε κώδικα», TraceRay: τι "
           "πρέπει να ισχύει για το t1 ώστε να γίνει closest_t;"},

          {"Before the loop closest_t is infinity and the closest sphere is a null pointer, "
           "const Sphere*. For each sphere try both roots: one that is in [t_min, t_max], "
           "ends included, and less than closest_t becomes closest_t, and the pointer takes "
           "the address of that sphere. After the loop: a null pointer gives "
           "scene.background_color, otherwise the color of the sphere it points at.",
           "Πριν από τον βρόχο το closest_t είναι infinity και η κοντινότερη σφαίρα ένας "
           "μηδενικός δείκτης, const Sphere*. Σε κάθε σφαίρα δοκίμασε και τις δύο ρίζες: "
           "όποια είναι στο [t_min, t_max], μαζί με τα άκρα, και μικρότερη από το closest_t "
           "γίνεται το νέο closest_t, και ο δείκτης παίρνει τη διεύθυνση αυτής της σφαίρας. "
           "Μετά τον βρόχο: ο μηδενικός δείκτης δίνει scene.background_color, αλλιώς το "
           "χρώμα της σφαίρας όπου δείχνει."},
      },
  };
}

}  // namespace fos
