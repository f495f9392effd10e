#include "scene_grammar.hpp"

#include <algorithm>
#include <stdexcept>
#include <tao/pegtl.hpp>

#include "fos/text.hpp"

namespace fos {
namespace {

namespace pegtl = tao::pegtl;

// A number this long is a slip or an attack: exact arithmetic would choke on 1e999999999.
constexpr std::size_t max_number_length = 400;
constexpr long max_exponent = 5000;

/// Turns byte offsets into places. Offsets mostly grow, so it goes on from the last one.
class Places {
 public:
  explicit Places(std::string_view source) : source_(source) {}

  /// The place of a byte inside the source.
  Place at(const char* byte) {
    const auto offset = static_cast<std::size_t>(byte - source_.data());
    if (offset < offset_) offset_ = 0, place_ = Place();
    for (; offset_ < offset; ++offset_) {
      const auto next = static_cast<unsigned char>(source_[offset_]);
      if (next == '\n') {
        ++place_.line;
        place_.column = 1;
      } else if ((next & 0xC0) != 0x80) {  // not a continuation byte: one character more
        ++place_.column;
      }
    }
    return place_;
  }

 private:
  std::string_view source_;
  std::size_t offset_ = 0;
  Place place_;
};

/// What the actions fill in while the grammar matches.
struct Builder {
  explicit Builder(std::string_view text) : places(text) {}

  Places places;
  Document document;
  bool in_block = false;
  std::string identifier;  // the last one, and where
  Place identifier_place;
  Setting setting;

  Block& block() { return document.blocks.back(); }
};

struct Problem {
  Place place;
  std::string message;
};

// ---- the rules; those that must match say what is missing where they do not -----------------

struct comment : pegtl::seq<pegtl::one<'#'>, pegtl::until<pegtl::eolf>> {};
struct blank : pegtl::star<pegtl::sor<pegtl::one<' ', '\t', '\r', '\n'>, comment>> {};
template <char C>
struct mark : pegtl::seq<blank, pegtl::one<C>> {};

struct identifier : pegtl::identifier {};
struct word : pegtl::identifier {};
// Everything that looks like a number; whether it is one, parse_decimal says.
struct number_start : pegtl::ranges<'0', '9', '+', '+', '-', '.'> {};
struct number_rest : pegtl::ranges<'0', '9', 'a', 'w', 'A', 'Z', '_', '_', '+', '+', '-', '.'> {};
struct number : pegtl::seq<pegtl::at<number_start>, pegtl::plus<number_rest>> {};

struct triple_open : pegtl::one<'('> {};
struct triple_number : pegtl::seq<blank, number> {
  static constexpr const Text& complaint = text::scene_expected_triple;
};
struct triple_comma : mark<','> {
  static constexpr const Text& complaint = text::scene_expected_triple;
};
struct triple_close : mark<')'> {
  static constexpr const Text& complaint = text::scene_expected_triple;
};
struct triple : pegtl::if_must<triple_open, triple_number, triple_comma, triple_number,
                               triple_comma, triple_number, triple_close> {};
struct size_number : pegtl::seq<blank, number> {
  static constexpr const Text& complaint = text::scene_expected_size;
};
struct number_or_size : pegtl::seq<number, pegtl::opt<pegtl::if_must<mark<'x'>, size_number>>> {};

struct value_content : pegtl::sor<triple, number_or_size, word> {};
struct value : pegtl::seq<blank, value_content> {
  static constexpr const Text& complaint = text::scene_expected_value;
};
struct equals : mark<'='> {};
struct no_comma : pegtl::not_at<mark<','>> {
  static constexpr const Text& complaint = text::scene_unexpected_comma;
};
struct setting_rest : pegtl::if_must<equals, value, no_comma> {
  static constexpr const Text& complaint = text::scene_expected_equals;
};
struct block_setting : pegtl::seq<identifier, pegtl::must<setting_rest>> {};
struct block_open : mark<'{'> {};
struct block_close : mark<'}'> {
  static constexpr const Text& complaint = text::scene_expected_key_or_brace;
};
struct block_rest
    : pegtl::seq<block_open, pegtl::star<blank, block_setting>, pegtl::must<block_close>> {};
struct item_rest : pegtl::sor<setting_rest, block_rest> {
  static constexpr const Text& complaint = text::scene_expected_equals_or_brace;
};
struct item : pegtl::seq<identifier, pegtl::must<item_rest>> {};
struct items : pegtl::star<blank, item> {};
struct end : pegtl::seq<blank, pegtl::eof> {
  static constexpr const Text& complaint = text::scene_expected_item;
};
struct file : pegtl::seq<items, pegtl::must<end>> {};

/// `text` without the blank space in front: an error points at what stands there, not at the gap.
std::string_view skip_blank(std::string_view text) {
  while (!text.empty()) {
    if (text.front() == '#') {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else if (std::string_view(" \t\r\n").find(text.front()) != std::string_view::npos) {
      text.remove_prefix(1);
    } else {
      break;
    }
  }
  return text;
}

template <typename Rule>
struct Control : pegtl::normal<Rule> {
  template <typename Input, typename... States>
  static void raise(const Input& in, Builder& builder, States&&... /*unused*/) {
    const std::string_view rest(in.current(), static_cast<std::size_t>(in.end() - in.current()));
    throw Problem{builder.places.at(skip_blank(rest).data()),
                  say(Rule::complaint, {builder.identifier})};
  }
};

// ---- actions ------------------------------------------------------------------------------

template <typename Rule>
struct Action {};

template <>
struct Action<identifier> {
  template <typename Input>
  static void apply(const Input& in, Builder& builder) {
    builder.identifier = in.string();
    builder.identifier_place = builder.places.at(in.begin());
  }
};

template <>
struct Action<equals> {
  static void apply0(Builder& builder) {
    builder.setting = Setting();
    builder.setting.key = builder.identifier;
    builder.setting.place = builder.identifier_place;
  }
};

template <>
struct Action<number> {
  template <typename Input>
  static void apply(const Input& in, Builder& builder) {
    const Place place = builder.places.at(in.begin());
    const std::string text = in.string();
    try {
      Decimal decimal = parse_decimal(text);
      if (text.size() > max_number_length || std::abs(decimal.exponent) > max_exponent) {
        throw Problem{place, say(text::scene_number_too_long)};
      }
      decimal.place = place;
      if (builder.setting.numbers.empty()) builder.setting.value_place = place;
      builder.setting.numbers.push_back(std::move(decimal));
    } catch (const std::invalid_argument&) {
      throw Problem{place, say(text::scene_bad_number, {text})};
    }
  }
};

template <>
struct Action<word> {
  template <typename Input>
  static void apply(const Input& in, Builder& builder) {
    builder.setting.word = in.string();
    builder.setting.value_place = builder.places.at(in.begin());
  }
};

template <>
struct Action<setting_rest> {
  static void apply0(Builder& builder) {
    Setting& setting = builder.setting;
    constexpr Shape shapes[] = {Shape::word, Shape::number, Shape::size, Shape::triple};
    setting.shape = shapes[setting.numbers.size()];
    (builder.in_block ? builder.block().settings : builder.document.header).push_back(setting);
  }
};

template <>
struct Action<block_open> {
  static void apply0(Builder& builder) {
    builder.document.blocks.push_back({builder.identifier, builder.identifier_place, {}});
    builder.in_block = true;
  }
};

template <>
struct Action<block_close> {
  static void apply0(Builder& builder) { builder.in_block = false; }
};

}  // namespace

Document parse_document(std::string_view source, std::string_view name) {
  Builder builder(source);
  pegtl::memory_input<pegtl::tracking_mode::lazy> in(source.data(), source.data() + source.size(),
                                                     std::string(name));
  try {
    pegtl::parse<file, Action, Control>(in, builder);
  } catch (const Problem& problem) {
    throw scene_error(source, name, problem.place, problem.message);
  }
  return std::move(builder.document);
}

}  // namespace fos
