// Codes a smooth row of numbers: each is predicted by a polynomial through the ones before it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "bits.hpp"

namespace fos::reference {

/// Predicts by the polynomials of degree -1 (which is 0) to 7 through the last 0 to 8 numbers, and
/// takes the one that was best of late. What it is off by is coded with the precision that it was
/// off by of late. Arithmetic is modulo 2^64.
class TermCoder {
 public:
  /// Forgets the row: the next number is not expected to go on from the last.
  void restart() { known_ = 0; }

  template <class Bits>
  void code(Bits& bits, std::int64_t& term) {
    const int order = best_order();
    const std::uint64_t prediction = predict(order);
    const int k = known_ == 0 ? first_bits : rice_parameter(errors_[index(order)]);
    std::uint64_t error =
        zigzag(static_cast<std::int64_t>(static_cast<std::uint64_t>(term) - prediction));
    code_rice(bits, error, k);
    const std::uint64_t value = prediction + static_cast<std::uint64_t>(unzigzag(error));
    term = static_cast<std::int64_t>(value);
    learn(value);
  }

 private:
  static constexpr int max_order = 8;
  static constexpr int first_bits = 40;  ///< about the bits of a term

  static constexpr std::size_t index(int i) { return static_cast<std::size_t>(i); }

  int best_order() const {
    int best = 0;
    for (int order = 1; order <= known_ && order <= max_order; ++order) {
      if (errors_[index(order)] <= errors_[index(best)]) best = order;
    }
    return best;
  }

  /// The next value of the polynomial through the last `order` numbers: the sum of their
  /// differences.
  std::uint64_t predict(int order) const {
    std::uint64_t prediction = 0;
    for (int i = 0; i < order; ++i) prediction += differences_[index(i)];
    return prediction;
  }

  /// The differences at the new number; the i-th is also the error of the prediction of order i.
  void learn(std::uint64_t value) {
    std::uint64_t difference = value;
    for (int i = 0; i <= max_order && i <= known_; ++i) {
      const auto as_signed = static_cast<std::int64_t>(difference);
      const std::uint64_t error = as_signed < 0 ? 0 - difference : difference;
      std::uint64_t& mean = errors_[index(i)];
      mean = i == known_ ? error : (mean + error) / 2;
      const std::uint64_t next = difference - differences_[index(i)];
      differences_[index(i)] = difference;
      difference = next;
    }
    if (known_ <= max_order) ++known_;
    // Nothing is known of the next order yet: take it to be as good as the last.
    if (known_ <= max_order) errors_[index(known_)] = errors_[index(known_ - 1)];
  }

  int known_ = 0;  ///< how many numbers the row has so far, up to max_order + 1
  std::array<std::uint64_t, max_order + 1> differences_{};
  std::array<std::uint64_t, max_order + 1> errors_{};  ///< running means, by order
};

}  // namespace fos::reference
