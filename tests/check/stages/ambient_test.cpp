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
      {
          {"Ambient light comes from everywhere. Does it matter to it where P is, or which "
           "way the surface looks there?",
           "Το περιβάλλον φως έρχεται από παντού. Έχει σημασία γι' αυτό πού είναι το P, ή "
           "προς τα πού κοιτά εκεί η επιφάνεια;"},

          {"Slide \"Είδη πηγών - ανακεφαλαίωση\": a point light has two quantities, a "
           "directional light too. What does ambient light have? And where in `scene` does "
           "that number stand?",
           "Διαφάνεια «Είδη πηγών - ανακεφαλαίωση»: το σημειακό φως έχει δύο μεγέθη, το "
           "κατευθυνόμενο επίσης. Τι έχει το περιβάλλον φως; Και πού μέσα στο `scene` "
           "βρίσκεται αυτός ο αριθμός;"},

          {"Slide \"Η εξίσωση της διάχυτης ανάκλασης\": I_P = I_A + a sum over the other "
           "lights. In this stage there are no other lights. What is left of the equation? "
           "compute_lighting returns that, and uses neither P nor N.",
           "Διαφάνεια «Η εξίσωση της διάχυτης ανάκλασης»: I_P = I_A + ένα άθροισμα στα άλλα "
           "φώτα. Σε αυτό το στάδιο δεν υπάρχουν άλλα φώτα. Τι μένει από την εξίσωση; Αυτό "
           "επιστρέφει η compute_lighting, και δεν χρησιμοποιεί ούτε το P ούτε το N."},

          {"The old TraceRay ended with the sphere's color. Slide \"Μεταφράζοντας τα "
           "παραπάνω σε κώδικα\", under \"με τον νέο κώδικα\": four lines take its place. "
           "What does each of them compute, and which of its quantities does the hit "
           "already give you?",
           "Η παλιά TraceRay τελείωνε με το χρώμα της σφαίρας. Διαφάνεια «Μεταφράζοντας τα "
           "παραπάνω σε κώδικα», κάτω από το «με τον νέο κώδικα»: τέσσερις γραμμές παίρνουν "
           "τη θέση του. Τι υπολογίζει η καθεμία, και ποια από τα μεγέθη της σου τα δίνει "
           "ήδη το hit;"},

          {"P = O + t D with the hit's t, which is written hit->t: the arrow, because the "
           "hit may be missing. N = CP / |CP|, slide \"Το παράδειγμα της σφαίρας : "
           "Normals\". The color is the sphere's color times I.",
           "P = O + t D με το t του hit, που γράφεται hit->t: με βέλος, γιατί το hit μπορεί "
           "και να λείπει. N = CP / |CP|, διαφάνεια «Το παράδειγμα της σφαίρας : Normals». "
           "Το χρώμα που φαίνεται είναι το χρώμα της σφαίρας επί I."},

          {"In words: compute_lighting returns the scene's ambient intensity. trace_ray "
           "makes a Vec3 P of O plus hit->t times D; a Vec3 N of P minus the centre of "
           "hit->sphere, and divides it by its length; and returns the color of hit->sphere "
           "times compute_lighting of P, N and scene.",
           "Με λόγια: η compute_lighting επιστρέφει την ένταση του περιβάλλοντος φωτός της "
           "σκηνής. Η trace_ray φτιάχνει ένα Vec3 P, ίσο με O συν hit->t επί D· ένα Vec3 N, "
           "ίσο με P μείον το κέντρο του hit->sphere, και το διαιρεί με το μέτρο του· και "
           "επιστρέφει το χρώμα του hit->sphere επί την compute_lighting των P, N και scene."},
      },
  };
}

}  // namespace fos
