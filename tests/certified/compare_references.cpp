#include "compare_references.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <typeinfo>

#include "fast_reference.hpp"
#include "generate.hpp"

namespace fos::certified {
namespace {

struct Outcome {
  std::optional<reference::Reference> reference;
  std::string error;

  friend bool operator==(const Outcome&, const Outcome&) = default;
};

template <class Make>
Outcome outcome_of(const Make& make) {
  try {
    return {make(), {}};
  } catch (const std::exception& error) {
    return {std::nullopt, std::string(typeid(error).name()) + ' ' + error.what()};
  }
}

}  // namespace

ReferenceComparison compare_references(const SceneText& scene) {
  const Outcome fast = outcome_of([&] { return certified::reference(scene); });
  const Outcome slow = outcome_of([&] { return reference::generate(scene); });
  if (!(fast == slow)) return ReferenceComparison::different;
  return fast.reference ? ReferenceComparison::equal : ReferenceComparison::same_error;
}

}  // namespace fos::certified
