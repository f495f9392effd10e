// `fos_hint --state FOLDER [--all|--reset] STAGE`: what ./lab hint says. FOLDER remembers which
// hint of which stage was the last.
//
// Exit status: 0 done, 2 wrong usage, 3 it cannot be remembered (the hint is told all the same).
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "ladder.hpp"

namespace {

using namespace fos;

const Stage* stage_of(const std::string& id) {
  const auto stage = std::find_if(std::begin(stages), std::end(stages),
                                  [&](const Stage& each) { return each.id == id; });
  return stage == std::end(stages) ? nullptr : &*stage;
}

int wrong_usage() {
  std::cerr << say(text::tool_error) << ": " << say(text::tool_usage) << '\n';
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool has_option = arguments.size() == 4;
  if (!(arguments.size() == 3 || has_option) || arguments[0] != "--state") return wrong_usage();
  const std::string option = has_option ? arguments[2] : "";
  const Stage* stage = stage_of(arguments.back());
  if (stage == nullptr) return wrong_usage();

  Ladder ladder(*stage, arguments[1]);
  try {
    if (option == "--all") {
      std::cout << ladder.all();
    } else if (option == "--reset") {
      ladder.forget();
      std::cout << say(text::hint_forgotten, {stage->id}) << '\n';
    } else if (option.empty()) {
      std::cout << ladder.next() << std::flush;
      ladder.remember();
    } else {
      return wrong_usage();
    }
  } catch (const FileError& error) {
    std::cerr << say(text::hint_not_remembered, {error.what()}) << '\n';
    return 3;
  }
  return 0;
}
