#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include "fos/text.hpp"

namespace fos {
namespace {

std::string line(const Text& what, std::vector<double> times) {
  std::sort(times.begin(), times.end());
  const auto ms = [](double time) { return std::to_string(std::lround(time)); };
  return say(text::watch_measured,
             {say(what), ms(times[times.size() / 2]), std::to_string(times.size()),
              ms(times.front()), ms(times.back())}) +
         "\n";
}

}  // namespace

void Measure::save_when_due(const std::filesystem::path& file, Clock::time_point now) {
  if (is_saved_ || is_done() || now < due_) return;
  is_saved_ = true;
  saved_ = Clock::now();
  std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now());
}

void Measure::verdict(Clock::time_point now) {
  if (is_saved_) {
    verdicts_.push_back(std::chrono::duration<double, std::milli>(now - saved_).count());
  }
}

void Measure::pictures(double seconds, Clock::time_point now) {
  if (is_saved_) pictures_.push_back(1000 * seconds);
  is_saved_ = false;
  due_ = now + std::chrono::milliseconds(300 + 37 * pictures_.size() % 100);
}

std::string Measure::report() const {
  return line(text::watch_measured_verdict, verdicts_) +
         line(text::watch_measured_picture, pictures_);
}

}  // namespace fos
