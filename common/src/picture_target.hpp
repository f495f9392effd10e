// How one format takes rows; picture.cpp and pfm.cpp each make some.
#pragma once

#include "fos/picture.hpp"

namespace fos {

class PictureWriter::Target {
 public:
  virtual ~Target() = default;
  /// `colors` as shown: 3 a pixel, 0..255, not clamped. Rows come in order from the top.
  virtual void write(int row, const std::vector<long double>& colors) = 0;
  virtual void finish() = 0;
};

std::unique_ptr<PictureWriter::Target> make_pfm(const std::filesystem::path& path,
                                                const FrameHeader& header);

}  // namespace fos
