#include "ladder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "layout.hpp"
#include "stage_test.hpp"

namespace fos {
namespace {

long number_in(const std::filesystem::path& path) {
  long number = 0;
  std::ifstream in(path);
  return in >> number ? number : 0;
}

}  // namespace

Ladder::Ladder(const Stage& stage, std::filesystem::path folder)
    : stage_(stage), folder_(std::move(folder)) {
  const long last = std::ssize(stage_test(stage.id).hints);
  reached_ = static_cast<std::size_t>(std::clamp(number_in(folder_ / stage.id), 0L, last));
}

std::string Ladder::hint(std::size_t number) const {
  const auto& hints = stage_test(stage_.id).hints;
  return say(text::hint_which, {stage_.id, std::to_string(number), std::to_string(hints.size())}) +
         "\n" + wrapped(say(hints.at(number - 1)), 2) + "\n";
}

std::string Ladder::end() const {
  const Text& chapter = stage_.terms == 0 ? text::hint_chapter_rays : text::hint_chapter_light;
  return wrapped(say(text::hint_last, {stage_.id, say(chapter)}));
}

std::string Ladder::next() {
  const std::size_t last = stage_test(stage_.id).hints.size();
  reached_ = std::min(reached_ + 1, last);
  return hint(reached_) + (reached_ < last ? wrapped(say(text::hint_next, {stage_.id})) : end());
}

std::string Ladder::all() const {
  std::string out;
  for (std::size_t i = 1; i <= stage_test(stage_.id).hints.size(); ++i) out += hint(i);
  return out + end();
}

void Ladder::remember() const {
  std::error_code error;  // what is wrong with the folder, the file says
  std::filesystem::create_directories(folder_, error);
  write_whole_file(folder_ / stage_.id, std::to_string(reached_) + "\n");
}

void Ladder::forget() {
  reached_ = 0;
  remember();
}

}  // namespace fos
