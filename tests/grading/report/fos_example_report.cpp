// fos_example_report DIR COUNT: the report of a class of COUNT, with pictures and hostile names,
// for the test in a browser.
#include <cstdlib>
#include <string>
#include <vector>

#include "example_results.hpp"
#include "fos/picture.hpp"
#include "report_files.hpp"

using namespace fos::grading;

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const std::filesystem::path folder = arguments[1];
  ReportSettings settings;
  settings.formats = {std::begin(report_formats), std::end(report_formats)};
  std::vector<Summary> all;
  for (int i = 0; i < std::atoi(arguments[2]); ++i) {
    const SubmissionResult one = example_submission(i);
    write_submission_files(folder, example_run(), one, settings);
    for (const StageResult& stage : one.stages) {
      for (std::size_t p = 0; p < stage.pictures.size(); ++p) {
        fos::Bitmap bitmap{60, 60, std::vector<std::uint8_t>(3UL * 60 * 60, 200)};
        for (std::size_t byte = p; byte < bitmap.rgb.size(); byte += 3) {
          bitmap.rgb[byte] = static_cast<std::uint8_t>(byte / 60);
        }
        fos::write_png(submission_folder(folder, one.id) / stage.pictures[p], bitmap);
      }
    }
    all.push_back(summarize(one));
  }
  write_class_files(folder, example_run(), all, settings);
}
