// Checks in the background, so that keys are heard meanwhile: only the newest counts.
#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "check_screen.hpp"
#include "picture_maker.hpp"
#include "view_files.hpp"

namespace fos {

/// Where things are.
struct Places {
  std::filesystem::path root;
  std::filesystem::path build;
  std::filesystem::path images() const { return root / "build" / "images"; }
  std::filesystem::path program(const std::string& name) const { return build / "bin" / name; }
};

struct CheckJob {
  const Stage* stage = nullptr;
  bool anew = false;  ///< as build_stage() has it
  Window window;
};

/// The verdict, ready to be shown.
struct Checked {
  long serial = 0;  ///< of the job
  bool passes = false;
  std::string screen;
  Spot spot;                ///< the pixel to explain first
  std::string shown_scene;  ///< `./lab explain` needs it for the picture's pixels; empty for the
                            ///< lecture's
};

/// After it: the pictures and the page's data are there, or `trouble` says why not.
struct Pictured {
  long serial = 0;
  std::string trouble;
  double seconds = 0;
};

using CheckEvent = std::variant<Checked, Pictured>;

class Checker {
 public:
  /// Throws FileError where the page cannot be written.
  Checker(Places places, Colors colors);
  ~Checker();
  Checker(const Checker&) = delete;
  Checker& operator=(const Checker&) = delete;

  /// Checks this, and drops what is being checked. Returns its serial number.
  long start(const CheckJob& job);

  int descriptor() const { return ready_; }  ///< readable when take() has something
  std::vector<CheckEvent> take();

  const ViewFiles& view() const { return view_; }

 private:
  void work(const std::stop_token& end);
  void check(const CheckJob& job, long serial, const std::stop_token& stop);
  void post(CheckEvent event);

  Places places_;
  Paint paint_;
  ViewFiles view_;
  PictureMaker maker_;  // the worker's alone
  int ready_;           // an eventfd
  std::mutex mutex_;
  std::condition_variable_any new_job_;
  std::optional<CheckJob> job_;
  long serial_ = 0;
  std::stop_source stop_;  // of the check that runs
  std::vector<CheckEvent> events_;
  std::jthread worker_;  // last, for it uses all of the above
};

}  // namespace fos
