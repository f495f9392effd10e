#include "landlock.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>

namespace fos::grading::inside {
namespace {

// The kernel's numbers, of which the distribution's headers may know the older ones only.
constexpr std::uint64_t execute = 1 << 0;
constexpr std::uint64_t write_file = 1 << 1;
constexpr std::uint64_t read_file = 1 << 2;
constexpr std::uint64_t read_folder = 1 << 3;
constexpr std::uint64_t make_special = (1 << 6) | (1 << 9) | (1 << 10) | (1 << 11);
constexpr std::uint64_t of_files = execute | write_file | read_file | (1 << 14) | (1 << 15);
constexpr int accesses_by_version[] = {0, 13, 14, 15, 15, 16};

struct Ruleset {
  std::uint64_t files;
  std::uint64_t network;  // version 4
  std::uint64_t scope;    // version 6
};
constexpr std::uint64_t both_directions = 3;  // bind and connect of TCP
constexpr std::uint64_t sockets_and_signals = 3;

/// Of a file, only the accesses that a file has are taken.
bool add(int rules, const char* path, std::uint64_t accesses) {
  landlock_path_beneath_attr rule{};
  rule.parent_fd = open(path, O_PATH | O_CLOEXEC);
  if (rule.parent_fd < 0) return false;
  struct stat status {};
  const bool known = fstat(rule.parent_fd, &status) == 0;
  rule.allowed_access = known && S_ISDIR(status.st_mode) ? accesses : accesses & of_files;
  const long added = syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
  close(rule.parent_fd);
  return known && added == 0;
}

}  // namespace

int landlock_version(int most) {
  const long version =
      syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version <= 0) return 0;
  return static_cast<int>(most > 0 ? std::min<long>(version, most) : version);
}

bool fence_files(const Settings& settings) {
  const int version = landlock_version(settings.landlock_abi);
  if (version == 0) {
    errno = ENOSYS;
    return false;
  }
  Ruleset ruleset{};
  ruleset.files = (std::uint64_t{1} << accesses_by_version[std::min(version, 5)]) - 1;
  std::size_t size = sizeof(ruleset.files);
  if (version >= 4) {
    ruleset.network = both_directions;
    size += sizeof(ruleset.network);
  }
  if (version >= landlock_with_signals) {
    ruleset.scope = sockets_and_signals;
    size += sizeof(ruleset.scope);
  }
  const long made = syscall(SYS_landlock_create_ruleset, &ruleset, size, 0);
  if (made < 0) return false;
  const int rules = static_cast<int>(made);
  const std::uint64_t reading = execute | read_file | read_folder;
  const std::uint64_t writing = ruleset.files & ~make_special & ~execute;
  bool fenced = true;
  for (const auto& path : settings.read) fenced = fenced && add(rules, path.c_str(), reading);
  for (const auto& path : settings.write) fenced = fenced && add(rules, path.c_str(), writing);
  for (const auto& path : settings.device) {
    fenced = fenced && add(rules, path.c_str(), read_file | write_file);
  }
  fenced = fenced && syscall(SYS_landlock_restrict_self, rules, 0) == 0;
  const int error = errno;
  close(rules);
  errno = error;
  return fenced;
}

}  // namespace fos::grading::inside
