// Where submissions are compiled: a work folder with a pristine copy of all that a stage is built
// from, and nothing else. References, solutions and submissions are not in it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grading/box/box.hpp"

namespace fos::grading {

/// What a stage is built with, as CMake builds it.
struct StageBuild {
  std::filesystem::path compiler;                ///< its real path
  std::vector<std::string> flags;                ///< as for the stage programs, without -Werror
  std::filesystem::path source_folder;           ///< the toolkit's
  std::filesystem::path generated;               ///< what CMake wrote
  std::filesystem::path stage_main;              ///< an object file
  std::vector<std::filesystem::path> libraries;  ///< of ours, in the linker's order
  std::vector<std::filesystem::path> system_libraries;
  std::filesystem::path inside;  ///< the program fos_box_inside
};

/// This build tree's own.
StageBuild this_build();

/// The precompiled headers: what every stage includes, and with what lecture 3 has built.
enum class Headers { stage, stage_and_closest_hit };

/// The work folder. It is made at the start and is gone at the end.
///
/// Its files are read-only, and the box's users may read them, so no folder above it may be closed
/// to them: one below the system's folder for temporary files will do.
class Workshop {
 public:
  /// Copies what is needed. Throws std::filesystem::filesystem_error.
  Workshop(StageBuild build, std::filesystem::path folder);
  ~Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;

  /// Precompiles the headers, in a box. False where that fails: then stages are compiled without,
  /// which takes longer and gives the same.
  bool precompile(const Box& box);

  const std::filesystem::path& folder() const { return folder_; }
  /// The program for the box, where its users can read it.
  std::filesystem::path inside() const { return folder_ / "inside"; }
  /// A place for what is compiled, which no box's user can list.
  std::filesystem::path programs() const { return folder_ / "programs"; }
  /// The folder of a slot, which its box may use.
  std::filesystem::path slot(unsigned number) const;

  /// For a stage of this lecture: an errand for the compiler, without its source and output.
  /// Lecture 3 does not see fos/closest_hit.hpp.
  Errand compiler_errand(int lecture, Headers headers, bool sanitized) const;

  /// The words that link a stage program, after its source.
  std::vector<std::string> linker_words() const;

  /// Places as a student knows them: labs/…, common/include/….
  std::string readable(std::string words) const;

 private:
  std::filesystem::path kit(int lecture) const;

  StageBuild build_;
  std::filesystem::path folder_;
  bool precompiled_[2] = {false, false};
};

}  // namespace fos::grading
