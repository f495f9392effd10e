// What `./lab check` says: a screenful for one stage, a line for each of all.
#pragma once

#include <span>
#include <string>

#include "examine.hpp"
#include "layout.hpp"

namespace fos {

/// Each thing that is checked with ✓ or ✗ (· where it was not asked), the points, and for the first
/// that fails the pixel with what was expected and what came.
std::string describe(const Findings& findings, const Paint& paint);

/// How many things are right, and the points.
std::string summary(const Findings& findings);

/// The first thing that fails, or nothing.
const Finding* first_failure(const Findings& findings);

/// What to do about it: where to write where nothing is written yet, else the hints; what comes
/// next where all is right.
std::string next_step(const Findings& findings);

/// One stage among all: findings, or nothing where it did not build.
struct StageResult {
  const Stage* stage = nullptr;
  std::optional<Findings> findings;
  std::string mistake;  ///< its name, where it has one
};

/// All stages, a line each, the way through the course, and what to do next.
std::string overview(std::span<const StageResult> results, const Paint& paint);

/// labs/lecture04/point.cpp
std::string stage_file(const Stage& stage);

}  // namespace fos
