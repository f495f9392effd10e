#include "roster.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <sstream>

#include "file_names.hpp"
#include "fos/text.hpp"

namespace fos::grading {
namespace {

// What the columns are called, by latin(): "Όνομα χρήστη" is `onoma christi`.
constexpr std::string_view username_columns[] = {"username",      "user name",    "login",   "user",
                                                 "onoma christi", "sis login id", "login id"};
constexpr std::string_view name_columns[] = {
    "name", "full name", "student", "student name", "onomateponymo", "foititis", "eponymo onoma"};
constexpr std::string_view first_name_columns[] = {"first name", "given name", "firstname",
                                                   "onoma"};
constexpr std::string_view surname_columns[] = {"last name", "surname", "lastname", "family name",
                                                "eponymo"};
constexpr std::string_view number_columns[] = {
    "number",           "student number", "student id",  "id number",          "sid", "am", "a m",
    "arithmos mitroou", "idnumber",       "sis user id", "arithmos tautotitas"};
constexpr std::string_view email_columns[] = {
    "email", "e mail", "email address", "mail", "dieuthynsi email", "ilektroniko tachydromeio"};
constexpr std::string_view participant_columns[] = {"identifier", "participant", "anagnoristiko"};

std::string sorted_words(std::string_view name) {
  std::istringstream words{latin(name)};
  std::set<std::string> sorted;
  for (std::string word; words >> word;) sorted.insert(word);
  std::string out;
  for (const std::string& word : sorted) out += word + " ";
  return out;
}

/// Students by some property; two of one value are nobody's.
class Index {
 public:
  void add(const std::string& key, std::size_t student) {
    if (key.empty()) return;
    const auto [place, is_new] = students_.try_emplace(key, student);
    if (!is_new && place->second != student) place->second = std::nullopt;
  }
  std::optional<std::size_t> find(const std::string& key) const {
    const auto found = students_.find(key);
    return found == students_.end() ? std::nullopt : found->second;
  }

 private:
  std::map<std::string, std::optional<std::size_t>> students_;
};

/// The digits of Moodle's "Participant 123", or of "Συμμετέχων 123".
std::string digits_of(std::string_view text) {
  const std::size_t at = text.find_first_of("0123456789");
  return at == std::string_view::npos ? "" : std::string(text.substr(at));
}

class Matcher {
 public:
  explicit Matcher(const Roster& roster) {
    known_.reserve(roster.students.size());
    for (std::size_t i = 0; i < roster.students.size(); ++i) {
      const Student& student = roster.students[i];
      for (const std::string* key : {&student.username, &student.number, &student.email}) {
        exact_.add(lower(*key), i);
      }
      exact_.add(lower(student.email.substr(0, student.email.find('@'))), i);
      participants_.add(digits_of(student.participant), i);
      names_.add(sorted_words(student.name), i);
      known_.push_back(sorted_words(student.name) + latin(student.username) + " ");
    }
  }

  std::optional<std::size_t> find(const Whose& whose) const {
    if (const auto found = participants_.find(whose.number)) return found;
    for (const std::string* key : {&whose.number, &whose.email, &whose.name, &whose.id}) {
      if (const auto found = exact_.find(lower(*key))) return found;
    }
    if (const auto found = names_.find(sorted_words(whose.name))) return found;
    const auto found = by_a_word(whose.name);
    return found && !is_another(whose.name, *found) ? found : std::nullopt;
  }

 private:
  /// Whether a hand-in of this name, which has a student's username in it, tells of somebody else:
  /// a username may be a first name. What has a digit, or three letters, is nobody's name.
  bool is_another(const std::string& name, std::size_t student) const {
    const std::string own = " " + known_[student];
    std::istringstream words{latin(name)};
    for (std::string word; words >> word;) {
      const bool is_name = word.size() > 3 && word.find_first_of("0123456789") == std::string::npos;
      if (is_name && own.find(" " + word + " ") == std::string::npos) return true;
    }
    return false;
  }

  /// `up1234567_lab4`: one word of the name is a username or a number, and no other student's.
  std::optional<std::size_t> by_a_word(const std::string& name) const {
    std::istringstream words{latin(name)};
    std::optional<std::size_t> student;
    for (std::string word; words >> word;) {
      const auto found = word.size() < 4 ? std::nullopt : exact_.find(word);
      if (!found) continue;
      if (student && student != found) return std::nullopt;
      student = found;
    }
    return student;
  }

  Index exact_;
  Index participants_;
  Index names_;
  std::vector<std::string> known_;  ///< of each student: the words of the name, and the username
};

}  // namespace

Roster read_roster(const std::filesystem::path& path) { return make_roster(read_table(path)); }

Roster make_roster(const Table& table) {
  const std::vector<std::string> columns = column_names(table);
  const auto column = [&](std::span<const std::string_view> names) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (std::find(names.begin(), names.end(), columns[i]) != names.end())
        return std::optional<std::size_t>(i);
    }
    return std::optional<std::size_t>();
  };
  const auto username = column(username_columns);
  const auto name = column(name_columns);
  const auto first_name = column(first_name_columns);
  const auto surname = column(surname_columns);
  const auto number = column(number_columns);
  const auto email = column(email_columns);
  const auto participant = column(participant_columns);
  if (!username && !number && !email) {
    throw TableError(table.file, table.rows.empty() ? 1 : table.rows.front().line,
                     say(text::intake_roster_columns));
  }
  Roster roster;
  roster.file = table.file;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const TableRow& row = table.rows[i];
    const auto cell = [&](const std::optional<std::size_t>& at) {
      return at && *at < row.cells.size() ? row.cells[*at] : std::string();
    };
    Student student;
    student.line = row.line;
    student.name = cell(name);
    if (first_name || surname) {
      const std::string parts = cell(first_name) + " " + cell(surname);
      if (student.name.empty() && parts.size() > 1) student.name = parts;
    }
    student.username = cell(username);
    student.number = cell(number);
    student.email = cell(email);
    student.participant = cell(participant);
    roster.students.push_back(std::move(student));
  }
  return roster;
}

Matching match(const Roster& roster, std::vector<Whose>& hand_ins) {
  const Matcher matcher(roster);
  Matching matching;
  std::vector<std::vector<std::string>> owned(roster.students.size());
  for (Whose& whose : hand_ins) {
    const auto found = matcher.find(whose);
    if (!found) {
      matching.words.push_back(
          say(text::intake_no_student, {shown_path(whose.source), roster.file}));
      continue;
    }
    const Student& student = roster.students[*found];
    owned[*found].push_back(shown_path(whose.source));
    ++matching.matched;
    if (!student.name.empty()) whose.name = student.name;
    if (!student.username.empty()) whose.username = student.username;
    if (!student.number.empty()) whose.number = student.number;
    if (!student.email.empty()) whose.email = student.email;
  }
  for (std::size_t i = 0; i < owned.size(); ++i) {
    const Student& student = roster.students[i];
    const std::string line = std::to_string(student.line);
    const std::string who =
        shown_path(student.name.empty() ? student.username + student.number : student.name);
    if (owned[i].empty()) {
      matching.words.push_back(say(text::intake_no_hand_in, {roster.file, line, who}));
    } else if (owned[i].size() > 1) {
      matching.words.push_back(
          say(text::intake_two_hand_ins, {roster.file, line, who, owned[i][0], owned[i][1]}));
    }
  }
  return matching;
}

}  // namespace fos::grading
