// What its work module does with a row is in its source, modules/work/import.php: every cell is
// trimmed and empty ones are dropped; two or three must be left, the second a number from 0 to the
// maximum.
#include <algorithm>

#include "clean_text.hpp"
#include "escape.hpp"
#include "fos/text.hpp"
#include "platforms.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

/// Whether the spreadsheet library there leaves the cell as it is: what looks like another number
/// (00123, 1e5, a very long one) or a formula it would change, and of a parenthesis it takes the
/// inside.
bool is_read_as_written(std::string_view user) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (user.find('(') != std::string_view::npos) return false;
  if (std::all_of(user.begin(), user.end(), is_digit)) return user.size() < 16 && user[0] != '0';
  const bool begins_with_letter = (user[0] >= 'A' && user[0] <= 'Z') ||
                                  (user[0] >= 'a' && user[0] <= 'z') ||
                                  static_cast<unsigned char>(user[0]) >= 0x80;
  std::string lower;
  for (const char c : user) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return begins_with_letter && lower != "true" && lower != "false" && is_plain_cell(user);
}

/// The first cell: the username, in parentheses where it would be changed without. Empty where
/// neither will do.
std::string user_cell(const std::string& user) {
  if (user.empty() || is_read_as_written(user)) return user;
  const std::string cell = "(" + user + ")";
  const bool readable = user.find_first_of("()") == std::string::npos && is_plain_cell(cell);
  return readable && user.find_first_not_of(' ') == 0 && !user.ends_with(' ') ? cell : "";
}

/// The comment as the third cell must be: no number, which would count as a grade where the grade
/// is missing.
bool is_comment(std::string_view words) {
  return !words.empty() && std::string_view("0123456789+-.= ").find(words[0]) == std::string::npos;
}

}  // namespace

std::string eclass_csv(std::span<const Summary> all, const ClassFile& file) {
  const Objections objections = eclass_preflight(all, file);
  std::string out;
  for (const Summary& one : all) {
    if (is_left_out(objections, one.id)) continue;
    out += csv_cell(user_cell(one.username)) + "," + points_text(one.points) + "," +
           csv_cell(comment(file.feedback, one)) + "\n";
  }
  return out;
}

Objections eclass_preflight(std::span<const Summary> all, const ClassFile& file) {
  Objections out;
  std::vector<Identity> users;
  for (const Summary& one : all) {
    users.push_back({one.username, !user_cell(one.username).empty()});
    const std::string words = comment(file.feedback, one);
    if (!is_comment(words)) {
      out.push_back({one.id, say(text::report_odd_comment, {shortened(words, 40)})});
    }
  }
  object_to_users(out, all, users, say(text::report_no_username));
  object_to_marks(out, all, file);
  return out;
}

}  // namespace fos::grading
