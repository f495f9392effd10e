#include "fos/picture.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "fos/whole_file.hpp"
#include "picture_target.hpp"

namespace fos {
namespace {

constexpr const char* font = "DejaVuSans";

const char* oiio_name(PictureFormat format) {
  switch (format) {
    case PictureFormat::png:
      return "png";
    case PictureFormat::exr:
      return "openexr";
    case PictureFormat::tiff:
      return "tiff";
    case PictureFormat::pfm:
      break;
  }
  return nullptr;
}

OIIO::TypeDesc pixel_type(PictureFormat format, Precision precision) {
  if (format == PictureFormat::png) return OIIO::TypeDesc::UINT8;
  const bool as_double = format == PictureFormat::tiff && precision != Precision::binary32;
  return as_double ? OIIO::TypeDesc::DOUBLE : OIIO::TypeDesc::FLOAT;
}

/// A file that OpenImageIO writes to and that knows whether all of it arrived: its own file for PNG
/// forgets the errors of a full disk.
class CheckedFile : public OIIO::Filesystem::IOProxy {
 public:
  explicit CheckedFile(const std::filesystem::path& path)
      : IOProxy(path.string(), Write), out_(path, std::ios::binary) {}

  const char* proxytype() const override { return "checked"; }
  std::int64_t tell() override { return out_.tellp(); }
  bool seek(std::int64_t offset) override { return static_cast<bool>(out_.seekp(offset)); }
  std::size_t write(const void* bytes, std::size_t count) override {
    errno = 0;
    out_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
    if (!out_ && error_ == 0) error_ = errno;
    return count;  // OpenImageIO would print its own words for each write that fails
  }
  /// Closes the file; whether everything is in it.
  bool finish() {
    errno = 0;
    out_.close();
    if (out_.fail() && error_ == 0) error_ = errno;
    return error_ == 0 && !out_.fail();
  }
  int error() const { return error_; }

 private:
  std::ofstream out_;
  int error_ = 0;  // errno of the first failure
};

/// PNG, EXR or TIFF through OpenImageIO, a scanline at a time.
class Oiio : public PictureWriter::Target {
 public:
  Oiio(const std::filesystem::path& path, PictureFormat format, const FrameHeader& header,
       const PictureInfo& info)
      : file_(path), out_(OIIO::ImageOutput::create(oiio_name(format))) {
    if (!out_) throw file_.write_error(OIIO::geterror());
    if (format == PictureFormat::png) {  // the others report such errors themselves
      checked_ = std::make_unique<CheckedFile>(file_.temporary());
      out_->set_ioproxy(checked_.get());
    }
    OIIO::ImageSpec spec(header.width, header.height, 3, pixel_type(format, header.precision));
    type_ = spec.format;
    if (format != PictureFormat::png) {
      spec.attribute("compression", "zip");
      spec.attribute("Software", "Fos");
      spec.attribute("ImageDescription", info.command + "\n\n" + info.scene_text);
    }
    require(out_->open(file_.temporary().string(), spec));
  }

  /// A picture that is not finished is thrown away; libpng need not tell the terminal about it.
  ~Oiio() override {
    if (finished_) return;
    std::fflush(stderr);
    const int kept = dup(STDERR_FILENO);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDERR_FILENO);
    out_.reset();
    dup2(kept, STDERR_FILENO);
    close(nowhere);
    close(kept);
  }
  Oiio(const Oiio&) = delete;
  Oiio& operator=(const Oiio&) = delete;

  void write(int row, const std::vector<long double>& colors) override {
    if (type_ == OIIO::TypeDesc::UINT8) {
      std::vector<std::uint8_t> bytes(colors.size());
      std::transform(colors.begin(), colors.end(), bytes.begin(), to_byte);
      write_bytes(row, bytes.data());
    } else {
      std::vector<double> linear(colors.size());
      std::transform(colors.begin(), colors.end(), linear.begin(),
                     [](long double channel) { return static_cast<double>(channel / 255); });
      require(out_->write_scanline(row, 0, OIIO::TypeDesc::DOUBLE, linear.data()));
    }
  }

  void write_bytes(int row, const std::uint8_t* bytes) {
    require(out_->write_scanline(row, 0, OIIO::TypeDesc::UINT8, bytes));
  }

  void finish() override {
    require(out_->close());
    require(!checked_ || checked_->finish());
    finished_ = true;
    file_.commit();
  }

 private:
  void require(bool done) const {
    if (done) return;
    const int error = checked_ && checked_->error() != 0 ? checked_->error() : errno;
    const std::string words = out_->geterror();
    const bool known = words.empty() || (checked_ && checked_->error() != 0);
    throw file_.write_error(known ? std::generic_category().message(error) : words);
  }

  WholeFile file_;
  std::unique_ptr<CheckedFile> checked_;
  std::unique_ptr<OIIO::ImageOutput> out_;
  OIIO::TypeDesc type_;
  bool finished_ = false;
};

std::vector<long double> shown_row(int row, const Row& pixels) {
  std::vector<long double> colors(pixels.channels.size());
  for (std::size_t i = 0; i < pixels.unwritten.size(); ++i) {
    const auto color = shown(std::span<const long double, 3>(&pixels.channels[3 * i], 3),
                             pixels.unwritten[i] != 0, static_cast<int>(i), row);
    std::copy(color.begin(), color.end(), colors.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  return colors;
}

OIIO::ImageBuf as_image(const Bitmap& bitmap) {
  // OpenImageIO takes the pixels as not const, but only reads them.
  const OIIO::ImageBuf whole(OIIO::ImageSpec(bitmap.width, bitmap.height, 3, OIIO::TypeDesc::UINT8),
                             const_cast<std::uint8_t*>(bitmap.rgb.data()));
  return OIIO::ImageBufAlgo::copy(whole);
}

/// `bitmap` scaled to fit a square.
OIIO::ImageBuf fitted(const Bitmap& bitmap, int size) {
  const int longest = std::max(bitmap.width, bitmap.height);
  if (longest == size) return as_image(bitmap);
  const auto scaled = [&](int side) {
    return std::max(1, static_cast<int>(static_cast<long>(side) * size / longest));
  };
  const int width = scaled(bitmap.width);
  const int height = scaled(bitmap.height);
  // OpenImageIO's resize would give the same in ten times the time.
  if (longest > size) return as_image(shrunk(bitmap, width, height));
  // Enlarged pixel by pixel, so that each can be seen.
  const OIIO::ROI roi(0, width, 0, height, 0, 1, 0, 3);
  return OIIO::ImageBufAlgo::resample(as_image(bitmap), false, roi);
}

void write_rows(const std::filesystem::path& path, int width, int height,
                const std::uint8_t* bytes) {
  Oiio out(path, PictureFormat::png, {width, height}, {});
  for (int row = 0; row < height; ++row) {
    out.write_bytes(row, bytes + static_cast<std::ptrdiff_t>(3) * width * row);
  }
  out.finish();
}

}  // namespace

std::optional<PictureFormat> picture_format(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".png") return PictureFormat::png;
  if (extension == ".exr") return PictureFormat::exr;
  if (extension == ".tif" || extension == ".tiff") return PictureFormat::tiff;
  if (extension == ".pfm") return PictureFormat::pfm;
  return std::nullopt;
}

PictureWriter::PictureWriter(const std::filesystem::path& path, const FrameHeader& header,
                             const PictureInfo& info)
    : header_(header) {
  const PictureFormat format = picture_format(path).value_or(PictureFormat::png);
  if (format == PictureFormat::pfm) {
    target_ = make_pfm(path, header);
  } else {
    target_ = std::make_unique<Oiio>(path, format, header, info);
  }
}

PictureWriter::~PictureWriter() = default;

void PictureWriter::write(const Row& row) {
  target_->write(row_, shown_row(row_, row));
  ++row_;
}

void PictureWriter::finish() { target_->finish(); }

void write_sheet(const std::filesystem::path& path, const std::vector<Panel>& panels, int columns,
                 int panel_size) {
  const int gap = std::max(4, panel_size / 25);
  const int font_size = std::max(11, panel_size / 16);
  const int cell_width = panel_size + gap;
  const int cell_height = panel_size + 2 * font_size + gap;
  const int count = static_cast<int>(panels.size());
  const int rows = (count + columns - 1) / columns;
  OIIO::ImageBuf sheet(OIIO::ImageSpec(std::min(count, columns) * cell_width + gap,
                                       rows * cell_height + gap, 3, OIIO::TypeDesc::UINT8));
  const float paper[] = {0.96F, 0.96F, 0.96F};
  const float ink[] = {0.1F, 0.1F, 0.1F};
  OIIO::ImageBufAlgo::fill(sheet, paper);
  for (int i = 0; i < count; ++i) {
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    const int left = gap + i % columns * cell_width;
    const int top = gap + i / columns * cell_height;
    const OIIO::ImageBuf picture = fitted(panel.bitmap, panel_size);
    OIIO::ImageBufAlgo::paste(sheet, left + (panel_size - picture.spec().width) / 2,
                              top + (panel_size - picture.spec().height) / 2, 0, 0, picture);
    const int text_width = OIIO::ImageBufAlgo::text_size(panel.label, font_size, font).width();
    const int fitted_size =
        text_width > panel_size ? font_size * panel_size / text_width : font_size;
    // Without the font the sheet is still worth having, so a label that cannot be drawn is left
    // out.
    OIIO::ImageBufAlgo::render_text(sheet, left + panel_size / 2,
                                    top + panel_size + 3 * font_size / 2, panel.label, fitted_size,
                                    font, ink, OIIO::ImageBufAlgo::TextAlignX::Center,
                                    OIIO::ImageBufAlgo::TextAlignY::Baseline);
  }
  const OIIO::ImageSpec& spec = sheet.spec();
  write_rows(path, spec.width, spec.height,
             static_cast<const std::uint8_t*>(sheet.pixeladdr(0, 0)));
}

void write_png(const std::filesystem::path& path, const Bitmap& bitmap) {
  write_rows(path, bitmap.width, bitmap.height, bitmap.rgb.data());
}

void warm_up_pictures() { OIIO::ImageBufAlgo::text_size("Φ", 24, font); }

}  // namespace fos
