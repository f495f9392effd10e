#include "fos/bitmap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "fos/scene_text.hpp"

namespace fos {
namespace {

/// The old pixels that a new one covers along one side, and how much of each; in all 1.
struct Cover {
  std::size_t first = 0;
  std::vector<float> shares;
};

std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> out(static_cast<std::size_t>(to));
  for (int i = 0; i < to; ++i) {
    // In units of 1 / to of an old pixel, of which a new one covers `from`.
    const long begin = static_cast<long>(i) * from;
    const long end = begin + from;
    Cover& cover = out[static_cast<std::size_t>(i)];
    cover.first = static_cast<std::size_t>(begin / to);
    for (long old = begin / to; old * to < end; ++old) {
      const long covered = std::min(end, (old + 1) * to) - std::max(begin, old * to);
      cover.shares.push_back(static_cast<float>(covered) / static_cast<float>(from));
    }
  }
  return out;
}

}  // namespace

Bitmap to_bitmap(const Frame& frame) {
  Bitmap bitmap{frame.header.width, frame.header.height, {}};
  bitmap.rgb.reserve(frame.channels.size());
  for (int row = 0; row < bitmap.height; ++row) {
    for (int column = 0; column < bitmap.width; ++column) {
      for (const long double channel :
           shown(frame.pixel(column, row), frame.is_unwritten(column, row), column, row)) {
        bitmap.rgb.push_back(to_byte(channel));
      }
    }
  }
  return bitmap;
}

Bitmap shrunk(const Bitmap& bitmap, int width, int height) {
  Bitmap out{width, height, {}};
  out.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::vector<Cover> columns = covers(bitmap.width, width);
  for (const Cover& rows : covers(bitmap.height, height)) {
    for (const Cover& column : columns) {
      std::array<float, 3> sum{};
      for (std::size_t y = 0; y < rows.shares.size(); ++y) {
        const std::uint8_t* pixel =
            &bitmap.rgb[3 *
                        ((rows.first + y) * static_cast<std::size_t>(bitmap.width) + column.first)];
        for (const float share : column.shares) {
          for (float& channel : sum)
            channel += rows.shares[y] * share * static_cast<float>(*pixel++);
        }
      }
      for (const float channel : sum) {
        out.rgb.push_back(static_cast<std::uint8_t>(std::lround(channel)));
      }
    }
  }
  return out;
}

std::string encode(const Panel& panel) {
  std::string bytes = fmt::format("panel {} {} {}\n{}", panel.bitmap.width, panel.bitmap.height,
                                  panel.label.size(), panel.label);
  // A byte at a time it would take longer than all the rest of a picture.
  const auto& rgb = panel.bitmap.rgb;
  bytes.append(reinterpret_cast<const char*>(rgb.data()), rgb.size());
  return bytes;
}

Panel read_panel(std::istream& in) {
  Panel panel;
  auto& [width, height, rgb] = panel.bitmap;
  std::string word;
  std::size_t label_bytes = 0;
  in >> word >> width >> height >> label_bytes;
  const bool fits = word == "panel" && in.get() == '\n' && width >= 1 && width <= max_canvas &&
                    height >= 1 && height <= max_canvas && label_bytes <= 1000;
  if (!fits) throw std::runtime_error("not a panel");
  panel.label.resize(label_bytes);
  in.read(panel.label.data(), static_cast<std::streamsize>(label_bytes));
  rgb.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  in.read(reinterpret_cast<char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
  if (!in) throw std::runtime_error("a panel is cut short");
  return panel;
}

}  // namespace fos
