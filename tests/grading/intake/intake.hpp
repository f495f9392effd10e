// All that a class has handed in, by whatever way the files were collected, one hand-in at a time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "fos/stage_list.hpp"
#include "hand_in.hpp"

namespace fos::grading {

/// PATH is nothing that can be graded; the message is ready to print. `exit_status` is 2.
class IntakeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  int exit_status = 2;
};

/// What PATH holds.
enum class ClassKind {
  one,        ///< one submission
  folder,     ///< a folder, or a zip, of submissions: a folder or a zip each
  moodle,     ///< what Moodle's "Download all submissions" gives, in folders or not
  eclass,     ///< what the Εργασίες of Open eClass give
  gradescope  ///< what Gradescope's "Export Submissions" gives
};

/// The hand-ins of a class. Only their names are in memory; read() gets one. Not for two threads at
/// once: the zip is read at one place at a time.
class ClassFiles {
 public:
  ClassFiles(ClassFiles&& other) noexcept;
  ClassFiles& operator=(ClassFiles&& other) noexcept;
  ~ClassFiles();

  ClassKind kind() const;
  /// What PATH was taken for, and with how many hand-ins, in words.
  std::string words() const;
  /// What an instructor should know that is no hand-in's own: files that were left out.
  const std::vector<std::string>& notes() const;

  std::size_t size() const;
  const Whose& whose(std::size_t i) const;
  /// A hand-in whose files are gone or broken is read too: its files say why.
  HandIn read(std::size_t i) const;

 private:
  friend ClassFiles read_class(const std::filesystem::path& path, std::span<const Stage> stages,
                               bool one);
  struct Contents;
  explicit ClassFiles(std::unique_ptr<Contents> contents);
  std::unique_ptr<Contents> contents_;
};

/// Looks at PATH, and lists the hand-ins in it in the order of their ids. With `one` it is a single
/// one, whatever it looks like. Throws IntakeError.
ClassFiles read_class(const std::filesystem::path& path, std::span<const Stage> stages,
                      bool one = false);

}  // namespace fos::grading
