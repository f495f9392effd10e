// What the tests of the intake ask most often.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "intake.hpp"

namespace fos::grading {

/// The file of a stage.
inline const StageFile& file_of(const HandIn& hand_in, std::string_view stage) {
  return *std::find_if(hand_in.files.begin(), hand_in.files.end(),
                       [&](const StageFile& file) { return file.stage == stage; });
}

/// What PATH holds, where it is one submission.
inline HandIn read_one(const std::filesystem::path& path) {
  const ClassFiles files = read_class(path, stages);
  if (files.size() != 1) throw std::runtime_error("not one submission: " + files.words());
  return files.read(0);
}

inline bool has_note(const HandIn& hand_in, std::string_view words) {
  return std::any_of(hand_in.notes.begin(), hand_in.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
}

inline std::vector<std::string> ids_of(const ClassFiles& files) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < files.size(); ++i) ids.push_back(files.whose(i).id);
  return ids;
}

}  // namespace fos::grading
