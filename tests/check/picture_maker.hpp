// The picture program, kept running: it takes 0.3 s and more to start, because it loads
// OpenImageIO, and then makes a picture in well under 0.1 s.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>

#include "fos/picture_job.hpp"

namespace fos {

/// One `fos_picture serve`, which ends with this object, or with this process.
class PictureMaker {
 public:
  /// Starts it, and does not wait: what comes before the first picture hides the start.
  explicit PictureMaker(std::filesystem::path program);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// Makes the picture, and waits for it. False where it was not made; error() then says why. A
  /// program that has died or does not answer is started anew for the next picture.
  bool make(const PictureJob& job);

  const std::string& error() const { return error_; }

  /// The running program's process, or -1.
  pid_t process() const { return process_; }

  /// How long a picture may take.
  static constexpr std::chrono::seconds patience{20};

 private:
  void start();
  void stop();
  bool send(const std::string& bytes, std::chrono::steady_clock::time_point deadline);
  std::string receive_line(std::chrono::steady_clock::time_point deadline);
  bool failed(const std::string& why);

  std::filesystem::path program_;
  pid_t process_ = -1;
  int socket_ = -1;  // its standard input and output
  std::string error_;
};

}  // namespace fos
