#include "picture_serve.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "fos/picture.hpp"
#include "fos/picture_job.hpp"

namespace fos {
namespace {

void make(const PictureJob& job) {
  if (job.panel_size == 0) {
    write_png(job.path, job.panels.front().bitmap);
  } else {
    write_sheet(job.path, job.panels, static_cast<int>(job.panels.size()), job.panel_size);
  }
}

/// The answer is a line, whatever is in it.
std::string one_line(std::string words) {
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words;
}

}  // namespace

int serve_pictures(std::istream& in, std::ostream& out) {
  warm_up_pictures();
  for (;;) {
    std::optional<PictureJob> job;
    try {
      job = read_picture_job(in);
    } catch (const std::runtime_error& error) {
      out << one_line(error.what()) << std::endl;
      return 2;  // where the next job begins is not known any more
    }
    if (!job) return 0;
    try {
      make(*job);
      out << picture_made << std::endl;
    } catch (const std::exception& error) {
      out << one_line(error.what()) << std::endl;
    }
  }
}

}  // namespace fos
