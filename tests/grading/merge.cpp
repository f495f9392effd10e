#include "merge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <tuple>

#include "class_run.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "grading/intake/journal.hpp"
#include "grading/intake/result_json.hpp"
#include "grading/report/report_files.hpp"

namespace fos::grading {
namespace {

namespace fs = std::filesystem;

struct GradedPart {
  fs::path folder;
  Run run;
  std::unique_ptr<Journal> journal;  ///< held, so that nobody grades in it meanwhile
};

Run run_in(const fs::path& folder) {
  try {
    std::ifstream in(folder / "run.json");
    return run_from_json(std::string{std::istreambuf_iterator<char>(in), {}});
  } catch (const JsonError&) {
    throw FileError(2, say(text::grade_no_part, {folder.string()}));
  }
}

auto what_is_shared(const Run& run) {
  return std::tie(run.title, run.toolkit, run.seed, run.box, run.feedback, run.parts);
}

std::string part_of(unsigned part, const Run& run) { return fmt::format("{}/{}", part, run.parts); }

/// All parts, each finished, in order.
std::vector<GradedPart> parts_in(const std::vector<fs::path>& folders) {
  std::map<unsigned, GradedPart> by_number;
  std::optional<GradedPart> first;
  for (const fs::path& folder : folders) {
    GradedPart part{folder, run_in(folder), nullptr};
    if (!first) first = GradedPart{folder, part.run, nullptr};
    if (what_is_shared(part.run) != what_is_shared(first->run)) {
      throw FileError(2, say(text::grade_other_run, {folder.string(), first->folder.string()}));
    }
    if (const auto same = by_number.find(part.run.part); same != by_number.end()) {
      throw FileError(2, say(text::grade_part_twice, {same->second.folder.string(), folder.string(),
                                                      part_of(part.run.part, part.run)}));
    }
    part.journal = std::make_unique<Journal>(folder);
    if (!part.run.is_finished) {
      throw FileError(2, say(text::grade_part_unfinished, {folder.string()}));
    }
    by_number.emplace(part.run.part, std::move(part));
  }
  std::vector<GradedPart> all;
  all.reserve(by_number.size());
  for (auto& [number, part] : by_number) all.push_back(std::move(part));
  for (unsigned number = 1; number <= all.front().run.parts; ++number) {
    if (number > all.size() || all[number - 1].run.part != number) {
      throw FileError(2, say(text::grade_part_missing, {part_of(number, all.front().run)}));
    }
  }
  return all;
}

void copy_pictures(const SubmissionResult& result, const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  for (const StageResult& stage : result.stages) {
    for (const std::string& picture : stage.pictures) {
      WholeFile file(to / picture);
      std::error_code error;
      fs::copy_file(from / picture, file.temporary(), fs::copy_options::overwrite_existing, error);
      if (error) throw file.write_error(error.message());
      file.commit();
    }
  }
}

}  // namespace

Merged merge_parts(const GradeOptions& asked) {
  const std::vector<GradedPart> graded = parts_in(asked.merged);
  GradeOptions options = asked;
  Run run = graded.front().run;
  options.feedback = run.feedback;
  run.part = run.parts = 1;
  run.finished.clear();
  for (const GradedPart& part : graded) {
    run.finished.insert(run.finished.end(), part.run.finished.begin(), part.run.finished.end());
    run.date = std::max(run.date, part.run.date);
  }
  std::sort(run.finished.begin(), run.finished.end());
  Journal journal(options.output);
  write_whole_file(options.output / "run.json", to_json(run));
  fs::remove(options.output / "reports.txt");  // so that all pages are written

  Merged merged;
  std::vector<Entry> entries;
  entries.reserve(run.finished.size());
  for (const GradedPart& part : graded) {
    for (const std::string& id : part.run.finished) {
      const auto result = part.journal->read(id);
      if (!result) throw FileError(2, say(text::grade_part_unfinished, {part.folder.string()}));
      copy_pictures(*result, submission_folder(part.folder, id),
                    submission_folder(options.output, id));
      journal.write(*result);
      if (result->status == Status::not_judged) ++merged.not_judged;
      entries.push_back({{id, result->name, result->username, "", result->email, result->source},
                         result->key,
                         result->overrides});
    }
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.whose.id < b.whose.id; });
  merged.results = entries.size();
  merged.refused = report_class(options, run, entries, journal);
  return merged;
}

}  // namespace fos::grading
