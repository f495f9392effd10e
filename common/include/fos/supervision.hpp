// What is said between the one who asks a program and the supervisor that runs it in a box: on
// descriptor 4 of the supervisor, a socket that keeps messages apart (SOCK_SEQPACKET). The program
// itself never has it.
//
// The supervisor says first whether the program was started, and at the end how it ended; then
// nothing of it is left. Where the asker shuts its side, or is gone, the supervisor ends all.
#pragma once

#include <cstdint>

namespace fos::supervision {

inline constexpr int descriptor = 4;

/// What the asker says: one byte.
enum class Word : char {
  question = 'Q',  ///< a question follows: its processor time and its idle time begin at 0
  waiting = 'W',   ///< for a quarter of a second nothing has come
  enough = 'E'     ///< end it, as at the limit of processor time
};

enum class Event : std::uint32_t {
  started,      ///< the program runs: what follows is its own doing
  not_started,  ///< it could not be started: `status` is an errno
  ended         ///< and nothing that it started is alive
};

/// Who ended it.
enum class Cause : std::uint32_t {
  itself,
  cpu,        ///< the processor time of one question
  memory,     ///< of all its processes together
  idle,       ///< it neither computed nor wanted to, while it was waited for
  processes,  ///< more of them than it may have
  disk,       ///< more files, or larger ones, than it may write
  asker       ///< it was told to
};

struct Message {
  Event event = Event::started;
  Cause cause = Cause::itself;
  std::int32_t status = 0;             ///< ended: as of waitpid; not_started: an errno
  std::uint32_t step = 0;              ///< not_started: where (for whoever looks for the reason)
  std::uint64_t cpu_microseconds = 0;  ///< of all its processes, as far as is known
  std::uint64_t peak_bytes = 0;        ///< of memory, all of them together, as far as was seen
};

}  // namespace fos::supervision
