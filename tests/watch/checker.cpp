#include "checker.hpp"

#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <utility>

#include "advice.hpp"
#include "asked.hpp"
#include "build_stage.hpp"
#include "compile_error.hpp"
#include "fos/text.hpp"

namespace fos {

Checker::Checker(Places places, Colors colors)
    : places_(std::move(places)),
      paint_(colors),
      view_(places_.images()),
      maker_(places_.program("fos_picture")),
      ready_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      worker_([this](const std::stop_token& end) { work(end); }) {}

Checker::~Checker() {
  {
    const std::scoped_lock lock(mutex_);
    stop_.request_stop();
    job_.reset();
  }
  worker_.request_stop();
  worker_.join();
  close(ready_);
}

long Checker::start(const CheckJob& job) {
  const std::scoped_lock lock(mutex_);
  stop_.request_stop();
  stop_ = std::stop_source();
  job_ = job;
  new_job_.notify_one();
  return ++serial_;
}

void Checker::post(CheckEvent event) {
  const std::scoped_lock lock(mutex_);
  events_.push_back(std::move(event));
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t told = write(ready_, &one, sizeof(one));
}

std::vector<CheckEvent> Checker::take() {
  const std::scoped_lock lock(mutex_);
  std::uint64_t count = 0;
  [[maybe_unused]] const ssize_t read_ = read(ready_, &count, sizeof(count));
  return std::exchange(events_, {});
}

void Checker::work(const std::stop_token& end) {
  for (;;) {
    std::unique_lock lock(mutex_);
    if (!new_job_.wait(lock, end, [&] { return job_.has_value(); })) return;
    const CheckJob job = *std::exchange(job_, std::nullopt);
    const long serial = serial_;
    const std::stop_token stop = stop_.get_token();
    lock.unlock();
    try {
      check(job, serial, stop);
    } catch (const Stopped&) {  // NOLINT(bugprone-empty-catch): a newer one waits
    } catch (const std::exception& error) {
      post(Checked{serial, false, say(text::watch_trouble, {error.what()}) + "\n", {}, ""});
      post(Pictured{serial, "", 0});
    }
  }
}

void Checker::check(const CheckJob& job, long serial, const std::stop_token& stop) {
  const Stage& stage = *job.stage;
  const Built built = build_stage(places_.root, places_.build, stage, job.anew, stop);
  if (stop.stop_requested()) return;
  std::optional<Findings> findings;
  Difference differs;
  std::vector<Panel> panels;
  Checked checked{serial, false, "", {}, ""};
  std::string compiler;
  std::string advice;
  if (built.is_built) {
    const auto program = places_.program("lab_" + std::string(stage.id));
    findings = examine(Questions(stage), program, patient_limits(), stop);
    differs = difference_of(*findings);
    panels = panels_of(*findings, differs);
    checked.passes = findings->passes();
    const Finding* first = first_failure(*findings);
    if (first != nullptr) advice = advise(stage, program, patient_limits(), stop).words;
    checked.screen = check_screen(*findings, advice, panels, places_.images(), paint_, job.window);
    if (!panels.empty()) checked.screen += picture_line(picture_path(stage, places_.images()));
    if (first != nullptr && first->spot) checked.spot = *first->spot;
    if (findings->shown && findings->shown->scene_name != "lecture") {
      checked.shown_scene = (places_.images() / (std::string(stage.id) + "-view.scene")).string();
    }
  } else {
    const std::string file = stage_file(stage);
    compiler = describe_compile_error(built.words, places_.root / file, file);
    checked.screen = check_screen(stage, compiler, paint_);
  }
  post(checked);

  using Clock = std::chrono::steady_clock;
  const auto began = Clock::now();
  Pictured pictured{serial, "", 0};
  if (!panels.empty() &&
      !maker_.make({picture_path(stage, places_.images()), panels, check_panel_size})) {
    pictured.trouble = maker_.error();
  }
  if (stop.stop_requested()) return;
  try {
    View view;
    view.stage = &stage;
    view.findings = findings ? &*findings : nullptr;
    view.compiler = compiler;
    view.advice = advice;
    view.difference = std::move(differs);
    const std::string trouble = view_.write(std::move(view), maker_);
    if (!trouble.empty()) pictured.trouble = trouble;
  } catch (const std::exception& error) {
    pictured.trouble = say(text::watch_no_view, {error.what()});
  }
  pictured.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  post(pictured);
}

}  // namespace fos
