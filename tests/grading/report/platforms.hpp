// The files that course platforms and continuous integration read, each with a preflight: what that
// platform would refuse, and which rows are left out so that it takes the others. All of them are
// pure: a result in, text out.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "preflight.hpp"
#include "result.hpp"
#include "summary.hpp"

namespace fos::grading {

// --- a class ------------------------------------------------------------------------------------

/// grades.csv, our own: a header in the same words in every language, then a row a submission, a
/// column a stage. Nobody is left out: a stage that was not judged has an empty cell, and a
/// submission without a final mark an empty total.
std::string grades_csv(std::span<const Summary> all);

/// Open eClass, work module, "import grades": no header, `username,grade,comment`. The module takes
/// the text in the first parentheses of the first cell as the username, refuses the whole file for
/// one bad row, and drops empty cells.
std::string eclass_csv(std::span<const Summary> all, const ClassFile& file);
Objections eclass_preflight(std::span<const Summary> all, const ClassFile& file);

/// What names a user in Moodle's grade import: its columns useremail, username and useridnumber.
/// The latter two are filled with our username.
enum class MoodleUser { email, username, idnumber };

/// Moodle, "import grades from CSV": a header; the columns are mapped in its own form, the grade
/// and the feedback together. One bad row cancels the import there.
std::string moodle_csv(std::span<const Summary> all, const ClassFile& file, MoodleUser user);
Objections moodle_preflight(std::span<const Summary> all, const ClassFile& file, MoodleUser user);

// --- one submission -----------------------------------------------------------------------------

/// Gradescope's results.json: an entry a stage, visible, with the checks in its output. `pictures`,
/// if there are any, are those of half_blocks(), a stage at a time, "" for a stage without one.
std::string gradescope_json(const Run& run, const SubmissionResult& submission,
                            const std::vector<std::string>& pictures = {});
Objections gradescope_preflight(const SubmissionResult& submission);

/// The result that GitHub's autograding reporter reads, as JSON: an entry a stage.
std::string actions_json(const Run& run, const SubmissionResult& submission);
/// The line for $GITHUB_OUTPUT: `result=` and that JSON in base64.
std::string actions_output(const Run& run, const SubmissionResult& submission);
/// Markdown for $GITHUB_STEP_SUMMARY.
std::string actions_summary(const Run& run, const SubmissionResult& submission);
Objections actions_preflight(const Run& run, const SubmissionResult& submission);

/// JUnit XML: a suite a stage, a case a check; points, of which JUnit knows nothing, as properties.
std::string junit_xml(const Run& run, const SubmissionResult& submission);
Objections junit_preflight(const SubmissionResult& submission);

}  // namespace fos::grading
