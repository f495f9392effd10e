// What a platform would refuse, said before anyone uploads a file.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "summary.hpp"

namespace fos::grading {

struct Objection {
  std::string id;  ///< of the submission; empty where it is the whole file
  std::string words;
  bool left_out = true;  ///< whether its row is not written, so that the other rows are accepted
};
using Objections = std::vector<Objection>;

/// What a platform's file of a whole class is written with.
struct ClassFile {
  Feedback feedback = Feedback::full;
  /// Hundredths: what the assignment there is worth. 0 for what the submissions are worth here.
  int maximum = 0;
};

/// What every file of marks needs: a final mark from 0 to the maximum.
void object_to_marks(Objections& out, std::span<const Summary> all, const ClassFile& file);

/// A user of each submission, none of them empty, none twice and each as it will be read; `user`
/// gives the user as the platform will read it. `no_user` is said where there is none.
struct Identity {
  std::string user;
  bool is_safe = true;  ///< what is written is read as the user
};
void object_to_users(Objections& out, std::span<const Summary> all, std::span<const Identity> users,
                     const std::string& no_user);

bool is_left_out(const Objections& objections, const std::string& id);

/// One line for a person: whose row, in which file, and why.
std::string objection_words(const Objection& objection, const std::string& file);

}  // namespace fos::grading
