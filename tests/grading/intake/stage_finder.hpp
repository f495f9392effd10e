// Finds the stage files among all that someone has handed in.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "container.hpp"
#include "fos/stage_list.hpp"
#include "hand_in.hpp"
#include "limits.hpp"

namespace fos::grading {

/// Whether an entry of a container is worth keeping: a stage's file, an archive, another source
/// file (which may be one under a wrong name), or what could not be looked at.
bool is_of_interest(const FileEntry& entry, std::span<const Stage> stages);

class StageFinder {
 public:
  explicit StageFinder(std::span<const Stage> stages) : stages_(stages), copies_(stages.size()) {}

  /// Looks through these entries of a container, and through the zips among them. `shown` goes
  /// before their paths in notes.
  void look(Container& container, std::vector<FileEntry> entries, const std::string& shown,
            int nested = 0);

  /// Looks through a zip that is the hand-in itself.
  void look_in_zip(Container& container, const FileEntry& zip, const std::string& shown,
                   int nested = 0);

  /// Adds what an instructor should know; from most_notes on they are no longer kept.
  void note(std::string words);

  /// One for each stage; the notes are complete after it.
  std::vector<StageFile> files();
  std::vector<std::string> notes() const;

 private:
  struct Copy {
    std::string path;  ///< as shown
    std::string content;
    Why why = Why::none;
    const char* encoding = "UTF-8";
  };

  void found(Container& container, const FileEntry& entry, const std::string& path,
             std::size_t stage);
  StageFile choose(std::size_t stage);
  StageFile choose_among(std::size_t stage, std::vector<const Copy*> copies);

  std::span<const Stage> stages_;
  std::vector<std::vector<Copy>> copies_;
  std::vector<std::string> notes_;
  std::vector<std::string> about_files_;  ///< these come first, and are never left out
  std::vector<std::string> others_;       ///< source files of other names
  std::size_t unpacked_left_ = most_unpacked;
  int zips_left_ = most_zips;
  bool notes_full_ = false;
};

}  // namespace fos::grading
