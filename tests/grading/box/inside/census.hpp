// The processes in the box: what they use, and whether they want to run.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <cstdint>
#include <map>
#include <string>

namespace fos::grading::inside {

struct Census {
  unsigned processes = 0;
  std::uint64_t memory = 0;   ///< bytes
  bool wants_to_run = false;  ///< one of them runs, waits for a processor, or for a disk
};

/// Counts, again and again, the processes of one session. (Nobody leaves it: setsid is denied.)
class Counter {
 public:
  explicit Counter(pid_t session) : session_(session) {}

  Census count();

  /// Microseconds of processor time of all that lived in the session up to the last count, also of
  /// those that nobody waited for.
  std::uint64_t cpu() const;

 private:
  pid_t session_;
  std::map<pid_t, std::uint64_t> seen_;  // what each had used when last counted
  std::uint64_t added_ = 0;              // what was seen to be used, from count to count
  std::uint64_t alive_ = 0;  // what the living have used, with their waited-for children
};

/// How many threads this user has, in all.
rlim_t threads_of_user();

/// Whether a folder holds more than so many bytes, or too many files.
bool holds_more_than(const std::string& folder, std::uint64_t bytes);

}  // namespace fos::grading::inside
