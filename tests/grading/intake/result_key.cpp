#include "result_key.hpp"

#include "digest.hpp"

namespace fos::grading {
namespace {

/// With its length before it, so that no two lists of texts run together to the same.
void add(std::string& all, std::string_view text) {
  all += std::to_string(text.size());
  all += ':';
  all += text;
}

}  // namespace

std::string result_key(const HandIn& hand_in, std::uint64_t seed, std::string_view toolkit,
                       std::string_view settings) {
  std::string all;
  add(all, std::to_string(seed));
  add(all, toolkit);
  add(all, settings);
  for (const StageFile& file : hand_in.files) {
    add(all, file.stage);
    add(all, std::to_string(static_cast<int>(file.why)));
    add(all, file.content);
  }
  return sha256(all);
}

}  // namespace fos::grading
