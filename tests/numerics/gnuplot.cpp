#include "gnuplot.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "fos/text.hpp"
#include "fos/whole_file.hpp"

namespace fos::numerics {
namespace {

/// A nameless file that holds `words`, to be read from its beginning.
std::unique_ptr<std::FILE, int (*)(std::FILE*)> nameless_file(const std::string& words) {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), std::fclose);
  if (file == nullptr || std::fputs(words.c_str(), file.get()) < 0 ||
      std::fflush(file.get()) != 0) {
    throw PlotError(say(text::trade_gnuplot_failed, {"-"}));
  }
  std::rewind(file.get());
  lseek(fileno(file.get()), 0, SEEK_SET);
  return file;
}

/// gnuplot's exit status; its input is the script, its output the file.
int run_gnuplot(int script, const std::filesystem::path& output) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, script, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, output.c_str(), O_WRONLY | O_TRUNC, 0);
  char name[] = "gnuplot";
  char no_settings_of_the_person[] = "--default-settings";
  char* const arguments[] = {name, no_settings_of_the_person, nullptr};
  pid_t process = 0;
  const int error = posix_spawnp(&process, name, &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw PlotError(say(text::trade_no_gnuplot));
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

PlotFormat plot_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return PlotFormat::png;
  if (extension == ".svg") return PlotFormat::svg;
  throw std::invalid_argument(say(text::trade_bad_plot, {path.string()}));
}

std::string quoted(const std::string& words) {
  std::string out = "'";
  for (const char c : words) {
    if (c == '\'') out += '\'';
    out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return out + "'";
}

void draw(const std::string& script, const std::filesystem::path& path) {
  WholeFile file(path);
  const auto input = nameless_file(script);
  const int status = run_gnuplot(fileno(input.get()), file.temporary());
  if (status != 0 || std::filesystem::file_size(file.temporary()) == 0) {
    throw PlotError(say(text::trade_gnuplot_failed, {std::to_string(status)}));
  }
  file.commit();
}

}  // namespace fos::numerics
