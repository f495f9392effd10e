#include "class_page.hpp"

#include <algorithm>
#include <cmath>

#include "class_statistics.hpp"
#include "class_table.hpp"
#include "fos/text.hpp"
#include "histogram.hpp"
#include "page_frame.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

constexpr std::size_t most_mistakes = 15;

std::string rounded(double hundredths) {
  return points_text(static_cast<int>(std::lround(hundredths / 10)) * 10);
}

void add_fact(MarkupWriter& out, std::string_view value, const std::string& words) {
  out.raw("<li>").element("strong", value).text(words).raw("</li>\n");
}

void add_facts(MarkupWriter& out, const ClassStatistics& numbers) {
  const std::string of = " / " + points_text(numbers.most);
  out.raw("<ul class=\"facts\">\n");
  add_fact(out, std::to_string(numbers.submissions), say(text::report_submissions));
  if (numbers.mean) {
    add_fact(out, rounded(*numbers.mean) + of, say(text::report_mean));
    add_fact(out, rounded(*numbers.median) + of, say(text::report_median));
    add_fact(out, std::to_string(numbers.all_right), say(text::report_all_right));
  }
  if (const int rest = numbers.submissions - numbers.settled; rest > 0) {
    add_fact(out, std::to_string(rest), say(text::report_unsettled));
  }
  out.raw("</ul>\n");
}

void add_stages(MarkupWriter& out, const ClassStatistics& numbers) {
  out.element("h2", say(text::report_by_stage));
  out.raw("\n<div class=\"scroll\"><table id=\"stages\"><thead><tr>");
  out.raw(R"(<th scope="col">)").text(say(text::report_stage)).raw("</th>");
  out.raw(R"(<th scope="col">)").text(say(text::report_mean_points)).raw("</th>");
  const bool unjudged =
      std::any_of(numbers.stages.begin(), numbers.stages.end(),
                  [](const StageStatistics& stage) { return stage.not_judged > 0; });
  const auto heading = [&](const Text& words) {
    out.raw(R"(<th scope="col" class="number">)").text(say(words)).raw("</th>");
  };
  heading(text::report_passed);
  heading(text::report_partly);
  heading(text::report_nothing);
  if (unjudged) heading(text::report_not_judged);
  out.raw("</tr></thead>\n<tbody>\n");
  for (const StageStatistics& stage : numbers.stages) {
    out.raw(R"(<tr><th scope="row">)").text(stage_title(stage.stage)).raw("</th><td>");
    out.text(rounded(stage.mean) + " / " + points_text(stage.most));
    add_meter(out, static_cast<int>(stage.mean), stage.most);
    out.raw(R"(</td><td class="number good">)").number(stage.all_right);
    out.raw(R"(</td><td class="number part">)").number(stage.partly);
    out.raw(R"(</td><td class="number bad">)").number(stage.nothing);
    if (unjudged) out.raw(R"(</td><td class="number none">)").number(stage.not_judged);
    out.raw("</td></tr>\n");
  }
  out.raw("</tbody></table></div>\n");
}

void add_mistakes(MarkupWriter& out, const ClassStatistics& numbers) {
  out.element("h2", say(text::report_commonest)).raw("\n");
  if (numbers.mistakes.empty()) {
    out.element("p", say(text::report_no_mistakes)).raw("\n");
    return;
  }
  out.raw(R"(<div class="scroll"><table id="mistakes"><thead><tr>)");
  out.raw(R"(<th scope="col">)").text(say(text::report_mistake)).raw("</th>");
  out.raw(R"(<th scope="col">)").text(say(text::report_stage)).raw("</th>");
  out.raw(R"(<th scope="col" class="number">)").text(say(text::report_count));
  out.raw("</th></tr></thead>\n<tbody>\n");
  const std::size_t shown = std::min(most_mistakes, numbers.mistakes.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const MistakeCount& one = numbers.mistakes[i];
    out.raw(R"(<tr><td><button type="button")").attribute("data-filter", one.mistake).raw(">");
    out.text(one.mistake)
        .raw(R"(</button></td><td class="whole-words">)")
        .text(stage_title(one.stage));
    out.raw(R"(</td><td class="number">)").number(one.submissions).raw("</td></tr>\n");
  }
  out.raw("</tbody></table></div>\n");
  if (shown < numbers.mistakes.size()) {
    out.element("p", "dim",
                say(text::report_more_mistakes, {std::to_string(numbers.mistakes.size() - shown)}));
  }
}

}  // namespace

std::string class_page(const Run& run, std::span<const Summary> all) {
  const ClassStatistics numbers = statistics_of(all);
  const std::string title = say(text::report_class_title, {run.title});
  MarkupWriter out;
  out.raw("<header>\n").element("h1", title).raw("\n<p class=\"dim\">");
  out.text(graded_with(run, run.seed, run.box)).raw("</p>\n</header>\n<main>\n");
  if (all.empty()) {
    out.element("p", say(text::report_empty_class)).raw("\n");
  } else {
    add_facts(out, numbers);
    out.raw("<div class=\"columns\">\n<section>\n");
    if (numbers.settled > 0) {
      out.element("h2", say(text::report_distribution)).raw("\n");
      add_histogram(out, numbers.tenths);
    }
    add_stages(out, numbers);
    out.raw("</section>\n<section>\n");
    add_mistakes(out, numbers);
    out.raw("</section>\n</div>\n");
    add_class_table(out, all, numbers);
  }
  out.raw("</main>\n");
  return whole_page(title, out, !all.empty());
}

}  // namespace fos::grading
