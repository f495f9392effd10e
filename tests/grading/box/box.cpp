#include "grading/box/box.hpp"

#include <unistd.h>

#include <array>
#include <system_error>
#include <utility>

namespace fos::grading {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view level_names[] = {"bubblewrap", "landlock", "uid", "none"};

constexpr const char* inside_program = "/box/inside";
constexpr unsigned first_user = 65533;  // one less for each slot: nobody's, in any distribution
constexpr const char* devices[] = {"/dev/null", "/dev/zero", "/dev/urandom", "/dev/random"};

/// The system's folders that a program needs, and those that a compiler needs as well. /usr/local
/// and /etc are not among them.
constexpr const char* library_folders[] = {"/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/libx32",
                                           "/lib",     "/lib32",     "/lib64",     "/libx32"};
constexpr const char* compiler_folders[] = {"/usr/bin", "/usr/include", "/usr/libexec", "/bin"};

/// A compiler from elsewhere brings its own folder, PREFIX of PREFIX/bin/g++.
fs::path other_prefix(const fs::path& compiler) {
  const fs::path prefix = compiler.parent_path().parent_path();
  return prefix == "/usr" || prefix == "/" || prefix.empty() ? fs::path() : prefix;
}

std::vector<fs::path> system_folders(const Errand& errand, const BoxSetting& setting) {
  std::vector<fs::path> folders(std::begin(library_folders), std::end(library_folders));
  if (errand.compiler) {
    folders.insert(folders.end(), std::begin(compiler_folders), std::end(compiler_folders));
    if (const auto prefix = other_prefix(setting.compiler); !prefix.empty()) {
      folders.push_back(prefix);
    }
  }
  std::erase_if(folders, [](const fs::path& folder) { return !fs::exists(folder); });
  return folders;
}

/// With each name that something has inside put where it really is.
std::string placed(std::string word, const std::vector<Shown>& shown) {
  for (const auto& [host, inside] : shown) {
    for (std::size_t at = 0; (at = word.find(inside, at)) != std::string::npos;) {
      word.replace(at, inside.size(), host.string());
      at += host.string().size();
    }
  }
  return word;
}

std::vector<std::string> limits_as_words(const BoxLimits& limits) {
  const auto number = [](const char* name, auto value) { return name + std::to_string(value); };
  return {number("cpu=", limits.cpu_seconds),
          number("memory=", limits.memory),
          number("address-space=", limits.address_space ? 2 * limits.memory : 0),
          number("file-size=", limits.file_size),
          number("written=", limits.written),
          number("processes=", limits.processes),
          number("idle=", limits.idle_seconds)};
}

template <class Words>
void append(std::vector<std::string>& to, const Words& words) {
  to.insert(to.end(), std::begin(words), std::end(words));
}

void append(std::vector<std::string>& to, std::initializer_list<std::string> words) {
  to.insert(to.end(), words);
}

void empty(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) fs::remove_all(entry.path());
}

}  // namespace

std::string_view name(Level level) { return level_names[static_cast<std::size_t>(level)]; }

std::optional<Level> level_named(std::string_view word) {
  for (const Level level : levels) {
    if (word == name(level)) return level;
  }
  return std::nullopt;
}

Box::Box(BoxSetting setting, unsigned slot, fs::path scratch)
    : setting_(std::move(setting)),
      user_(geteuid() == 0 ? first_user - slot : 0),
      scratch_(std::move(scratch)) {
  fs::create_directories(scratch_);
  fs::permissions(scratch_, fs::perms::owner_all);
  if (user_ != 0 && chown(scratch_.c_str(), user_, user_) != 0) {
    throw fs::filesystem_error("chown", scratch_, std::error_code(errno, std::generic_category()));
  }
}

std::vector<std::string> Box::command(const Errand& errand) const {
  if (!errand.folder.empty() && user_ != 0 && chown(errand.folder.c_str(), user_, user_) != 0) {
    throw fs::filesystem_error("chown", errand.folder,
                               std::error_code(errno, std::generic_category()));
  }
  return setting_.level == Level::bubblewrap ? bubblewrap(errand) : supervisor(errand);
}

std::vector<std::string> Box::bubblewrap(const Errand& errand) const {
  std::vector<std::string> words;
  // Limits on processes are counted by user, and not at all for root.
  if (user_ != 0) append(words, {setting_.inside.string(), "become", std::to_string(user_), "--"});
  append(words, {bubblewrap_program,
                 "--unshare-user",
                 "--unshare-ipc",
                 "--unshare-pid",
                 "--unshare-net",
                 "--unshare-uts",
                 "--unshare-cgroup-try",
                 "--disable-userns",
                 "--uid",
                 "65534",
                 "--gid",
                 "65534",
                 "--hostname",
                 "box",
                 "--die-with-parent",
                 "--new-session",
                 "--as-pid-1",
                 "--cap-drop",
                 "ALL",
                 "--clearenv"});
  for (const auto& folder : system_folders(errand, setting_)) {
    if (fs::is_symlink(folder)) {
      append(words, {"--symlink", fs::read_symlink(folder).string(), folder.string()});
    } else {
      append(words, {"--ro-bind", folder.string(), folder.string()});
    }
  }
  for (const char* device : devices) append(words, {"--dev-bind", device, device});
  append(words, {"--proc", "/proc", "--ro-bind", setting_.inside.string(), inside_program});
  for (const auto& [host, inside] : errand.shown) {
    append(words, {"--ro-bind", host.string(), inside});
  }
  const std::string size = std::to_string(errand.limits.written + errand.limits.written / 4);
  if (errand.folder.empty()) {
    append(words, {"--size", size, "--tmpfs", "/tmp", "--symlink", "/tmp", inside_folder});
  } else {
    append(words,
           {"--size", size, "--tmpfs", "/tmp", "--bind", errand.folder.string(), inside_folder});
  }
  // The root itself is in memory, of any size: nothing is written there.
  append(words, {"--remount-ro", "/", "--", inside_program, "alone=1"});
  append(words, limits_as_words(errand.limits));
  append(words, {std::string("folder=") + inside_folder, std::string("scratch=") + inside_folder});
  append(words, {"env=PATH=/usr/bin:/bin", "env=HOME=/tmp", "env=LC_ALL=C.UTF-8"});
  for (const auto& entry : errand.environment) append(words, {"env=" + entry});
  append(words, {"--"});
  append(words, errand.words);
  return words;
}

std::vector<std::string> Box::supervisor(const Errand& errand) const {
  fs::path folder = errand.folder;
  if (folder.empty()) {
    empty(scratch_);
    folder = scratch_;
  }
  std::vector<Shown> places = errand.shown;
  places.push_back({folder, inside_folder});

  std::vector<std::string> words{setting_.inside.string()};
  append(words, limits_as_words(errand.limits));
  if (user_ != 0) {
    append(words, {"user=" + std::to_string(user_)});
  } else {
    append(words, {"shared-user=1"});
  }
  if (setting_.level == Level::none) append(words, {"lenient=1"});
  if (setting_.level == Level::landlock) {
    append(words, {"landlock=" + std::to_string(setting_.landlock_abi)});
    for (const auto& system : system_folders(errand, setting_)) {
      append(words, {"read=" + system.string()});
    }
    for (const auto& [host, inside] : errand.shown) append(words, {"read=" + host.string()});
    append(words, {"read=/proc/self", "write=" + folder.string()});
    for (const char* device : devices) append(words, {std::string("device=") + device});
  }
  append(words, {"folder=" + folder.string(), "scratch=" + folder.string()});
  append(words, {"env=PATH=/usr/bin:/bin", "env=HOME=" + folder.string(),
                 "env=TMPDIR=" + folder.string(), "env=LC_ALL=C.UTF-8"});
  for (const auto& entry : errand.environment) append(words, {"env=" + placed(entry, places)});
  append(words, {"--"});
  for (const auto& word : errand.words) append(words, {placed(word, places)});
  return words;
}

}  // namespace fos::grading
