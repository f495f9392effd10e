// Where reports are written: the one place of this library that touches the disk.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include "platforms.hpp"
#include "result.hpp"
#include "summary.hpp"

namespace fos::grading {

enum class ReportFormat { html, csv, eclass, moodle, gradescope, actions, junit };
inline constexpr ReportFormat report_formats[] = {
    ReportFormat::html,       ReportFormat::csv,     ReportFormat::eclass, ReportFormat::moodle,
    ReportFormat::gradescope, ReportFormat::actions, ReportFormat::junit};

/// html, csv, eclass, moodle, gradescope, actions, junit.
std::string_view name(ReportFormat format);
std::optional<ReportFormat> report_format(std::string_view name);

struct ReportSettings {
  std::set<ReportFormat> formats = {ReportFormat::html, ReportFormat::csv};
  int maximum = 0;  ///< of ClassFile
  MoodleUser moodle_user = MoodleUser::email;
};

/// DIR/index.html, grades.csv, eclass.csv and moodle.csv, each whole or not at all. Returns what
/// the platforms would refuse, in words, a line each. Throws FileError.
std::vector<std::string> write_class_files(const std::filesystem::path& folder, const Run& run,
                                           std::span<const Summary> all,
                                           const ReportSettings& settings);

/// DIR/submissions/ID/index.html, results.json (Gradescope), github-output.txt and
/// github-summary.md (Actions), junit.xml; the folder is made. Likewise. Throws FileError also
/// where the id is no name for a folder.
std::vector<std::string> write_submission_files(const std::filesystem::path& folder, const Run& run,
                                                const SubmissionResult& submission,
                                                const ReportSettings& settings,
                                                const std::vector<std::string>& pictures = {});

/// DIR/submissions/ID. Throws FileError where the id is not of [a-z0-9._-], or is only dots.
std::filesystem::path submission_folder(const std::filesystem::path& folder, const std::string& id);

}  // namespace fos::grading
