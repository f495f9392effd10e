// One submission from its files to its result: compiled and asked in the box, judged outside it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "grading/box/box.hpp"
#include "grading/box/compile.hpp"
#include "grading/intake/hand_in.hpp"
#include "picture_maker.hpp"
#include "result.hpp"
#include "stage_questions.hpp"
#include "stage_score.hpp"

namespace fos::grading {

/// What is the same for all submissions of a run.
struct Course {
  std::vector<StageQuestions> stages;  ///< those that are graded, in the course's order
  Shares shares;
  const Workshop* workshop = nullptr;
  std::filesystem::path picture_program;
  BoxSetting box;
  std::uint64_t seed = 0;
};

/// One at a time; several graders share nothing but the course.
class SubmissionGrader {
 public:
  /// `scratch` is a folder for this grader alone.
  SubmissionGrader(const Course& course, unsigned slot, std::filesystem::path scratch);

  /// Everything but its key, overrides and username of a roster. Pictures of what is wrong are
  /// written into `pictures`, made if need be. `on_wait` is called a few times a second; what it
  /// throws passes through. Infrastructure trouble is tried once more, and then told in the result.
  SubmissionResult grade(const HandIn& hand_in, const std::filesystem::path& pictures,
                         const std::function<void()>& on_wait);

 private:
  StageResult grade_stage(const StageQuestions& questions, const StageFile& file,
                          const std::filesystem::path& pictures);
  StageResult ask_stage(const StageQuestions& questions, const StageFile& file,
                        const std::filesystem::path& pictures);
  void advise_on(StageResult& result, StageProgram& program, const StageQuestions& questions,
                 const std::vector<Asked>& answers);
  CompileResult compiled(const StageQuestions& questions, const StageFile& file, bool sanitized);
  std::filesystem::path program_of(const Stage& stage) const;
  std::string where_it_crashed(const StageQuestions& questions, const StageFile& file,
                               const std::vector<Asked>& answers);
  void make_pictures(StageResult& result, const Findings& findings,
                     const std::filesystem::path& folder);

  const Course& course_;
  unsigned slot_;
  Box box_;
  std::filesystem::path scratch_;
  PictureMaker maker_;
  std::function<void()> on_wait_;
  std::set<Mistake> charged_;  // in the stages before, of the submission at hand
};

}  // namespace fos::grading
