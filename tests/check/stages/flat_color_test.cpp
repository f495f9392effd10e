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
      {},
  };
}

}  // namespace fos
