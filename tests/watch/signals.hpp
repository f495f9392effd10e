// Signals as something to read, beside keys and events: nothing is done in a handler.
#pragma once

namespace fos {

/// Holds back the signals that end, stop and continue a program, in this thread and those that it
/// starts later; one at a time in a process. Those that were ignored (nohup) stay ignored.
class Signals {
 public:
  Signals();
  ~Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;

  int descriptor() const { return descriptor_; }  ///< readable when next() has one
  int next();                                     ///< the next signal, or 0

 private:
  int descriptor_ = -1;
};

/// For a child, between fork and exec: nothing is held back.
void release_signals();

}  // namespace fos
