// What the probe tries in the box, to see that the fences stand.
#pragma once

namespace fos::grading::inside {

/// try-all SECRET… -- PID…: 0 if no secret can be read, no process in PID… reached, nothing written
/// where it starts' parent is, and no socket opened; else the number of the first that could. An
/// empty SECRET list is fine.
int run_trial(int count, char** words);

/// Its answers.
enum Trial { fenced = 0, read_a_secret = 10, wrote_outside, reached_a_process, opened_a_socket };

}  // namespace fos::grading::inside
