// How course platforms name what they collect, and what that says of whose it is.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "hand_in.hpp"

namespace fos::grading {

/// Moodle (mod_assign): `Full Name_12345_assignsubmission_file_REST`, for a folder with an empty
/// REST, else for each file. The number is the participant's, as in Moodle's grading worksheet.
struct MoodleName {
  std::string name;
  std::string number;
  std::size_t rest;  ///< where REST begins
};
std::optional<MoodleName> moodle_name(std::string_view file);

/// Open eClass (modules/work): `Given Surname1234567.zip`, in Latin letters, the student's number
/// right after the name; several files are in a folder of that name. Without a number, all is name.
Whose eclass_name(std::string_view stem);

/// `work_12`: the folder around all that Open eClass gives.
bool is_eclass_folder(std::string_view name);

/// Gradescope's submission_metadata.yml: names, numbers and mails by folder. Of a group, all names.
/// What is no such file gives nothing.
std::map<std::string, Whose> gradescope_names(std::string_view yaml);

}  // namespace fos::grading
