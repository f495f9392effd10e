// An instructor's own marks, which stand above what was graded, and survive grading again.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csv.hpp"
#include "fos/stage_list.hpp"
#include "hand_in.hpp"
#include "result.hpp"

namespace fos::grading {

struct OverrideRow {
  int line = 1;
  std::string who;  ///< an id, or a username
  Override mine;
};

struct Overrides {
  std::string file;
  std::vector<OverrideRow> rows;
};

/// A table with the columns id (or username), points and reason, and if need be stage: empty or no
/// such column is the whole submission. Throws TableError for a row that is wrong: no such stage,
/// no points, no reason, the same mark twice.
Overrides read_overrides(const std::filesystem::path& path, std::span<const Stage> stages);
Overrides make_overrides(const Table& table, std::span<const Stage> stages);

/// Throws TableError for the first row that is nobody's.
void check_overrides(const Overrides& overrides, const std::vector<Whose>& hand_ins);

/// Those of one submission, in the order of the file.
std::vector<Override> overrides_of(const Overrides& overrides, const Whose& whose);

/// Hundredths of what is written as `12`, `12.5` or `12,50`; nothing where it is no such number
/// from 0 to 10000 or has more than two decimals.
std::optional<int> read_points(std::string_view text);

}  // namespace fos::grading
