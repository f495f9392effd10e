// SceneText from the grammar's document: which keys there are, what they hold, in what range.
#include "fos/scene_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "fos/text.hpp"
#include "fos/utf8.hpp"
#include "scene_grammar.hpp"

namespace fos {
namespace {

using Keys = std::vector<std::string_view>;

/// The number of letters to insert, delete or replace to get from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string list(const Keys& keys) {
  std::string out;
  for (const std::string_view key : keys) out.append(out.empty() ? "" : ", ").append(key);
  return out;
}

/// "; did you mean 'x'?", or the list of what there is where nothing is near.
std::string suggestion(std::string_view word, const Keys& known) {
  const auto nearest = std::min_element(known.begin(), known.end(), [&](auto a, auto b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  if (edit_distance(word, *nearest) <= 2) return say(text::scene_did_you_mean, {*nearest});
  return say(text::scene_known, {list(known)});
}

/// Looks keys up in a group of settings, and knows how to complain about them.
class Reader {
 public:
  Reader(std::string_view source, std::string_view name) : source_(source), name_(name) {}

  [[noreturn]] void fail(Place place, const std::string& message) const {
    throw scene_error(source_, name_, place, message);
  }

  /// Every key is known and stands once.
  void check_keys(const std::vector<Setting>& settings, const Keys& known) const {
    for (auto setting = settings.begin(); setting != settings.end(); ++setting) {
      if (std::find(known.begin(), known.end(), setting->key) == known.end()) {
        fail(setting->place,
             say(text::scene_unknown_key, {setting->key}) + suggestion(setting->key, known));
      }
      const auto first = find(settings, setting->key);
      if (first != &*setting) {
        fail(setting->place,
             say(text::scene_repeated_key, {setting->key, std::to_string(first->place.line)}));
      }
    }
  }

  static const Setting* find(const std::vector<Setting>& settings, std::string_view key) {
    const auto found = std::find_if(settings.begin(), settings.end(),
                                    [&](const Setting& setting) { return setting.key == key; });
    return found == settings.end() ? nullptr : &*found;
  }

  const Setting& required(const Block& block, std::string_view key) const {
    const Setting* setting = find(block.settings, key);
    if (setting == nullptr) fail(block.place, say(text::scene_missing_key, {block.name, key}));
    return *setting;
  }

  const Decimal& number(const Setting& setting) const {
    return shaped(setting, Shape::number, text::scene_needs_number)[0];
  }
  const Decimal& positive(const Setting& setting) const {
    const Decimal& value = number(setting);
    require_positive(setting, value);
    return value;
  }
  std::array<Decimal, 2> positive_size(const Setting& setting) const {
    const auto& numbers = shaped(setting, Shape::size, text::scene_needs_size);
    for (const Decimal& value : numbers) require_positive(setting, value);
    return {numbers[0], numbers[1]};
  }
  DecimalTriple triple(const Setting& setting) const {
    const auto& numbers = shaped(setting, Shape::triple, text::scene_needs_triple);
    return {numbers[0], numbers[1], numbers[2]};
  }
  DecimalTriple color(const Setting& setting) const {
    static const Decimal white = parse_decimal("255");
    DecimalTriple channels = triple(setting);
    for (const Decimal& channel : channels) {
      if (channel.negative || compare(channel, white) > 0) {
        fail(channel.place, say(text::scene_color_range, {setting.key}));
      }
    }
    return channels;
  }
  DecimalTriple direction(const Setting& setting) const {
    DecimalTriple value = triple(setting);
    if (std::all_of(value.begin(), value.end(), [](const Decimal& d) { return d.is_zero(); })) {
      fail(setting.value_place, say(text::scene_zero_direction));
    }
    return value;
  }
  const Decimal& not_negative(const Setting& setting) const {
    const Decimal& value = number(setting);
    if (value.negative) fail(value.place, say(text::scene_negative, {setting.key}));
    return value;
  }
  std::array<int, 2> canvas(const Setting& setting) const {
    const auto& numbers = shaped(setting, Shape::size, text::scene_needs_size);
    std::array<int, 2> size{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Decimal& value = numbers[i];
      const bool whole = value.exponent >= 0 && !value.negative && !value.is_zero();
      if (!whole || compare(value, parse_decimal(std::to_string(max_canvas))) > 0) {
        fail(value.place, say(text::scene_canvas_range, {setting.key, std::to_string(max_canvas)}));
      }
      size[i] =
          std::stoi(value.digits + std::string(static_cast<std::size_t>(value.exponent), '0'));
    }
    return size;
  }

 private:
  const std::vector<Decimal>& shaped(const Setting& setting, Shape shape, const Text& needs) const {
    if (setting.shape != shape) fail(setting.value_place, say(needs, {setting.key}));
    return setting.numbers;
  }
  void require_positive(const Setting& setting, const Decimal& value) const {
    if (value.negative || value.is_zero()) {
      fail(value.place, say(text::scene_not_positive, {setting.key}));
    }
  }

  std::string_view source_;
  std::string_view name_;
};

void read_header(const Reader& reader, const std::vector<Setting>& header, SceneText& scene) {
  reader.check_keys(header, {"canvas_size", "viewport_size", "projection_plane_d",
                             "camera_position", "background_color"});
  const auto given = [&](std::string_view key) { return Reader::find(header, key); };
  if (const Setting* setting = given("canvas_size")) {
    const auto size = reader.canvas(*setting);
    scene.canvas_width = size[0];
    scene.canvas_height = size[1];
  }
  if (const Setting* setting = given("viewport_size")) {
    scene.viewport_size = reader.positive_size(*setting);
  }
  if (const Setting* setting = given("projection_plane_d")) {
    scene.projection_plane_d = reader.positive(*setting);
  }
  if (const Setting* setting = given("camera_position")) {
    scene.camera_position = reader.triple(*setting);
  }
  if (const Setting* setting = given("background_color")) {
    scene.background_color = reader.color(*setting);
  }
}

SphereText read_sphere(const Reader& reader, const Block& block) {
  reader.check_keys(block.settings, {"center", "radius", "color"});
  return {reader.triple(reader.required(block, "center")),
          reader.positive(reader.required(block, "radius")),
          reader.color(reader.required(block, "color"))};
}

LightKind read_type(const Reader& reader, const Setting& type) {
  static const Keys types{"ambient", "point", "directional"};  // in the order of LightKind
  if (type.shape != Shape::word)
    reader.fail(type.value_place, say(text::scene_needs_type, {list(types)}));
  const auto found = std::find(types.begin(), types.end(), type.word);
  if (found == types.end()) {
    reader.fail(type.value_place,
                say(text::scene_unknown_type, {type.word}) + suggestion(type.word, types));
  }
  return static_cast<LightKind>(found - types.begin());
}

LightText read_light(const Reader& reader, const Block& block) {
  reader.check_keys(block.settings, {"type", "intensity", "position", "direction"});
  LightText light;
  light.place = block.place;
  const Setting& type = reader.required(block, "type");
  light.kind = read_type(reader, type);
  light.intensity = reader.not_negative(reader.required(block, "intensity"));
  for (const auto& [key, kind] :
       {std::pair<std::string_view, LightKind>{"position", LightKind::point},
        {"direction", LightKind::directional}}) {
    const Setting* setting = Reader::find(block.settings, key);
    if (setting != nullptr && kind != light.kind) {
      reader.fail(setting->place, say(text::scene_not_of_this_light, {key, type.word}));
    }
  }
  if (light.kind == LightKind::point) {
    light.vector = reader.triple(reader.required(block, "position"));
  } else if (light.kind == LightKind::directional) {
    light.vector = reader.direction(reader.required(block, "direction"));
  }
  return light;
}

void read_blocks(const Reader& reader, const std::vector<Block>& blocks, SceneText& scene) {
  static const Keys names{"sphere", "light"};
  std::optional<Place> ambient;
  for (const Block& block : blocks) {
    if (block.name == "sphere") {
      scene.spheres.push_back(read_sphere(reader, block));
    } else if (block.name == "light") {
      scene.lights.push_back(read_light(reader, block));
      if (scene.lights.back().kind != LightKind::ambient) continue;
      if (ambient) {
        reader.fail(block.place, say(text::scene_second_ambient, {std::to_string(ambient->line)}));
      }
      ambient = block.place;
    } else {
      reader.fail(block.place,
                  say(text::scene_unknown_block, {block.name}) + suggestion(block.name, names));
    }
  }
}

void require_text(const Reader& reader, std::string_view source) {
  Place place;
  while (!source.empty()) {
    const std::size_t length = text_length(source);
    if (length == 0) {
      reader.fail(place, say(text::scene_not_text,
                             {fmt::format("0x{:02X}", static_cast<unsigned char>(source[0]))}));
    }
    ++place.column;
    if (source[0] == '\n') place = {place.line + 1, 1};
    source.remove_prefix(length);
  }
}

}  // namespace

SceneText parse_scene_text(std::string_view source, std::string name) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (source.starts_with(byte_order_mark)) source.remove_prefix(byte_order_mark.size());
  SceneText scene;
  scene.name = std::move(name);
  scene.source = source;
  const Reader reader(scene.source, scene.name);
  if (source.size() > max_scene_bytes) reader.fail({}, say(text::scene_too_big));
  require_text(reader, source);
  const Document document = parse_document(scene.source, scene.name);
  read_header(reader, document.header, scene);
  read_blocks(reader, document.blocks, scene);
  return scene;
}

}  // namespace fos
