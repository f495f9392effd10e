#include "picture_of_check.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace fos {

bool write_picture(const std::filesystem::path& picture_program, const std::filesystem::path& path,
                   const std::vector<Panel>& panels) {
  // The shell gets the paths as variables, so that no character in them means anything to it.
  setenv("FOS_SHEET_PROGRAM", picture_program.c_str(), 1);
  setenv("FOS_SHEET_PATH", path.c_str(), 1);
  // A picture program that is not there must not take the report with it.
  std::signal(SIGPIPE, SIG_IGN);
  std::FILE* sheet = popen(R"("$FOS_SHEET_PROGRAM" sheet 3 400 "$FOS_SHEET_PATH")", "w");
  if (sheet == nullptr) return false;
  for (const Panel& panel : panels) {
    const std::string bytes = encode(panel);
    std::fwrite(bytes.data(), 1, bytes.size(), sheet);
  }
  return pclose(sheet) == 0;
}

}  // namespace fos
