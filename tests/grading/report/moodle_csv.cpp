#include "escape.hpp"
#include "fos/text.hpp"
#include "platforms.hpp"
#include "report_words.hpp"

namespace fos::grading {
namespace {

const std::string& user_of(const Summary& one, MoodleUser user) {
  return user == MoodleUser::email ? one.email : one.username;
}

std::string_view column(MoodleUser user) {
  return user == MoodleUser::email      ? "useremail"
         : user == MoodleUser::username ? "username"
                                        : "useridnumber";
}

}  // namespace

std::string moodle_csv(std::span<const Summary> all, const ClassFile& file, MoodleUser user) {
  const Objections objections = moodle_preflight(all, file, user);
  std::string out = std::string(column(user)) + ",grade,feedback\n";
  for (const Summary& one : all) {
    if (is_left_out(objections, one.id)) continue;
    out += csv_cell(user_of(one, user)) + "," + points_text(one.points) + "," +
           csv_cell(comment(file.feedback, one)) + "\n";
  }
  return out;
}

Objections moodle_preflight(std::span<const Summary> all, const ClassFile& file, MoodleUser user) {
  Objections out;
  std::vector<Identity> users;
  for (const Summary& one : all) {
    const std::string& whose = user_of(one, user);
    // PHP takes "0" for nothing, and the row is skipped there without a word.
    users.push_back({whose, is_plain_cell(whose) && whose != "0"});
  }
  const bool email = user == MoodleUser::email;
  object_to_users(out, all, users, say(email ? text::report_no_email : text::report_no_username));
  object_to_marks(out, all, file);
  return out;
}

}  // namespace fos::grading
