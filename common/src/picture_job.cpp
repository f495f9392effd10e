#include "fos/picture_job.hpp"

#include <fmt/core.h>

#include <stdexcept>

namespace fos {
namespace {

constexpr std::size_t most_panels = 100;
constexpr std::size_t longest_path = 4096;
constexpr int largest_panel = 4096;

}  // namespace

std::string encode(const PictureJob& job) {
  const std::string path = job.path.string();
  std::string bytes =
      fmt::format("picture {} {} {}\n{}", job.panel_size, job.panels.size(), path.size(), path);
  for (const Panel& panel : job.panels) bytes += encode(panel);
  return bytes;
}

std::optional<PictureJob> read_picture_job(std::istream& in) {
  if (in.peek() == std::istream::traits_type::eof()) return std::nullopt;
  PictureJob job;
  std::string word;
  std::size_t panels = 0;
  std::size_t path_bytes = 0;
  in >> word >> job.panel_size >> panels >> path_bytes;
  const bool fits = word == "picture" && in.get() == '\n' && panels >= 1 && panels <= most_panels &&
                    path_bytes >= 1 && path_bytes <= longest_path && job.panel_size >= 0 &&
                    job.panel_size <= largest_panel && (job.panel_size > 0 || panels == 1);
  if (!fits) throw std::runtime_error("not a picture to make");
  std::string path(path_bytes, '\0');
  in.read(path.data(), static_cast<std::streamsize>(path_bytes));
  job.path = path;
  while (job.panels.size() < panels) job.panels.push_back(read_panel(in));
  return job;
}

}  // namespace fos
