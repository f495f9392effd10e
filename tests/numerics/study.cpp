#include "study.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace fos::numerics {
namespace {

long double worst_error(const Measured& row) {
  return row.errors.not_finite > 0 ? std::numeric_limits<long double>::infinity()
                                   : row.errors.I->max;
}

bool beats(const Measured& a, const Measured& b) {
  const long double error_a = worst_error(a);
  const long double error_b = worst_error(b);
  return a.ratio <= b.ratio && error_a <= error_b && (a.ratio < b.ratio || error_a < error_b);
}

bool is_right(const Measured& row) { return row.errors.wrong_bytes + row.errors.open_bytes == 0; }

}  // namespace

void mark_frontier(std::vector<Measured>& rows) {
  for (Measured& row : rows) {
    row.frontier =
        row.errors.I && std::none_of(rows.begin(), rows.end(), [&](const Measured& other) {
          return other.errors.I && beats(other, row);
        });
    row.fastest_right =
        is_right(row) && std::none_of(rows.begin(), rows.end(), [&](const Measured& other) {
          return is_right(other) && other.ratio < row.ratio;
        });
  }
}

std::vector<Measured> rows_of(const std::vector<Rung>& rungs, const std::vector<Times>& times,
                              const Truth& truth) {
  std::set<std::size_t> tolls;
  for (const Rung& rung : rungs) {
    if (rung.toll) tolls.insert(*rung.toll);
  }
  const auto base = static_cast<std::size_t>(
      std::find_if(rungs.begin(), rungs.end(),
                   [](const Rung& rung) { return rung.id == baseline_id; }) -
      rungs.begin());
  std::vector<Measured> rows;
  for (std::size_t i = 0; i < rungs.size(); ++i) {
    if (tolls.contains(i)) continue;
    rows.push_back({rungs[i].id, rungs[i].name, spread_of(times[i]),
                    paired_ratio(times[i], times[base]), rungs[i].errors(truth)});
  }
  mark_frontier(rows);
  return rows;
}

}  // namespace fos::numerics
