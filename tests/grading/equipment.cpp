#include "equipment.hpp"

#include <unistd.h>

#include <iostream>

#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "grading/box/probe.hpp"

namespace fos::grading {
namespace {

namespace fs = std::filesystem;

/// The strongest box that holds here, said in words.
BoxSetting find_box(const GradeOptions& options, const Workshop& workshop,
                    const fs::path& scratch) {
  ProbeSetting setting;
  setting.box.inside = workshop.inside();
  setting.box.compiler = this_build().compiler;
  setting.scratch = scratch;
  setting.secrets = {options.root / "solutions", options.root / "tests", fs::absolute(options.path),
                     fs::absolute(options.output)};
  setting.only = options.box;
  setting.unsafe = options.unsafe;
  const ProbeResult found = probe(setting);
  for (const NotHad& each : found.not_had) {
    std::cerr << say(text::grade_box_not_had, {name(each.level), each.why}) << '\n';
  }
  if (!found.level) throw FileError(3, say(text::grade_no_box));
  std::cerr << say(text::grade_box, {name(*found.level)}) << '\n';
  setting.box.level = *found.level;
  return setting.box;
}

}  // namespace

WorkFolder::WorkFolder() : path_((fs::temp_directory_path() / "fos-grade-XXXXXX").string()) {
  if (mkdtemp(path_.data()) == nullptr) {
    throw FileError(3, say(text::grade_no_work_folder, {path_}));
  }
  fs::permissions(path_, fs::perms(0711));
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Equipment::Equipment(const GradeOptions& options, const Shares& shares, std::uint64_t seed)
    : workshop_(this_build(), work_.path() / "workshop") {
  course_.box = find_box(options, workshop_, work_.path() / "probe");
  course_.workshop = &workshop_;
  course_.picture_program = options.build / "bin" / "fos_picture";
  course_.seed = seed;
  course_.shares = shares;
  workshop_.precompile(Box(course_.box, 0, work_.path() / "precompile"));
  const DrawnScenes drawn(seed);
  course_.stages.reserve(options.stages.size());
  for (const Stage* stage : options.stages) course_.stages.emplace_back(*stage, drawn);
}

}  // namespace fos::grading
