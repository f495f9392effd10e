// The asker's side of a supervisor (fos/supervision.hpp).
#pragma once

#include <chrono>
#include <optional>

#include "fos/supervision.hpp"

namespace fos {

class Supervision {
 public:
  /// `socket` is this side's, and is closed at the end.
  explicit Supervision(int socket) : socket_(socket) {}
  ~Supervision();
  Supervision(const Supervision&) = delete;
  Supervision& operator=(const Supervision&) = delete;

  void say(supervision::Word word) const;

  /// Nothing more is asked: the supervisor ends what it runs.
  void shut() const;

  /// Hears what the supervisor says, or waits until `other` can be read too (-1: nothing), or for
  /// so long.
  void hear(int other, std::chrono::milliseconds patience);

  /// Hears what the supervisor says until it has ended, or for so long.
  void hear_end(std::chrono::milliseconds patience);

  /// It has said how it ended, or has gone without a word.
  bool is_over() const { return gone_ || ended_; }

  /// What has been heard: that the program was started, how it ended, why it was not started.
  bool started() const { return started_; }
  const std::optional<supervision::Message>& ended() const { return ended_; }
  const std::optional<supervision::Message>& failed() const { return failed_; }

 private:
  int socket_;
  bool gone_ = false;
  bool started_ = false;
  std::optional<supervision::Message> ended_;
  std::optional<supervision::Message> failed_;
};

/// Waits for a process to end, and kills it if that takes longer; the wait status.
int wait_or_kill(int process, std::chrono::milliseconds patience);

}  // namespace fos
