// What the probe tries in the box, to see that the fences stand.
#pragma once

namespace fos::grading::inside {

/// try-all SECRET… -- PID…: whether a secret can be read (it is printed which) or written to, a
/// process reached, a file made in the system's folders, or a socket opened.
int run_trial(int count, char** words);

/// The answers: the first that can, or `fenced`.
enum Trial { fenced = 0, read_a_secret = 10, wrote_outside, reached_a_process, opened_a_socket };

}  // namespace fos::grading::inside
