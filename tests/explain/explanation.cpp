#include "explanation.hpp"

#include <fmt/core.h>

#include <numeric>
#include <set>

#include "conclusion.hpp"
#include "drawing.hpp"
#include "fos/text.hpp"
#include "number_text.hpp"
#include "page.hpp"
#include "rows.hpp"
#include "spheres_table.hpp"

namespace fos {
namespace {

std::string sphere_text(int sphere) {
  return sphere == 0 ? say(text::explain_background)
                     : say(text::explain_sphere_name, {std::to_string(sphere)});
}

void write_heading(Page& page, const Subject& subject, bool compares) {
  const SceneText& scene = subject.scene;
  page.line(say(text::explain_title,
                {subject.stage.id, std::to_string(subject.column), std::to_string(subject.row),
                 std::filesystem::path(scene.name).filename().string(),
                 std::to_string(scene.canvas_width), std::to_string(scene.canvas_height)}));
  if (compares) page.line(say(text::explain_legend));
  page.line();
}

std::string exact(const mpq_class& x) { return decimal_text(reference::Enclosure{x, x}); }

/// What the toolkit gives to every program, and what the ray meets.
void write_ray(Page& page, const Chain& chain) {
  page.row("x = c - W/2", exact(chain.x), "", Mark::none);
  page.row("y = H/2 - 1 - r", exact(chain.y), "", Mark::none);
  page.row("D = (x Vw/W, y Vh/H, d)",
           fmt::format("({}, {}, {})", exact(chain.D[0]), exact(chain.D[1]), exact(chain.D[2])), "",
           Mark::none);
  page.line();
  write_spheres(page, chain);
  if (!chain.hit) {
    page.paragraph(say(text::explain_background_seen));
  } else if (sgn(chain.spheres[static_cast<std::size_t>(chain.hit->sphere - 1)].discriminant) ==
             0) {
    page.paragraph(say(text::explain_tangent, {std::to_string(chain.hit->sphere)}));
  }
}

/// What else than the exact answer is right.
void write_accepted(Page& page, const std::vector<Expected>& accepted) {
  if (accepted.empty()) page.paragraph(say(text::explain_not_judged));
  std::set<int> spheres;
  std::string names;
  for (const Expected& each : accepted) {
    if (!spheres.insert(each.sphere).second) continue;
    names += (names.empty() ? "" : ", ") + sphere_text(each.sphere);
  }
  if (spheres.size() > 1) page.paragraph(say(text::explain_either, {names}));
}

/// The light whose term differs, else the brightest of the stage's.
const LightMet* drawn_light(const Subject& subject, const Chain& chain,
                            const std::optional<Difference>& difference) {
  const bool at_light = difference && difference->line == Line::light;
  const bool shows = !difference || at_light || difference->line == Line::sum;
  if (!chain.hit || !shows) return nullptr;
  const LightMet* drawn = nullptr;
  for (const LightMet& met : chain.hit->lights) {
    if (!is_term(subject.stage, subject.scene.lights[met.index].kind)) continue;
    if (at_light && difference->light != met.index) continue;
    if (met.shine == Shine::at_P) continue;
    if (drawn == nullptr || met.term.low > drawn->term.high) drawn = &met;
  }
  return drawn;
}

void write_drawing(Page& page, const LightMet& met) {
  page.line();
  const std::vector<std::string> words{
      say(text::explain_drawing_title, {std::to_string(met.index + 1)}),
      say(text::explain_drawing_angle,
          {decimal_text(met.degrees, 4), decimal_text(met.cosine, 4)})};
  for (const std::string& line : draw_angle(met.degrees.low.get_d(), words)) page.line(line);
}

}  // namespace

Explanation explain(const Subject& subject, const std::optional<std::filesystem::path>& program,
                    bool colors) {
  const SceneText& scene = subject.scene;
  const Chain chain = certified_chain(scene, subject.stage.terms, subject.column, subject.row);
  const RightAnswers right(scene, subject.column, subject.row);
  std::optional<Comparison> comparison;
  if (program) {
    comparison = compare(
        scene, subject.stage, chain, right,
        [&](const SceneText& some) {
          return ask_alone(*program, some, subject.column, subject.row, alone_limits);
        },
        [&](const SceneText& whole) {
          return ask_in_picture(*program, whole, subject.column, subject.row, picture_limits);
        });
  }
  std::vector<std::size_t> all(scene.lights.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<Expected> accepted =
      comparison && comparison->alone.given.came()
          ? comparison->whole().expected
          : right.judge(all, subject.stage.terms).expected({0, 0}, reference::Precision::double53);

  // What is not there, or not written, has nothing to compare.
  const Comparison* compared = comparison && comparison->answered() ? &*comparison : nullptr;
  Page page(colors);
  write_heading(page, subject, compared != nullptr);
  write_ray(page, chain);
  write_accepted(page, accepted);
  page.line();
  write_rows(page, subject, chain, compared);
  if (const LightMet* met =
          drawn_light(subject, chain, compared != nullptr ? compared->difference : std::nullopt)) {
    write_drawing(page, *met);
  }
  page.line();
  if (!comparison) {
    page.paragraph(say(text::explain_only_right));
    return {page.text(), "", 0};
  }
  for (const std::string& sentence : conclusion(subject, chain, *comparison)) {
    page.paragraph(sentence);
  }
  return {page.text(), comparison->alone.given.words, exit_status(*comparison)};
}

}  // namespace fos
