#include "pages.hpp"

#include <fmt/core.h>

#include "mistakes.hpp"

namespace fos {
namespace {

/// A section: the slots up to this one, in the order of the catalogue.
struct Section {
  const Text& title;
  Slot last;
};

constexpr Section sections[] = {
    {text::mistakes_page_roots, Slot::background}, {text::mistakes_page_normal, Slot::call},
    {text::mistakes_page_vector, Slot::L},         {text::mistakes_page_term, Slot::intensity},
    {text::mistakes_page_sum, Slot::total},        {text::mistakes_page_ending, Slot::ending},
};

class Page {
 public:
  explicit Page(Language language) : language_(language) {}

  std::string write() {
    page_ =
        fmt::format("# {}\n\n{}\n", in(text::mistakes_page_title), in(text::mistakes_page_intro));
    const Section* section = nullptr;
    for (const Misconception& each : misconceptions()) {
      const Section& own = section_of(each);
      if (&own != section) page_ += fmt::format("\n## {}\n", in(own.title));
      section = &own;
      add(each);
    }
    return page_;
  }

 private:
  std::string in(const Text& text) const {
    return std::string(language_ == Language::en ? text.en : text.el);
  }

  std::string in(const Text& text, std::initializer_list<std::string> values) const {
    std::string words = in(text);
    char digit = '0';
    for (const std::string& value : values) {
      const std::string place{'{', digit++, '}'};
      words.replace(words.find(place), place.size(), value);
    }
    return words;
  }

  static const Section& section_of(const Misconception& mistake) {
    const Section* section = std::begin(sections);
    while (section->last < mistake.slot) ++section;
    return *section;
  }

  void add(const Misconception& mistake) {
    std::string of_stages;
    for (const Stage& stage : stages) {
      if ((mistake.stages & stage_bit(stage.id)) == 0) continue;
      of_stages += (of_stages.empty() ? "" : ", ") + in(stage.name);
    }
    page_ += fmt::format(
        "\n<a id='{}'></a>\n\n### {}\n\n![{}](../images/mistakes/{}.png)\n\n{}\n\n{}\n\n{}\n",
        mistake.id, in(mistake.name), mistake.id, mistake.id, in(mistake.question),
        in(text::mistakes_page_look, {in(mistake.look)}),
        in(text::mistakes_page_stages, {of_stages, std::string(mistake.id)}));
  }

  Language language_;
  std::string page_;
};

}  // namespace

std::string mistakes_page(Language language) { return Page(language).write(); }

}  // namespace fos
