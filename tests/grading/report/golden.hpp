// Texts against the files of tests/grading/report/golden.
#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "catch2.hpp"

namespace fos::grading {

/// The text is that of the file, byte for byte. With FOS_UPDATE_GOLDEN=1 the file is written
/// instead: look at what `git diff` says of it.
inline void check_golden(const std::string& text, const std::string& name) {
  const std::string path = std::string(FOS_GOLDEN) + "/" + name;
  if (std::getenv("FOS_UPDATE_GOLDEN") != nullptr) std::ofstream(path, std::ios::binary) << text;
  std::ifstream in(path, std::ios::binary);
  const std::string expected{std::istreambuf_iterator<char>(in), {}};
  INFO(name);
  CHECK(text == expected);
}

/// The language of the texts, as long as it lives.
class InLanguage {
 public:
  explicit InLanguage(const char* language) {
    if (const char* now = std::getenv("FOS_LANG")) before_ = now;
    setenv("FOS_LANG", language, 1);
  }
  ~InLanguage() { setenv("FOS_LANG", before_.c_str(), 1); }
  InLanguage(const InLanguage&) = delete;
  InLanguage& operator=(const InLanguage&) = delete;

 private:
  std::string before_;
};

}  // namespace fos::grading
