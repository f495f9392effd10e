// PFM, the portable float map, which OpenImageIO does not write: a text header, then rows of
// little-endian floats from the BOTTOM up (Debevec, "PFM portable floatmap image format").
#include <fmt/core.h>

#include <bit>
#include <cerrno>
#include <fstream>
#include <system_error>

#include "fos/whole_file.hpp"
#include "picture_target.hpp"

namespace fos {
namespace {

class Pfm : public PictureWriter::Target {
 public:
  Pfm(const std::filesystem::path& path, const FrameHeader& header)
      : file_(path), out_(file_.temporary(), std::ios::binary), height_(header.height) {
    const double scale = std::endian::native == std::endian::little ? -1.0 : 1.0;
    out_ << fmt::format("PF\n{} {}\n{:.1f}\n", header.width, header.height, scale);
    start_ = out_.tellp();
  }

  void write(int row, const std::vector<long double>& colors) override {
    const std::vector<float> floats(colors.begin(), colors.end());
    const auto bytes = static_cast<std::streamoff>(floats.size() * sizeof(float));
    out_.seekp(start_ + (height_ - 1 - row) * bytes);
    out_.write(reinterpret_cast<const char*>(floats.data()), bytes);
    require();
  }

  void finish() override {
    out_.close();
    require();
    file_.commit();
  }

 private:
  void require() const {
    if (!out_) throw file_.write_error(std::generic_category().message(errno));
  }

  WholeFile file_;
  std::ofstream out_;
  std::streamoff start_ = 0;
  int height_;
};

}  // namespace

std::unique_ptr<PictureWriter::Target> make_pfm(const std::filesystem::path& path,
                                                const FrameHeader& header) {
  return std::make_unique<Pfm>(path, header);
}

}  // namespace fos
