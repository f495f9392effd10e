// The result of one submission: all that a report or a platform's file is made from.
//
// Points are whole hundredths. The score starts at 0, and only what is proven adds to it. Text that
// a student made (names, compiler output, what a program printed) is kept as it came, at most
// most_text bytes of it: each writer escapes it for where it goes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fos/text.hpp"

namespace fos::grading {

inline constexpr std::size_t most_text = std::size_t{8} * 1024;

enum class Status {
  passed,
  failed,
  not_judged  ///< nobody's points: infrastructure, or a stage that was not asked for
};

/// Why something has failed, or was not judged.
enum class Cause {
  none,
  wrong_pixels,
  not_finite,     ///< NaN or infinite channels
  unwritten,      ///< the stub's answer
  crashed,        ///< killed by a signal
  out_of_time,    ///< CPU time
  out_of_memory,  ///< the limit on memory
  left,           ///< exited in mid-frame, or sent what is no frame
  refused,        ///< it says that it cannot carry the scene
  not_compiled,
  no_file,         ///< not handed in, twice, not text, too large, a link
  infrastructure,  ///< ours: retried, and never costs points
};

/// What is told to a student.
enum class Feedback { marks, hints, full };

/// The kinds of points that a stage has.
enum class Part {
  checks,     ///< the public checks, as in `./lab check`
  scenes,     ///< scenes drawn from the seed, which nobody has published
  relations,  ///< what needs no reference: mirrored, brighter, in another order
};
inline constexpr Part parts[] = {Part::checks, Part::scenes, Part::relations};

/// One line of the report.
struct CheckResult {
  Part part = Part::checks;
  std::string words_en;  ///< what is checked
  std::string words_el;
  Status status = Status::not_judged;
  Cause cause = Cause::none;
  int passed = 0;  ///< of `things`
  int things = 1;
  int points = 0;  ///< hundredths, of `most`
  int most = 0;
  std::string why;  ///< in the language of the run: the first wrong pixel; empty for a scene that
                    ///< nobody has published
};

struct StageResult {
  std::string stage;                   ///< its id
  Status status = Status::not_judged;  ///< passed: everything
  Cause cause = Cause::none;           ///< of the stage as a whole, where no frame came at all
  int points = 0;                      ///< hundredths
  int most = 0;                        ///< hundredths
  std::vector<CheckResult> checks;
  std::string
      mistake;         ///< the names of the mistakes found, with " + "; empty where none has a name
  std::string advice;  ///< their question and where to look, ready to show; several lines
  bool carried = false;    ///< the mistake was made in an earlier stage and is not charged here
  std::string compiler;    ///< what the compiler said
  std::string program;     ///< what the program printed where it ended without a frame
  std::string sanitizer;   ///< where a crash happened, by a run with sanitizers
  double cpu_seconds = 0;  ///< of all frames; not part of what is compared between machines
  /// Pictures beside the page: yours, expected, difference; file names in the submission's folder.
  /// Empty where none were made.
  std::vector<std::string> pictures;
};

/// An instructor's own marks.
struct Override {
  std::string stage;  ///< empty: the whole submission
  int points = 0;     ///< hundredths
  std::string reason;

  bool operator==(const Override&) const = default;
};

struct SubmissionResult {
  std::string id;        ///< unique in the class, safe as a file's name: [a-z0-9._-]
  std::string name;      ///< as the folder or the zip was called, or the roster's name
  std::string username;  ///< the platform's, from the roster or the zip's name; may be empty
  std::string email;     ///< likewise
  std::string source;    ///< the file or folder it came from, below PATH
  std::string key;  ///< of its files, the seed, the toolkit and the settings: same key, same result
  std::string box;  ///< the level of the box: bubblewrap, landlock, uid, none
  std::uint64_t seed = 0;
  std::vector<std::string> notes;  ///< of the hand-in: a file missing, twice, a link …, in words
  std::vector<StageResult> stages;
  std::vector<Override> overrides;
  Status status = Status::not_judged;  ///< not_judged where infrastructure kept any stage from it

  /// With the overrides applied, stage by stage, then the whole.
  int points() const;
  int most() const;
};

/// A stage's points with its override, if there is one.
int points_of(const SubmissionResult& submission, const StageResult& stage);

/// What the class was graded with.
struct Run {
  std::string title;    ///< of the course or the folder
  std::string toolkit;  ///< its version
  std::uint64_t seed = 0;
  std::string box;
  Feedback feedback = Feedback::full;
  std::string date;   ///< ISO 8601
  unsigned part = 1;  ///< of `parts` shares of the class, which were graded each by itself
  unsigned parts = 1;
  std::vector<std::string> finished = {};  ///< the ids in this part, once all of them are graded
  bool is_finished = false;
};

std::string_view name(Status status);
std::string_view name(Cause cause);
std::string_view name(Part part);
std::string_view name(Feedback feedback);

/// "12.5": hundredths as a decimal number, no zeros at its end.
std::string points_text(int hundredths);

}  // namespace fos::grading
