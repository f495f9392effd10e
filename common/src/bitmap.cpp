#include "fos/bitmap.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "fos/scene_text.hpp"

namespace fos {

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

std::string encode(const Panel& panel) {
  std::string bytes = fmt::format("panel {} {} {}\n{}", panel.bitmap.width, panel.bitmap.height,
                                  panel.label.size(), panel.label);
  bytes.append(panel.bitmap.rgb.begin(), panel.bitmap.rgb.end());
  return bytes;
}

std::vector<Panel> read_panels(std::istream& in) {
  std::vector<Panel> panels;
  while (in.peek() != std::istream::traits_type::eof()) {
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
    panels.push_back(std::move(panel));
  }
  return panels;
}

}  // namespace fos
