// Pictures are read back with OpenImageIO itself; PFM, which it does not know, by hand.
#include "fos/picture.hpp"

#include <OpenImageIO/imageio.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>

#include "catch2.hpp"
#include "folder.hpp"
#include "fos/whole_file.hpp"

using namespace fos;
namespace fs = std::filesystem;

namespace {

/// 3 x 2 pixels with what is difficult: over 255, negative, ties, NaN, unwritten.
const std::vector<Row> rows{
    {{0.1L, 136.501L, 300, -4, 127.5L, 254.5L, 1.0L / 3, 255, 51}, {0, 0, 0}},
    {{1, 2, 3, std::numeric_limits<long double>::quiet_NaN(), 0, 0, 9, 9, 9}, {0, 0, 1}}};

void write(const fs::path& path, Precision precision) {
  PictureWriter writer(path, {3, 2, precision}, {"./lab render --scene α.scene", "# the scene\n"});
  for (const Row& row : rows) writer.write(row);
  writer.finish();
}

struct Picture {
  OIIO::ImageSpec spec;
  std::vector<double> channels;
};

Picture read(const fs::path& path) {
  const auto in = OIIO::ImageInput::open(path.string());
  REQUIRE(in);
  Picture picture{in->spec(), std::vector<double>(18)};
  REQUIRE(picture.spec.nchannels == 3);
  REQUIRE(in->read_image(0, 0, 0, 3, OIIO::TypeDesc::DOUBLE, picture.channels.data()));
  return picture;
}

}  // namespace

TEST_CASE("a format goes by its extension") {
  CHECK(picture_format("a.png") == PictureFormat::png);
  CHECK(picture_format("a.PNG") == PictureFormat::png);
  CHECK(picture_format("a.tiff") == PictureFormat::tiff);
  CHECK(picture_format("b/εικόνα.exr") == PictureFormat::exr);
  CHECK(picture_format("a.pfm") == PictureFormat::pfm);
  CHECK_FALSE(picture_format("a.jpg"));
  CHECK_FALSE(picture_format("png"));
}

TEST_CASE("PNG holds the bytes of the byte rule") {
  const Folder folder;
  write(folder.path / "a.png", Precision::binary64);
  const Picture picture = read(folder.path / "a.png");
  CHECK(picture.spec.format == OIIO::TypeDesc::UINT8);
  const int expected[] = {0, 137, 255, 0,   128, 254, 0,   255, 51,
                          1, 2,   3,   255, 0,   255, 208, 208, 208};
  for (std::size_t i = 0; i < 18; ++i) {
    INFO(i);
    CHECK(std::lround(picture.channels[i] * 255) == expected[i]);
  }
}

TEST_CASE("EXR and TIFF hold channel / 255, linear and not cut off, with scene and command") {
  const Folder folder;
  struct Case {
    const char* name;
    Precision precision;
    OIIO::TypeDesc type;
    double tolerance;
  };
  for (const Case& each : {Case{"a.exr", Precision::binary64, OIIO::TypeDesc::FLOAT, 1e-7},
                           Case{"b.tif", Precision::binary32, OIIO::TypeDesc::FLOAT, 1e-7},
                           Case{"c.tif", Precision::binary64, OIIO::TypeDesc::DOUBLE, 0}}) {
    INFO(each.name);
    write(folder.path / each.name, each.precision);
    const Picture picture = read(folder.path / each.name);
    CHECK(picture.spec.format == each.type);
    CHECK(picture.spec.get_string_attribute("ImageDescription") ==
          "./lab render --scene α.scene\n\n# the scene\n");
    for (std::size_t i = 0; i < 12; ++i) {
      INFO(i);
      const auto expected = static_cast<double>(rows[i / 9].channels[i % 9] / 255);
      CHECK_THAT(picture.channels[i], WithinAbs(expected, each.tolerance * std::abs(expected)));
    }
    CHECK(picture.channels[12] == 1);  // magenta for what is not finite
    CHECK(picture.channels[13] == 0);
  }
}

TEST_CASE("PFM holds the channels as they are, rows from the bottom") {
  const Folder folder;
  write(folder.path / "a.pfm", Precision::binary64);
  std::ifstream in(folder.path / "a.pfm", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string header = "PF\n3 2\n-1.0\n";
  REQUIRE(bytes.size() == header.size() + 18 * sizeof(float));
  CHECK(bytes.substr(0, header.size()) == header);
  float channels[18];
  std::memcpy(channels, bytes.data() + header.size(), sizeof(channels));
  CHECK(channels[0] == 1);     // the bottom row first
  CHECK(channels[9] == 0.1F);  // then the top row
  CHECK(channels[11] == 300);
  CHECK(channels[12] == -4);
}

TEST_CASE("a picture that is not finished is not there") {
  const Folder folder;
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.pfm"}) {
    {
      PictureWriter writer(folder.path / name, {3, 2, Precision::binary64}, {});
      writer.write(rows[0]);
    }
    CHECK(fs::is_empty(folder.path));
  }
  CHECK_THROWS_AS(PictureWriter(folder.path / "no" / "a.png", {3, 2, Precision::binary64}, {}),
                  FileError);
}

TEST_CASE("when the disk takes no more, that is said and nothing is left") {
  // A process that may write 1000 bytes a file sees what a full disk shows.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit little{1000, before.rlim_max};
  const Folder folder;
  for (const char* name : {"a.png", "a.exr", "a.tif", "a.pfm"}) {
    INFO(name);
    setrlimit(RLIMIT_FSIZE, &little);
    int status = 0;
    try {
      PictureWriter writer(folder.path / name, {300, 300, Precision::binary64}, {});
      Row row{std::vector<long double>(900), std::vector<std::uint8_t>(300)};
      for (int i = 0; i < 300; ++i) {
        for (auto& channel : row.channels) channel = std::rand() % 255;
        writer.write(row);
      }
      writer.finish();
    } catch (const FileError& error) {
      status = error.exit_status;
    }
    setrlimit(RLIMIT_FSIZE, &before);
    CHECK(status == 3);
    CHECK(fs::is_empty(folder.path));
  }
}

TEST_CASE("a label may be Greek") {
  // A letter that is lost on the way is drawn as another one, or as a box.
  const Folder folder;
  const auto bytes_of = [&](const char* label) {
    write_sheet(folder.path / "a.png", {{label, {1, 1, {0, 0, 0}}}}, 1, 100);
    std::ifstream in(folder.path / "a.png", std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  CHECK(bytes_of("δ") != bytes_of("4"));
  CHECK(bytes_of("δ") != bytes_of("ε"));
  CHECK(bytes_of("Ο") == bytes_of("O"));  // the Greek and the Latin one look the same
}

TEST_CASE("a sheet shows every panel") {
  const Folder folder;
  const Panel panel{"Σημειακό φως", {2, 2, {255, 0, 0, 255, 0, 0, 255, 0, 0, 255, 0, 0}}};
  write_sheet(folder.path / "all.png", {panel, panel, panel}, 2, 100);
  const auto in = OIIO::ImageInput::open((folder.path / "all.png").string());
  REQUIRE(in);
  CHECK(in->spec().width > 200);
  CHECK(in->spec().height > 200);
  std::vector<unsigned char> pixels(static_cast<std::size_t>(in->spec().image_pixels()) * 3);
  REQUIRE(in->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
  long red = 0;
  for (std::size_t i = 0; i < pixels.size(); i += 3) red += pixels[i] == 255 && pixels[i + 1] == 0;
  CHECK(red == 3L * 100 * 100);
}
