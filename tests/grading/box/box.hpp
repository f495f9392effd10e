// The box: how a program that nobody trusts is started.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grading/box/errand.hpp"
#include "grading/box/level.hpp"

namespace fos::grading {

struct BoxSetting {
  Level level = Level::bubblewrap;
  std::filesystem::path inside;    ///< the program fos_box_inside, where the box's user can read it
  std::filesystem::path compiler;  ///< the real path of the C++ compiler
  int landlock_abi = 0;            ///< for tests: at most this version of Landlock
};

inline constexpr const char* bubblewrap_program = "/usr/bin/bwrap";

/// One place to run things, one at a time. Two boxes with different slots share nothing.
class Box {
 public:
  /// `scratch` is a folder for this slot alone, made and emptied by the box: where there is no
  /// memory file system, an errand without a folder starts there.
  Box(BoxSetting setting, unsigned slot, std::filesystem::path scratch);

  /// The command that does the errand: it has a supervisor's descriptor (fos/supervision.hpp).
  /// Prepares the errand's folder. Throws std::filesystem::filesystem_error.
  std::vector<std::string> command(const Errand& errand) const;

  Level level() const { return setting_.level; }

  /// The user and group that programs in this box are to the system outside; 0 where they are the
  /// caller's own.
  unsigned user() const { return user_; }

 private:
  std::vector<std::string> bubblewrap(const Errand& errand) const;
  std::vector<std::string> supervisor(const Errand& errand) const;

  BoxSetting setting_;
  unsigned user_;
  std::filesystem::path scratch_;
};

}  // namespace fos::grading
