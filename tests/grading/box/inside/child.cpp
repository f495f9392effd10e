#include "child.hpp"

#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <vector>

#include "census.hpp"
#include "filter.hpp"
#include "landlock.hpp"

namespace fos::grading::inside {
namespace {

using Resource = __rlimit_resource_t;

bool limit(Resource resource, rlim_t most, rlim_t more = 0) {
  rlimit now{};
  getrlimit(resource, &now);
  rlimit wanted{most, most + more};
  if (now.rlim_max != RLIM_INFINITY && wanted.rlim_max > now.rlim_max) {  // a stricter one holds
    wanted.rlim_max = now.rlim_max;
    wanted.rlim_cur = wanted.rlim_cur > now.rlim_max ? now.rlim_max : wanted.rlim_cur;
  }
  return setrlimit(resource, &wanted) == 0;
}

bool set_limits(const Settings& settings) {
  // The kernel counts all that this user has. Where others come and go meanwhile, there is slack,
  // and the supervisor's own count decides.
  const rlim_t threads_before = settings.shared_user ? threads_of_user() + 256 : 0;
  // One second more before the kernel kills: what is told by SIGXCPU can still leave its pixels.
  return limit(RLIMIT_CPU, settings.cpu_seconds, 1) &&
         (settings.address_space == 0 || limit(RLIMIT_AS, settings.address_space)) &&
         limit(RLIMIT_FSIZE, settings.file_size) && limit(RLIMIT_NOFILE, settings.descriptors) &&
         limit(RLIMIT_NPROC, threads_before + settings.processes) && limit(RLIMIT_CORE, 0) &&
         limit(RLIMIT_MEMLOCK, 1 << 16) && limit(RLIMIT_MSGQUEUE, 0) &&
         limit(RLIMIT_STACK, 64 << 20);
}

bool become_user(uid_t user) {
  if (user == 0) return true;
  return setgroups(0, nullptr) == 0 && setresgid(user, user, user) == 0 &&
         setresuid(user, user, user) == 0;
}

void signals_as_usual() {
  for (int signal = 1; signal < NSIG; ++signal) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

Failure prepare_and_exec(const Settings& settings) {
  if (setsid() < 0) return {Step::session, errno};
  // As root first where the path leads through folders of root's; a program's folder is its own.
  if (!settings.folder.empty() && chdir(settings.folder.c_str()) != 0) {
    return {Step::folder, errno};
  }
  if (!become_user(settings.user)) return {Step::user, errno};
  if (!set_limits(settings)) return {Step::limits, errno};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return {Step::privileges, errno};
  if (settings.landlock && !fence_files(settings)) return {Step::landlock, errno};
  signals_as_usual();
  std::vector<char*> environment;
  for (const auto& entry : settings.environment) {
    environment.push_back(const_cast<char*>(entry.c_str()));
  }
  environment.push_back(nullptr);
  if (!filter_calls(settings)) return {Step::filter, errno};
  execve(settings.command[0], settings.command, environment.data());
  return {Step::exec, errno};
}

}  // namespace

void become_program(const Settings& settings, int errors) {
  const Failure failure = prepare_and_exec(settings);
  [[maybe_unused]] const ssize_t told = write(errors, &failure, sizeof(failure));
  _exit(127);
}

}  // namespace fos::grading::inside
