#include "question.hpp"

#include <algorithm>
#include <utility>

namespace fos {
namespace {

reference::Precision own_precision(const Given& given) {
  return given.answer.header.precision == Precision::binary32 ? reference::Precision::float24
                                                              : reference::Precision::double53;
}

}  // namespace

Question judged(Given given, const Judge& judge) {
  Question question{std::move(given), Standing::no_answer, {}, {}};
  if (!question.given.came()) return question;
  question.expected = judge.expected({0, 0}, own_precision(question.given));
  Frame frame;
  frame.header = {1, 1, question.given.answer.header.precision};
  frame.channels.assign(question.given.channels.begin(), question.given.channels.end());
  frame.unwritten.push_back(question.given.unwritten ? 1 : 0);
  const Verdict verdict = judge.judge(frame);
  question.standing = verdict.not_finite.pixels > 0   ? Standing::not_finite
                      : verdict.unwritten.pixels > 0  ? Standing::unwritten
                      : verdict.wrong.pixels > 0      ? Standing::wrong
                      : verdict.only_float.pixels > 0 ? Standing::float_only
                      : verdict.not_judged.pixels > 0 ? Standing::not_judged
                                                      : Standing::right;
  return question;
}

std::optional<int> accepted_sphere(const Question& question) {
  for (const Expected& expected : question.expected) {
    bool lies_in = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const long double channel = std::min(question.given.channels[i], 255.0L);
      lies_in &= expected.channels[i].low <= channel && channel <= expected.channels[i].high;
    }
    if (lies_in) return expected.sphere;
  }
  return std::nullopt;
}

bool are_cut(const Question& question) {
  if (question.expected.empty() || !are_whole(question.given.channels)) return false;
  const Expected& exact = question.expected.front();
  for (std::size_t i = 0; i < 3; ++i) {
    const long double channel = std::min(question.given.channels[i], 255.0L);
    if (channel <= exact.channels[i].low - 1 || channel >= exact.channels[i].high + 1) return false;
  }
  return true;
}

}  // namespace fos
