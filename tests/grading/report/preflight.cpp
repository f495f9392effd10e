#include "preflight.hpp"

#include <algorithm>
#include <map>

#include "clean_text.hpp"
#include "fos/text.hpp"

namespace fos::grading {

void object_to_marks(Objections& out, std::span<const Summary> all, const ClassFile& file) {
  for (const Summary& one : all) {
    const int maximum = file.maximum > 0 ? file.maximum : one.most;
    if (!is_settled(one)) {
      out.push_back({one.id, say(text::report_no_mark)});
    } else if (one.points > maximum) {
      out.push_back({one.id, say(text::report_above_maximum,
                                 {points_text(one.points), points_text(maximum)})});
    } else if (one.points < 0) {
      out.push_back({one.id, say(text::report_below_zero, {points_text(one.points)})});
    }
  }
}

void object_to_users(Objections& out, std::span<const Summary> all, std::span<const Identity> users,
                     const std::string& no_user) {
  std::map<std::string, std::vector<std::size_t>> whose;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (users[i].user.empty()) {
      out.push_back({all[i].id, no_user});
    } else if (!users[i].is_safe) {
      out.push_back({all[i].id, say(text::report_bad_user, {one_line(users[i].user)})});
    } else {
      whose[users[i].user].push_back(i);
    }
  }
  for (const auto& [user, indices] : whose) {
    if (indices.size() < 2) continue;
    for (const std::size_t i : indices) {
      const std::size_t other = indices[indices[0] == i ? 1 : 0];
      out.push_back({all[i].id, say(text::report_same_user, {user, all[other].id})});
    }
  }
}

bool is_left_out(const Objections& objections, const std::string& id) {
  return std::any_of(objections.begin(), objections.end(), [&](const Objection& objection) {
    return objection.left_out && objection.id == id;
  });
}

std::string objection_words(const Objection& objection, const std::string& file) {
  if (objection.left_out) {
    return say(text::report_left_out, {objection.id, file, objection.words});
  }
  if (objection.id.empty()) return file + ": " + objection.words;
  return say(text::report_objection, {file, objection.id, objection.words});
}

}  // namespace fos::grading
