// The box that the tests run in: its level is FOS_BOX_LEVEL, else the strongest that is to be had.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grading/box/probe.hpp"
#include "grading/box/run.hpp"

namespace fos::grading {

/// A folder of this process, where the box's users may come, with what a test keeps secret in it.
const std::filesystem::path& test_folder();

/// A file that nobody in the box may read or write.
const std::filesystem::path& secret_file();

/// Nothing where the level is not to be had: then that has been said, "NOT RUN", once.
const std::optional<BoxSetting>& box_under_test();

Box make_box(unsigned slot = 0);

/// The attacker of attacker.cpp: what it does, and with what.
Errand attack(const std::string& what, const std::vector<std::string>& arguments = {});

}  // namespace fos::grading

/// In a test case: it is left where the box is not to be had.
#define FOS_NEEDS_BOX() \
  if (!box_under_test()) return
