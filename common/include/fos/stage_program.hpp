// A stage program, asked from outside. Its exit status, text and files prove nothing; only a whole
// frame counts, and a crash or an endless loop is an answer too.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fos/frame.hpp"
#include "fos/request.hpp"

namespace fos {

/// How an answer ended.
enum class Ending {
  complete,       ///< the whole frame came
  refused,        ///< the program cannot carry the scene, and has said why on standard error
  crashed,        ///< killed by a signal: `detail`
  timed_out,      ///< over its limits of time, or idle while it was waited for
  out_of_memory,  ///< over the limit that a supervisor watches
  exited,         ///< exited in mid-frame, with status `detail`
  malformed,      ///< what came is not a frame of the size asked for
  did_not_start,  ///< errno in `detail`, or 0: infrastructure, not the stage's fault
};

struct Answer {
  Ending ending = Ending::complete;
  int detail = 0;
  FrameHeader header;
  int rows = 0;  ///< whole rows received, from the top
  int pixels =
      0;  ///< of the next row, where it ended in the middle of one: it ended at this column
};

struct Limits {
  std::chrono::milliseconds wall{0};  ///< for one answer; 0 for none
  int cpu_seconds = 0;                ///< for the program's whole life; 0 for none
  bool hear = false;                  ///< keep what it prints for words(), instead of showing it
  bool fresh = false;  ///< each answer by a copy of its own, with its own cpu_seconds: what a stage
                       ///< keeps in statics is gone. It costs a fifth of a new program
};

/// A stage program that a supervisor runs, in a box for instance.
struct SupervisedCommand {
  /// Whatever leads to the program, each descriptor left as it is; its last word is the program's
  /// own, and what starts first has a path. In front of the program is a supervisor
  /// (fos/supervision.hpp), whose limits of time and memory hold; of Limits only `wall`, `hear` and
  /// `fresh` do. A program that is not heard prints to nowhere.
  std::vector<std::string> words;
};

/// Called about four times a second while nothing comes.
using WaitSink = std::function<void()>;
using HeaderSink = std::function<void(const FrameHeader&)>;
using ReceivedRow = std::function<void(int row, const Row&)>;

class Exchange;
class Supervision;

/// One running program. It is started at the first question, asked any number of scenes, and killed
/// at the end or when an answer is not complete (the next question starts a new one).
class StageProgram {
 public:
  explicit StageProgram(const std::filesystem::path& program, Limits limits = {});
  explicit StageProgram(SupervisedCommand command, Limits limits = {});
  ~StageProgram();
  StageProgram(const StageProgram&) = delete;
  StageProgram& operator=(const StageProgram&) = delete;

  /// Asks for a frame; hands its header and each row on as they come. What the sinks throw passes
  /// through.
  Answer ask(
      const Request& request, const HeaderSink& on_header, const ReceivedRow& on_row,
      const WaitSink& on_wait = [] {});

  /// The same, kept in memory: as much of the frame as came.
  Answer ask(
      const Request& request, Frame& frame, const WaitSink& on_wait = [] {});

  /// The first few KiB of what the program printed before its last answer ended, where it is heard:
  /// all of it where it crashed or left, and only what it had flushed where the frame came.
  const std::string& words() const { return words_; }

  /// The running program's process, or -1: to ask the system what it uses.
  int process() const { return process_; }

  /// Ends the program, if it runs. Where it is supervised, nothing of it is left afterwards.
  void end() { stop(); }

  /// Seconds of processor time that the programs took which have ended, as their supervisors say.
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  bool start();
  int stop();  ///< ends and reaps; the wait status
  Answer supervised_ending(Answer answer, bool late, Exchange& exchange);

  std::vector<std::string> words_of_command_;
  bool supervised_ = false;
  Limits limits_;
  std::unique_ptr<Supervision> supervision_;  // where it is supervised and runs
  double cpu_seconds_ = 0;
  int process_ = -1;
  int requests_ = -1;  // a socket: the program's standard input
  int frames_ = -1;    // a pipe from the program's descriptor 3
  int printed_ = -1;   // a pipe from its standard output and error, where it is heard
  std::string words_;
};

}  // namespace fos
