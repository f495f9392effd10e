#include "stage_terms.hpp"

namespace fos::reference {

mpq_class intensity(Terms terms, const mpq_class& I_A, const mpq_class& point_sum,
                    const mpq_class& directional_sum) {
  mpq_class I = terms & flat ? 1 : 0;
  if (terms & ambient) I += I_A;
  if (terms & point) I += point_sum;
  if (terms & directional) I += directional_sum;
  return I;
}

int to_byte(const mpq_class& channel) {
  if (channel <= 0) return 0;
  if (channel >= 255) return 255;
  const mpz_class whole = channel.get_num() / channel.get_den();
  const int byte = static_cast<int>(whole.get_si());
  const mpq_class twice_rest = 2 * (channel - whole);
  const int above_half = cmp(twice_rest, 1);
  const bool up = above_half > 0 || (above_half == 0 && byte % 2 == 1);
  return up ? byte + 1 : byte;
}

}  // namespace fos::reference
