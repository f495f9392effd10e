// `fos_watch --root ROOT --build BUILD --stage STAGE [--measure N]`: what ./lab watch runs. BUILD
// is the build folder that has the stages' programs. --measure saves the file N times, unchanged,
// and says how long each verdict took.
//
// Exit status: 0 the last verdict was that all is right, 1 it was not, 2 wrong usage, 3 the
// toolkit's own trouble, 128 and its number after a signal: 130 for Ctrl-C.
#include <algorithm>
#include <charconv>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "fos/text.hpp"
#include "watch.hpp"

namespace {

using namespace fos;

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const Stage& stage_of(const std::string& id) {
  const auto stage = std::find_if(std::begin(stages), std::end(stages),
                                  [&](const Stage& each) { return each.id == id; });
  if (stage == std::end(stages)) throw UsageError(id);
  return *stage;
}

int count_of(const std::string& word) {
  int count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size() || count < 1) {
    throw UsageError(word);
  }
  return count;
}

WatchOptions parse(const std::vector<std::string>& arguments) {
  WatchOptions options;
  for (std::size_t i = 0; i < arguments.size(); i += 2) {
    const std::string& name = arguments[i];
    if (i + 1 == arguments.size()) throw UsageError(name);
    const std::string& value = arguments[i + 1];
    if (name == "--root") {
      options.places.root = std::filesystem::canonical(value);
    } else if (name == "--build") {
      options.places.build = std::filesystem::canonical(value);
    } else if (name == "--stage") {
      options.stage = &stage_of(value);
    } else if (name == "--measure") {
      options.measure = count_of(value);
    } else {
      throw UsageError(name);
    }
  }
  if (options.places.root.empty() || options.places.build.empty() || options.stage == nullptr) {
    throw UsageError("");
  }
  return options;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Watch(parse({argv + 1, argv + argc})).run();
  } catch (const UsageError& error) {
    std::cerr << "fos_watch: " << say(text::watch_usage, {error.what()}) << '\n';
    return 2;
  } catch (const std::exception& error) {
    std::cerr << say(text::tool_error) << ": " << error.what() << '\n';
    return 3;
  }
}
