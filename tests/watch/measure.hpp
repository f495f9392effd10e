// How long from a save to its verdict, measured by saving.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace fos {

class Measure {
 public:
  using Clock = std::chrono::steady_clock;

  /// `count` saves; none for 0.
  explicit Measure(int count) : count_(count) {}

  bool is_on() const { return count_ > 0; }
  bool is_done() const { return static_cast<int>(pictures_.size()) >= count_; }

  /// A save that changes nothing but the file's time; a while after the last picture, and not in
  /// step with the one who looks.
  void save_when_due(const std::filesystem::path& file, Clock::time_point now);
  void verdict(Clock::time_point now);
  void pictures(double seconds, Clock::time_point now);

  /// Two lines: the median, the least and the most.
  std::string report() const;

 private:
  int count_;
  bool is_saved_ = false;
  Clock::time_point saved_;
  Clock::time_point due_;
  std::vector<double> verdicts_;  // ms
  std::vector<double> pictures_;
};

}  // namespace fos
