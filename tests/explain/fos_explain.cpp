// fos_explain: one pixel, step by step. `./lab explain` calls it.
//   fos_explain --stage ID --scene F [--program P] COLUMN ROW
#include <getopt.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "explanation.hpp"
#include "fos/text.hpp"
#include "oracle.hpp"

namespace {

using namespace fos;

struct Options {
  const Stage* stage = nullptr;
  std::filesystem::path scene;
  std::optional<std::filesystem::path> program;
  int column = 0;
  int row = 0;
};

/// A wrong command line, in words.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

int parse_number(std::string_view word) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || number < 0) {
    throw UsageError(say(text::tool_usage));
  }
  return number;
}

Options parse_options(int argc, char** argv) {
  Options options;
  std::string_view id;
  const option known[] = {{"stage", required_argument, nullptr, 'g'},
                          {"scene", required_argument, nullptr, 's'},
                          {"program", required_argument, nullptr, 'p'},
                          {}};
  for (int which = 0; (which = getopt_long(argc, argv, "", known, nullptr)) != -1;) {
    switch (which) {
      case 'g':
        id = optarg;
        break;
      case 's':
        options.scene = optarg;
        break;
      case 'p':
        options.program = optarg;
        break;
      default:
        throw UsageError(say(text::tool_usage));
    }
  }
  const auto stage = std::find_if(std::begin(stages), std::end(stages),
                                  [&](const Stage& each) { return each.id == id; });
  if (stage == std::end(stages) || options.scene.empty() || argc - optind != 2) {
    throw UsageError(say(text::tool_usage));
  }
  options.stage = stage;
  options.column = parse_number(argv[optind]);
  options.row = parse_number(argv[optind + 1]);
  return options;
}

/// At most some lines of what the stage said.
void repeat(const std::string& words) {
  constexpr int most = 5;
  std::istringstream lines(words);
  int count = 0;
  for (std::string line; std::getline(lines, line) && count < most; ++count) {
    std::cerr << line << '\n';
  }
}

int explain_pixel(int argc, char** argv) {
  const Options options = parse_options(argc, argv);
  SceneText scene = read_scene_text(options.scene);
  if (options.column >= scene.canvas_width || options.row >= scene.canvas_height) {
    throw UsageError(
        say(text::explain_outside,
            {std::to_string(options.column), std::to_string(options.row),
             std::to_string(scene.canvas_width - 1), std::to_string(scene.canvas_height - 1)}));
  }
  for (const std::string& warning : scene_warnings(scene)) std::cerr << warning << '\n';
  const char* no_color = std::getenv("NO_COLOR");
  const bool colors = isatty(STDOUT_FILENO) == 1 && (no_color == nullptr || *no_color == '\0');
  const Explanation explanation =
      explain({scene, *options.stage, options.column, options.row}, options.program, colors);
  repeat(explanation.words);
  std::cout << explanation.text << std::flush;
  return explanation.status;
}

int failed(int status, const std::string& message) {
  std::cerr << say(text::tool_error) << ": " << message << '\n';
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return explain_pixel(argc, argv);
  } catch (const UsageError& error) {
    return failed(2, error.what());
  } catch (const SceneError& error) {
    std::cerr << error.what() << '\n';
    return 2;
  } catch (const std::range_error& error) {  // numbers that exact arithmetic is not made for
    return failed(2, say(text::trade_too_extreme, {error.what()}));
  } catch (const reference::UndecidedError& error) {
    return failed(2, say(text::trade_too_extreme, {error.what()}));
  } catch (const std::exception& error) {
    return failed(3, error.what());
  }
}
