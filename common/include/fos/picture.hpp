// The picture door: the one place that knows OpenImageIO. Everything else deals in rows and bytes.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fos/bitmap.hpp"
#include "fos/frame.hpp"

namespace fos {

enum class PictureFormat { png, exr, tiff, pfm };

/// By the file's extension, in any case: .png, .exr, .tif or .tiff, .pfm.
std::optional<PictureFormat> picture_format(const std::filesystem::path& path);

/// What EXR and TIFF carry beside the pixels.
struct PictureInfo {
  std::string command;     ///< how the picture was made
  std::string scene_text;  ///< of what
};

/// A picture being written row by row, from the top, so that its size is no matter.
///   PNG   the bytes of the byte rule
///   EXR   channel / 255, linear, not clamped, as float
///   TIFF  the same, as float for a frame of floats and as double otherwise
///   PFM   channel as it is, 0..255, as float; without OpenImageIO
/// Unwritten and non-finite pixels are written as frame.hpp's shown() has them.
/// Throws FileError; the file appears at finish() or not at all.
class PictureWriter {
 public:
  PictureWriter(const std::filesystem::path& path, const FrameHeader& header,
                const PictureInfo& info);
  ~PictureWriter();

  void write(const Row& row);
  void finish();

  class Target;  ///< one format's way to write rows; in the sources

 private:
  std::unique_ptr<Target> target_;
  FrameHeader header_;
  int row_ = 0;
};

/// Panels in a grid of `columns`, each scaled to fit a square of `panel_size` pixels, its label
/// below it, as a PNG. Throws FileError.
void write_sheet(const std::filesystem::path& path, const std::vector<Panel>& panels, int columns,
                 int panel_size);

/// A PNG of exactly these pixels. Throws FileError.
void write_png(const std::filesystem::path& path, const Bitmap& bitmap);

/// What the first picture would wait for, beyond the start of the program: the font.
void warm_up_pictures();

}  // namespace fos
