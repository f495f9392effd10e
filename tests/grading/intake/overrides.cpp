#include "overrides.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "file_names.hpp"
#include "fos/text.hpp"

namespace fos::grading {
namespace {

bool is_of(const OverrideRow& row, const Whose& whose) {
  const std::string who = lower(row.who);
  return who == lower(whose.id) || (!whose.username.empty() && who == lower(whose.username));
}

}  // namespace

std::optional<int> read_points(std::string_view text) {
  int whole = 0;
  int decimals = -1;  // none yet: no point was read
  std::size_t digits = 0;
  for (const char letter : text) {
    if ((letter == '.' || letter == ',') && decimals < 0) {
      decimals = 0;
    } else if (letter >= '0' && letter <= '9' && decimals < 2 && digits < 8) {
      whole = 10 * whole + (letter - '0');
      ++digits;
      decimals += decimals >= 0 ? 1 : 0;
    } else {
      return std::nullopt;
    }
  }
  if (digits == 0) return std::nullopt;
  for (decimals = std::max(decimals, 0); decimals < 2; ++decimals) {
    if (whole > 1'000'000) return std::nullopt;
    whole *= 10;
  }
  if (whole > 1'000'000) return std::nullopt;
  return whole;
}

Overrides read_overrides(const std::filesystem::path& path, std::span<const Stage> stages) {
  return make_overrides(read_table(path), stages);
}

Overrides make_overrides(const Table& table, std::span<const Stage> stages) {
  const std::vector<std::string> columns = column_names(table);
  const auto column = [&](std::initializer_list<std::string_view> names) {
    const auto found =
        std::find_first_of(columns.begin(), columns.end(), names.begin(), names.end());
    return found == columns.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - columns.begin()));
  };
  const auto who = column({"id", "username", "onoma christi"});
  const auto stage = column({"stage", "stadio"});
  const auto points = column({"points", "monades", "vathmoi"});
  const auto reason = column({"reason", "aitiologia", "aitia", "logos"});
  if (!who || !points || !reason) {
    throw TableError(table.file, table.rows.empty() ? 1 : table.rows.front().line,
                     say(text::intake_override_columns));
  }
  std::string known;
  for (const Stage& one : stages) known += (known.empty() ? "" : ", ") + std::string(one.id);

  Overrides overrides;
  overrides.file = table.file;
  std::map<std::pair<std::string, std::string>, int> seen;
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    const TableRow& row = table.rows[i];
    const auto fail = [&](const std::string& why) { throw TableError(table.file, row.line, why); };
    const auto cell = [&](const std::optional<std::size_t>& at) {
      return at && *at < row.cells.size() ? row.cells[*at] : std::string();
    };
    OverrideRow mine{row.line, cell(who), {cell(stage), 0, cell(reason)}};
    if (row.cells.size() > columns.size()) fail(say(text::intake_override_cells));
    if (mine.who.empty()) fail(say(text::intake_override_who));
    const bool is_stage = mine.mine.stage.empty() ||
                          std::any_of(stages.begin(), stages.end(),
                                      [&](const Stage& one) { return one.id == mine.mine.stage; });
    if (!is_stage) fail(say(text::intake_override_stage, {mine.mine.stage, known}));
    const auto number = read_points(cell(points));
    if (!number) fail(say(text::intake_override_points, {cell(points)}));
    mine.mine.points = number.value_or(0);
    if (mine.mine.reason.empty()) fail(say(text::intake_override_reason));
    const auto [before, is_new] = seen.try_emplace({lower(mine.who), mine.mine.stage}, row.line);
    if (!is_new) {
      fail(say(text::intake_override_twice, {mine.who, std::to_string(before->second)}));
    }
    overrides.rows.push_back(std::move(mine));
  }
  return overrides;
}

void check_overrides(const Overrides& overrides, const std::vector<Whose>& hand_ins) {
  for (const OverrideRow& row : overrides.rows) {
    const bool known = std::any_of(hand_ins.begin(), hand_ins.end(),
                                   [&](const Whose& whose) { return is_of(row, whose); });
    if (!known) {
      throw TableError(overrides.file, row.line, say(text::intake_override_nobody, {row.who}));
    }
  }
}

std::vector<Override> overrides_of(const Overrides& overrides, const Whose& whose) {
  std::vector<Override> out;
  for (const OverrideRow& row : overrides.rows) {
    if (is_of(row, whose)) out.push_back(row.mine);
  }
  return out;
}

}  // namespace fos::grading
