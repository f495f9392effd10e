#include "class_table.hpp"

#include <algorithm>

#include "escape.hpp"
#include "fos/text.hpp"
#include "page_frame.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

const StageSummary* find_stage(const Summary& one, const std::string& id) {
  const auto found = std::find_if(one.stages.begin(), one.stages.end(),
                                  [&](const StageSummary& stage) { return stage.stage == id; });
  return found == one.stages.end() ? nullptr : &*found;
}

bool is_marked(const Summary& one, const std::string& stage) {
  return std::any_of(one.overrides.begin(), one.overrides.end(),
                     [&](const Override& own) { return own.stage == stage; });
}

void add_heading(MarkupWriter& out, const std::string& words) {
  out.raw(R"(<th scope="col"><button type="button">)").text(words).raw("</button></th>");
}

void add_heading(MarkupWriter& out, const std::string& words, int most) {
  out.raw(R"(<th scope="col" class="number"><button type="button">)").text(words);
  out.raw("</button><small>").text("/ " + points_text(most)).raw("</small></th>");
}

/// A number of points, colored; nothing to sort by where there is none.
void add_points(MarkupWriter& out, int points, int most, bool judged, const std::string& why) {
  out.raw(R"(<td class="number")").attribute("data-sort", judged ? std::to_string(points) : "");
  if (!why.empty()) out.attribute("title", why);
  out.raw("><span").attribute("class", tone(points, most, judged)).raw(">");
  out.text(judged ? points_text(points) : "–").raw("</span></td>");
}

void add_stage(MarkupWriter& out, const Summary& one, const std::string& id) {
  const StageSummary* stage = find_stage(one, id);
  if (stage == nullptr) return add_points(out, 0, 0, false, "");
  const std::string why = stage->status == Status::passed ? ""
                          : stage->mistake.empty()        ? cause_words(stage->cause)
                                                          : stage->mistake;
  add_points(out, stage->points, stage->most,
             stage->status != Status::not_judged || is_marked(one, id), why);
}

std::string remarks(const Summary& one) {
  std::string out;
  const auto add = [&](const std::string& words) { out += (out.empty() ? "" : ", ") + words; };
  if (!is_settled(one)) add(say(text::report_not_judged));
  if (!one.overrides.empty()) add(say(text::report_overridden));
  if (one.notes > 0) add(say(text::report_hand_in_notes, {std::to_string(one.notes)}));
  return out;
}

void add_row(MarkupWriter& out, const Summary& one, const ClassStatistics& numbers) {
  const std::string remark = remarks(one);
  const std::string& shown_name = one.name.empty() ? one.id : one.name;
  std::string words = shown_name + "\n" + one.id + "\n" + one.username + "\n" + one.email;
  for (const StageSummary& stage : one.stages) words += "\n" + trouble(stage);
  out.raw("<tr").attribute("data-words", words + "\n" + remark);
  out.raw(R"(><th scope="row")").attribute("data-sort", shown_name);
  out.raw("><a").attribute("href", "submissions/" + address(one.id) + "/index.html").raw("><bdi>");
  out.text(shown_name).raw("</bdi></a></th><td").attribute("data-sort", one.username).raw("><bdi>");
  out.text(one.username).raw("</bdi></td>");
  add_points(out, one.points, one.most, is_settled(one), "");
  for (const StageStatistics& stage : numbers.stages) add_stage(out, one, stage.stage);
  out.raw("<td").attribute("data-sort", remark).raw(">").text(remark).raw("</td></tr>\n");
}

}  // namespace

void add_class_table(MarkupWriter& out, std::span<const Summary> all,
                     const ClassStatistics& numbers) {
  out.raw("<section>\n").element("h2", say(text::report_all_submissions));
  out.raw("\n<div class=\"filter\" id=\"filter-box\" hidden><label>");
  out.raw(R"(<span class="dim">)").text(say(text::report_filter)).raw("</span>");
  out.raw(R"(<input id="filter" type="search" autocomplete="off"></label>)");
  out.raw(R"(<span id="shown" role="status")");
  out.attribute("data-pattern", say(text::report_shown, {"{0}", "{1}"})).raw("></span></div>\n");
  out.element("p", "dim how", say(text::report_sort));
  out.raw("\n<div class=\"scroll\" tabindex=\"0\" role=\"region\"");
  out.attribute("aria-label", say(text::report_all_submissions));
  out.raw(">\n<table id=\"class\"><thead><tr>");
  add_heading(out, say(text::report_name));
  add_heading(out, say(text::report_username));
  add_heading(out, say(text::report_total), numbers.most);
  for (const StageStatistics& stage : numbers.stages) {
    add_heading(out, stage_title(stage.stage), stage.most);
  }
  add_heading(out, say(text::report_remarks));
  out.raw("</tr></thead>\n<tbody>\n");
  for (const Summary& one : all) add_row(out, one, numbers);
  out.raw("</tbody></table>\n</div>\n</section>\n");
}

}  // namespace fos::grading
