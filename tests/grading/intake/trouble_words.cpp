#include "trouble_words.hpp"

#include "fos/text.hpp"

namespace fos::grading {

std::string trouble_words(Trouble trouble) {
  switch (trouble) {
    case Trouble::not_a_zip:
      return say(text::intake_not_a_zip);
    case Trouble::encrypted:
      return say(text::intake_locked);
    case Trouble::too_large:
      return say(text::intake_too_much);
    case Trouble::too_many_files:
      return say(text::intake_too_many);
    case Trouble::too_deep:
      return say(text::intake_too_deep);
    case Trouble::unsupported:
      return say(text::intake_unsupported);
    case Trouble::not_allowed:
      return say(text::intake_not_allowed);
    case Trouble::changed:
      return say(text::intake_changed);
    default:
      return say(text::intake_damaged);
  }
}

std::string why_words(Why why, const std::string& path) {
  switch (why) {
    case Why::not_text:
      return say(text::intake_file_not_text, {path});
    case Why::too_large:
      return say(text::intake_file_too_large, {path});
    case Why::link:
      return say(text::intake_file_link, {path});
    case Why::special:
      return say(text::intake_file_special, {path});
    case Why::encrypted:
      return say(text::intake_file_encrypted, {path});
    default:
      return say(text::intake_file_damaged, {path});
  }
}

}  // namespace fos::grading
