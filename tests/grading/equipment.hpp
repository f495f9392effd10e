// What it takes to grade, made only where there is something to grade: it takes seconds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "grade_options.hpp"
#include "grading/box/workshop.hpp"
#include "submission_grader.hpp"

namespace fos::grading {

/// A folder for this run where the box's users can come, gone at its end.
class WorkFolder {
 public:
  WorkFolder();  ///< throws FileError
  ~WorkFolder();
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  std::filesystem::path path() const { return path_; }

 private:
  std::string path_;
};

class Equipment {
 public:
  /// Finds the strongest box that holds here, and says it; precompiles the headers; draws the
  /// scenes of the seed. Throws FileError where there is no box.
  Equipment(const GradeOptions& options, const Shares& shares, std::uint64_t seed);

  const Course& course() const { return course_; }
  std::filesystem::path scratch() const { return work_.path(); }

 private:
  WorkFolder work_;
  Workshop workshop_;
  Course course_;
};

}  // namespace fos::grading
