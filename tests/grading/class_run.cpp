#include "class_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

#include "fos/progress.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"

namespace fos::grading {
namespace {

/// What pages hang on besides the results.
std::string signature(const GradeOptions& options) {
  std::string words =
      fmt::format("{} {}", name(options.feedback), language() == Language::el ? "el" : "en");
  for (const ReportFormat format : options.formats) words += fmt::format(" {}", name(format));
  return words + "\n";
}

}  // namespace

bool complete(SubmissionResult& result, const Entry& entry) {
  const bool same = result.name == entry.whose.name && result.username == entry.whose.username &&
                    result.email == entry.whose.email && result.overrides == entry.overrides;
  result.name = entry.whose.name;
  result.username = entry.whose.username;
  result.email = entry.whose.email;
  result.overrides = entry.overrides;
  return !same;
}

bool all_finished(const std::vector<Entry>& entries, const Journal& journal) {
  return std::all_of(entries.begin(), entries.end(), [&](const Entry& entry) {
    return journal.is_finished(entry.whose.id, entry.key);
  });
}

Tally ClassRun::grade(const ClassFiles& hand_ins, const std::vector<Entry>& entries,
                      Journal& journal, const std::atomic<bool>& stop) const {
  Tally tally;
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!journal.is_finished(entries[i].whose.id, entries[i].key)) left.push_back(i);
  }
  tally.finished_before = entries.size() - left.size();

  const ReportSettings settings{options_.formats};
  std::mutex busy;
  Progress progress(say(text::grade_progress), static_cast<long>(left.size()));
  std::size_t next = 0;
  std::exception_ptr failure;
  const auto ended = [&] { return stop || failure; };
  const auto take = [&](HandIn& hand_in, std::size_t& place) {
    const std::scoped_lock lock(busy);
    if (next == left.size() || ended()) return false;
    place = left[next++];
    hand_in = hand_ins.read(entries[place].place);
    return true;
  };
  const auto wait = [&] {
    const std::scoped_lock lock(busy);
    if (ended()) throw Interrupted();
    progress.wait();
  };
  const auto work = [&](unsigned slot) {
    try {
      SubmissionGrader grader(course_, slot, scratch_ / std::to_string(slot));
      HandIn hand_in;
      for (std::size_t place = 0; take(hand_in, place);) {
        const auto pictures = submission_folder(options_.output, hand_in.whose.id);
        SubmissionResult result = grader.grade(hand_in, pictures, wait);
        result.key = entries[place].key;
        complete(result, entries[place]);
        const std::scoped_lock lock(busy);  // one file is written at a time
        journal.write(result);
        write_submission_files(options_.output, run_, result, settings);
        if (result.status == Status::not_judged) ++tally.not_judged;
        progress.update(static_cast<long>(++tally.graded));
      }
    } catch (const Interrupted&) {  // NOLINT(bugprone-empty-catch): what is finished is kept
    } catch (...) {
      const std::scoped_lock lock(busy);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    const auto jobs =
        std::min<std::size_t>(options_.jobs == 0 ? processors : options_.jobs, left.size());
    std::vector<std::jthread> workers;
    for (unsigned slot = 0; slot < jobs; ++slot) workers.emplace_back(work, slot);
  }
  if (failure) std::rethrow_exception(failure);
  if (stop) throw Interrupted();
  return tally;
}

std::vector<std::string> report_class(const GradeOptions& options, const Run& run,
                                      const std::vector<Entry>& entries, Journal& journal) {
  const ReportSettings settings{options.formats};
  // Pages of other formats, words or feedback than those that are there are written anew.
  const std::filesystem::path note = options.output / "reports.txt";
  const std::string written = signature(options);
  std::ifstream in(note);
  const bool anew = written != std::string{std::istreambuf_iterator<char>(in), {}};
  std::vector<Summary> all;
  for (const Entry& entry : entries) {
    auto result = journal.read(entry.whose.id);
    if (!result) continue;
    const bool changed = complete(*result, entry);
    if (changed) journal.write(*result);
    if (changed || anew) write_submission_files(options.output, run, *result, settings);
    all.push_back(summarize(*result));
  }
  std::vector<std::string> refused = write_class_files(options.output, run, all, settings);
  write_whole_file(note, written);
  return refused;
}

}  // namespace fos::grading
