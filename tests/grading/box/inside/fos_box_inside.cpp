// fos_box_inside SETTING=VALUE… -- PROGRAM ARGUMENT…: supervises a program in the box.
// fos_box_inside become USER -- PROGRAM ARGUMENT…: the same program as another user, for good.
// fos_box_inside try-… …: what the probe runs in the box (trials.hpp).
//
// It is linked statically and is all of ours that the box holds.
#include <grp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <string_view>

#include "settings.hpp"
#include "supervise.hpp"
#include "trials.hpp"

namespace {

constexpr int wrong_usage = 125;

int become(int count, char** words) {
  uid_t user = 0;
  if (count < 5) return wrong_usage;
  const std::string_view number = words[2];
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), user);
  if (error != std::errc() || *end != '\0' || std::string_view(words[3]) != "--") {
    return wrong_usage;
  }
  const bool became = setgroups(0, nullptr) == 0 && setresgid(user, user, user) == 0 &&
                      setresuid(user, user, user) == 0 &&
                      prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                      // Changing the user has cleared it. (If the parent has gone meanwhile, the
                      // socket to it is shut, and what comes next ends by that.)
                      prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
  if (became) execv(words[4], words + 4);
  return wrong_usage;
}

}  // namespace

int main(int count, char** words) {
  using namespace fos::grading::inside;
  const std::string_view first = count > 1 ? words[1] : "";
  if (first == "become") return become(count, words);
  if (first.starts_with("try-")) return run_trial(count, words);
  Settings settings;
  if (!parse(count, words, settings)) return wrong_usage;
  supervise(settings);
}
