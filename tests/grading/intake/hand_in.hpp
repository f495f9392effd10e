// What one student has handed in, as far as it matters: five small files, or why not.
#pragma once

#include <string>
#include <vector>

namespace fos::grading {

/// Why a stage's file is not taken.
enum class Why {
  none,  ///< it is taken
  missing,
  twice,      ///< copies that differ, and none lies where the kit has it
  not_text,   ///< neither UTF-8 nor Windows-1253, or with NUL in it
  too_large,  ///< over most_file
  link,
  special,    ///< a device, a pipe …
  encrypted,  ///< in a zip with a password
  damaged     ///< cannot be unpacked, or read
};

struct StageFile {
  std::string stage;    ///< its id
  std::string content;  ///< UTF-8; empty where it is not taken
  Why why = Why::none;
  std::string words;  ///< why it is not taken, in the language of this process; else empty
};

/// Whose it is, as far as the name of the folder or zip tells, or the platform's own list.
struct Whose {
  std::string id;  ///< unique in the class; [a-z0-9._-], at most 73 bytes; the same at every run
  std::string name;
  std::string username;
  std::string number;  ///< a student's number (Open eClass, Gradescope) or Moodle's participant
  std::string email;
  std::string source;  ///< the file or folder below PATH; "." for PATH itself
};

struct HandIn {
  Whose whose;
  std::vector<StageFile> files;    ///< one for each stage, in the course's order
  std::vector<std::string> notes;  ///< what an instructor should know of it, in words
};

}  // namespace fos::grading
