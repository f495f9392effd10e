// How the files of a class are laid out: which part of a path is the student.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "container.hpp"
#include "fos/stage_list.hpp"
#include "intake.hpp"

namespace fos::grading {

/// What was listed of PATH: the files of interest, and the names near the top.
struct Listing {
  std::vector<FileEntry> files;       ///< of interest (stage_finder.hpp), clutter left out
  std::set<std::string> folders;      ///< paths of the folders, at most four deep
  std::set<std::string> other_files;  ///< of no interest, at most three folders deep
  std::vector<FileEntry> metadata;    ///< Gradescope's lists of names

  void add(const FileEntry& entry, std::span<const Stage> stages);
};

/// One hand-in: its files.
struct HandInFiles {
  Whose whose;  ///< without an id yet
  std::vector<FileEntry> files;
};

struct Layout {
  ClassKind kind = ClassKind::one;
  std::string root;  ///< the folders around everything, with a '/' at the end, or empty
  std::vector<HandInFiles> hand_ins;
  std::vector<std::string> left_out;  ///< files that are nobody's
};

/// Decides by what is there. `name` is what PATH is called, without `.zip`.
Layout find_layout(const Listing& listing, const std::string& name, std::span<const Stage> stages);

/// All that is there is one person's.
Layout layout_of_one(const Listing& listing, const std::string& name);

}  // namespace fos::grading
