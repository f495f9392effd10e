// Who is who: an instructor's list of the students, and which hand-in is whose.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "csv.hpp"
#include "hand_in.hpp"

namespace fos::grading {

struct Student {
  std::string name;
  std::string username;
  std::string number;       ///< the student's own
  std::string participant;  ///< Moodle's, for this assignment
  std::string email;
  int line = 1;
};

struct Roster {
  std::string file;
  std::vector<Student> students;
};

/// A table whose first row names its columns, in English or Greek, as the platforms export them:
/// username, name (or first name and surname), number (AM, ID number, SID), e-mail, Moodle's
/// identifier. Other columns are ignored. Throws TableError.
Roster read_roster(const std::filesystem::path& path);
Roster make_roster(const Table& table);

/// What was found out.
struct Matching {
  std::vector<std::string> words;  ///< what does not match, ready to print, a line each
  std::size_t matched = 0;         ///< hand-ins
};

/// Gives each hand-in the name, username, number and mail of its student: by number, username or
/// mail, else by name, in any order of its words and in either alphabet. Where two students would
/// do, none is taken.
Matching match(const Roster& roster, std::vector<Whose>& hand_ins);

}  // namespace fos::grading
