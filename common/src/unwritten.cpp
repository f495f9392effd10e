#include "unwritten.hpp"

#include <cstdio>
#include <set>
#include <string>
#include <utility>

#include "fos/stage.hpp"
#include "fos/text.hpp"

namespace fos {

bool unwritten_raised = false;

Unwritten unwritten(const char* what, const char* file, int line) {
  static std::set<std::pair<std::string, int>> said;
  unwritten_raised = true;
  // Called for every pixel: the set is asked only when the place is not the last one again.
  static std::pair<const char*, int> last{nullptr, 0};
  if (std::exchange(last, {file, line}) != std::pair{file, line} &&
      said.emplace(file, line).second) {
    const std::string message = say(text::stage_unwritten, {file, std::to_string(line), what});
    std::fprintf(stderr, "%s\n", message.c_str());
  }
  return {};
}

}  // namespace fos
