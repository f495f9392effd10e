// `./lab watch`: a check at every save, until all is right.
#pragma once

#include <chrono>
#include <string>

#include "checker.hpp"
#include "file_watcher.hpp"
#include "keys.hpp"
#include "measure.hpp"
#include "signals.hpp"
#include "terminal.hpp"

namespace fos {

struct WatchOptions {
  Places places;
  const Stage* stage = nullptr;
  int measure = 0;  ///< how many saves to measure, instead of waiting for them; 0 to watch
};

class Watch {
 public:
  explicit Watch(const WatchOptions& options);

  /// Until q, a signal, or the end of what is to be done. Without a terminal there are no keys, and
  /// it ends when all is right. Returns the exit status: 0 where the last verdict was that all is
  /// right, 1 where not, 128 and the signal's number where one ended it.
  int run();

 private:
  using Clock = FileWatcher::Clock;

  void wait();  ///< until something happens, or it is time to look at the file
  void on_signal(int signal);
  void on_event(const Checked& checked);
  void on_event(const Pictured& pictured);
  void on_key(Key key);
  void look();

  void check(bool anew);
  void draw();  ///< the last verdict and the keys
  std::string status() const;
  void watch_stage(const Stage& stage);
  void run_lab(const std::vector<std::string>& words);
  void explain();
  std::string read_line();  ///< a line typed, without its end; empty where Ctrl-C came
  void stop_here();         ///< Ctrl-Z: as any program does
  const Stage* next_stage() const;
  std::filesystem::path file() const;

  WatchOptions options_;
  Signals signals_;  // before all that starts a thread
  Terminal terminal_;
  Paint paint_;
  Checker checker_;
  FileWatcher file_;
  KeyReader keys_;
  Measure measure_;
  const Stage* stage_;
  long serial_ = 0;          // of the check that counts
  Clock::time_point saved_;  // at the earliest, what it checks
  Clock::time_point looked_;
  Checked verdict_;
  bool has_verdict_ = false;
  bool is_checking_ = false;
  bool shows_other_ = false;  // a child's words stand in the window
  double seconds_ = 0;        // from save to verdict
  bool done_ = false;
  int signal_ = 0;
};

}  // namespace fos
