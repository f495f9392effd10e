// One question to a running stage program and the bytes of its answer, against one deadline.
#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <string>

namespace fos {

class Exchange {
 public:
  using Clock = std::chrono::steady_clock;

  /// The descriptors stay the caller's. `printed` is -1 where the program is not heard; else what
  /// it prints is appended to `words`, up to a few KiB. A `wall` of 0 is no deadline.
  Exchange(int requests, int frames, int printed, std::string& words, std::string to_send,
           std::chrono::milliseconds wall, const std::function<void()>& on_wait)
      : requests_(requests),
        frames_(frames),
        printed_(printed),
        words_(words),
        to_send_(std::move(to_send)),
        wall_(wall),
        on_wait_(on_wait) {}

  enum class Result { filled, closed, late };

  /// Fills `bytes` from the program, while the request is still on its way too.
  Result receive(std::span<char> bytes);

  /// How many bytes the last receive() got.
  std::size_t received() const { return received_; }

  /// What a program that has been told to end still leaves: up to `bytes.size()`, for a moment.
  std::size_t receive_last(std::span<char> bytes);

  /// What has been printed and not read yet.
  void hear_the_rest();

 private:
  bool is_late() const { return wall_.count() > 0 && Clock::now() - start_ > wall_; }
  void send_some();
  void hear_some();

  int requests_;
  int frames_;
  int printed_;
  std::string& words_;
  std::string to_send_;
  std::size_t received_ = 0;
  std::chrono::milliseconds wall_;
  const std::function<void()>& on_wait_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_sign_ = Clock::now();  // of the frame, or that somebody was told to wait
};

}  // namespace fos
