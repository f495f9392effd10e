// fos_extremes [--csv F.csv] [FAMILY…]: the table of extremes, on standard output.
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>

#include "extremes_families.hpp"
#include "fos/progress.hpp"
#include "fos/whole_file.hpp"

namespace fos::numerics {

std::vector<Family> families() {
  return {point_light_far(),
          sun(),
          replaced(),
          lost_P(),
          shadows(),
          falloff(),
          light_near_surface(),
          direction_length(),
          bright(),
          many_lights(),
          sums(),
          floor_radius(),
          sphere_far(),
          unit_of_length(),
          grazing(),
          ties(),
          terminator(),
          camera_and_sphere(),
          canvas_limits()};
}

namespace {

/// Families by name, all of them where none is named. Throws std::invalid_argument.
std::vector<Family> chosen(const std::vector<std::string>& names) {
  std::vector<Family> all = families();
  if (names.empty()) return all;
  std::vector<Family> some;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Family& family) { return family.id == name; });
    if (found == all.end()) {
      std::string ids;
      for (const Family& family : all) ids += fmt::format(" {}", family.id);
      throw std::invalid_argument(say(text::extremes_unknown, {name, ids}));
    }
    some.push_back(*found);
  }
  return some;
}

void run(const std::vector<std::string>& names, const std::string& csv_path) {
  const std::vector<Family> asked = chosen(names);
  // What stands in the way of the file is said before the work, not after it.
  std::optional<WholeFile> file;
  if (!csv_path.empty()) file.emplace(csv_path);
  long total = 0;
  for (const Family& family : asked) total += static_cast<long>(family.parameters.size());
  std::string tables;
  std::string csv = csv_header();
  {
    Progress progress(say(text::extremes_progress), total);
    long done = 0;
    for (const Family& family : asked) {
      std::vector<Line> lines;
      for (std::size_t i = 0; i < family.parameters.size(); ++i) {
        for (Line& line : family.ask(i)) lines.push_back(std::move(line));
        progress.update(++done);
      }
      tables += table_of(family, lines);
      csv += csv_of(family, lines);
    }
  }
  std::fputs(tables.c_str(), stdout);
  std::fputs(legend().c_str(), stdout);
  if (file) {
    std::ofstream out(file->temporary(), std::ios::binary);
    if (!(out << csv).flush()) throw file->write_error(say(text::extremes_csv));
    file->commit();
  }
}

}  // namespace
}  // namespace fos::numerics

int main(int count, char** arguments) {
  std::vector<std::string> names(arguments + 1, arguments + count);
  std::string csv;
  const auto fail = [](int status, const char* why) {
    fmt::print(stderr, "{}: {}\n", fos::say(fos::text::tool_error), why);
    return status;
  };
  const auto option = std::find(names.begin(), names.end(), "--csv");
  if (option != names.end()) {
    if (option + 1 == names.end()) return fail(2, fos::say(fos::text::extremes_usage).c_str());
    csv = *(option + 1);
    names.erase(option, option + 2);
  }
  try {
    fos::numerics::run(names, csv);
    return 0;
  } catch (const std::invalid_argument& error) {
    return fail(2, error.what());
  } catch (const fos::FileError& error) {
    return fail(error.exit_status, error.what());
  } catch (const std::exception& error) {
    return fail(3, error.what());
  }
}
