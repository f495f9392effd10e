#include "report_files.hpp"

#include <algorithm>
#include <system_error>

#include "class_page.hpp"
#include "clean_text.hpp"
#include "fos/text.hpp"
#include "fos/whole_file.hpp"
#include "submission_page.hpp"

namespace fos::grading {
namespace {

void add_words(std::vector<std::string>& out, const Objections& objections,
               const std::string& file) {
  for (const Objection& one : objections) out.push_back(one_line(objection_words(one, file)));
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    const bool disk = error == std::errc::no_space_on_device || error == std::errc::io_error;
    throw FileError(disk ? 3 : 2, say(text::tool_cannot_write, {folder.string(), error.message()}));
  }
}

}  // namespace

std::string_view name(ReportFormat format) {
  constexpr std::string_view names[] = {"html",       "csv",     "eclass", "moodle",
                                        "gradescope", "actions", "junit"};
  return names[static_cast<std::size_t>(format)];
}

std::optional<ReportFormat> report_format(std::string_view name_given) {
  for (const ReportFormat format : report_formats) {
    if (name(format) == name_given) return format;
  }
  return std::nullopt;
}

std::filesystem::path submission_folder(const std::filesystem::path& folder,
                                        const std::string& id) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789._-";
  const bool good = !id.empty() && id.size() <= 200 &&
                    id.find_first_not_of(letters) == std::string::npos &&
                    id.find_first_not_of('.') != std::string::npos;
  if (!good) throw FileError(3, say(text::report_bad_id, {one_line(shortened(id, 80))}));
  return folder / "submissions" / id;
}

std::vector<std::string> write_class_files(const std::filesystem::path& folder, const Run& run,
                                           std::span<const Summary> all,
                                           const ReportSettings& settings) {
  const auto wanted = [&](ReportFormat format) { return settings.formats.contains(format); };
  const ClassFile file{run.feedback, settings.maximum};
  std::vector<std::string> objections;
  make_folder(folder);
  if (wanted(ReportFormat::html)) write_whole_file(folder / "index.html", class_page(run, all));
  if (wanted(ReportFormat::csv)) write_whole_file(folder / "grades.csv", grades_csv(all));
  if (wanted(ReportFormat::eclass)) {
    write_whole_file(folder / "eclass.csv", eclass_csv(all, file));
    add_words(objections, eclass_preflight(all, file), "eclass.csv");
  }
  if (wanted(ReportFormat::moodle)) {
    write_whole_file(folder / "moodle.csv", moodle_csv(all, file, settings.moodle_user));
    add_words(objections, moodle_preflight(all, file, settings.moodle_user), "moodle.csv");
  }
  return objections;
}

std::vector<std::string> write_submission_files(const std::filesystem::path& folder, const Run& run,
                                                const SubmissionResult& submission,
                                                const ReportSettings& settings,
                                                const std::vector<std::string>& pictures) {
  const auto wanted = [&](ReportFormat format) { return settings.formats.contains(format); };
  std::vector<std::string> objections;
  const std::filesystem::path own = submission_folder(folder, submission.id);
  make_folder(own);
  if (wanted(ReportFormat::html)) {
    write_whole_file(own / "index.html", submission_page(run, submission));
  }
  if (wanted(ReportFormat::gradescope)) {
    write_whole_file(own / "results.json", gradescope_json(run, submission, pictures));
    add_words(objections, gradescope_preflight(submission), "results.json");
  }
  if (wanted(ReportFormat::actions)) {
    write_whole_file(own / "github-output.txt", actions_output(run, submission));
    write_whole_file(own / "github-summary.md", actions_summary(run, submission));
    add_words(objections, actions_preflight(run, submission), "github-output.txt");
  }
  if (wanted(ReportFormat::junit)) {
    write_whole_file(own / "junit.xml", junit_xml(run, submission));
    add_words(objections, junit_preflight(submission), "junit.xml");
  }
  return objections;
}

}  // namespace fos::grading
