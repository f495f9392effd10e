// What `./lab grade` is told.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "fos/stage_list.hpp"
#include "grading/box/level.hpp"
#include "grading/report/report_files.hpp"
#include "result.hpp"

namespace fos::grading {

/// The message is ready to print; exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct GradeOptions {
  std::filesystem::path path;                 ///< what is graded
  std::vector<std::filesystem::path> merged;  ///< --merge: instead, the results of all parts
  bool one = false;              ///< --one: `path` is one submission, whatever it looks like
  bool list = false;             ///< --list: only says what would be graded
  std::filesystem::path output;  ///< DIR
  std::filesystem::path root;    ///< of the toolkit's tree
  std::filesystem::path build;   ///< its build folder
  unsigned jobs = 0;             ///< 0: one a processor
  unsigned part = 1;             ///< the part-th of `parts` equal shares of the class
  unsigned parts = 1;
  std::optional<std::uint64_t> seed;
  std::vector<const Stage*> stages;  ///< in the course's order; all of them by default
  std::set<ReportFormat> formats;
  Feedback feedback = Feedback::full;
  std::filesystem::path roster;
  std::filesystem::path overrides;
  std::optional<Level> box;  ///< this level or nothing
  bool unsafe = false;
};

/// Throws UsageError.
GradeOptions parse_grade_options(const std::vector<std::string>& arguments);

}  // namespace fos::grading
