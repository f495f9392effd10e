// Results as JSON, and back. What is read back equals what was written, byte for byte.
//
// The first line of a result has what a journal asks for, and the CRC-32 of all after it, so that
// damage is found also where it leaves JSON behind.
//
// A text that is no UTF-8 (what a student's program printed) is {"bytes": "…"} with each byte as
// the character of its number, since JSON has no other way to keep it.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "result.hpp"

namespace fos::grading {

/// What is read is no result, or not a whole one: it is damaged, or of another version of the
/// toolkit.
class JsonError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The version of the format, in each file.
inline constexpr int json_format = 1;

/// What a journal asks of a result.
struct ResultHead {
  std::string id;
  std::string key;
  Status status = Status::not_judged;
};

/// A file's whole text, with a line end. A time that is not finite is written as 0.
std::string to_json(const SubmissionResult& result);
std::string to_json(const Run& run);

/// Throws JsonError for anything that to_json() would not have written: a key too few or too many,
/// a number out of its range, an id or a picture's name that is a path.
SubmissionResult result_from_json(std::string_view json);
Run run_from_json(std::string_view json);

/// The first line only, which is all that takes time in a class of thousands; that the rest is
/// whole is known by its sum. Throws JsonError.
ResultHead head_from_json(std::string_view json);

}  // namespace fos::grading
