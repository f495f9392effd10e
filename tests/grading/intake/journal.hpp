// What is graded already, kept so that a run goes on where it was: after Ctrl-C, a crash, a power
// cut.
//
//   DIR/journal.lock              held by the run that writes
//   DIR/results/ID/result.json    written whole, and on the disk before it has its name
//   DIR/results/ID/               what else belongs to it: pictures, its page
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fos/whole_file.hpp"
#include "result.hpp"
#include "result_json.hpp"

namespace fos::grading {

/// Its functions may be called from several threads; one result is written at a time.
class Journal {
 public:
  /// Makes the folder where it is missing, and keeps it for this process: FileError (status 2)
  /// where another run writes in it, or it cannot be made or written to.
  explicit Journal(std::filesystem::path folder);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Looks through all results. Damaged ones are as if they were not there, and are named in
  /// damaged(). Throws FileError where the folder cannot be read.
  void load();
  const std::vector<std::string>& damaged() const { return damaged_; }

  /// Whether there is one of just this key that infrastructure has not kept from being judged.
  bool is_finished(std::string_view id, std::string_view key) const;

  /// The result of this id, of whatever key, from the disk; nothing where it is not there or
  /// damaged.
  std::optional<SubmissionResult> read(std::string_view id) const;

  /// The folder of a submission, made if need be. Throws FileError.
  std::filesystem::path folder_of(std::string_view id) const;

  /// Writes a result over any older one of its id. Throws FileError, and then the older one and all
  /// others are as they were.
  void write(const SubmissionResult& result);

 private:
  std::filesystem::path folder_;
  int lock_ = -1;
  std::map<std::string, ResultHead, std::less<>> heads_;
  std::vector<std::string> damaged_;
  mutable std::mutex busy_;
};

}  // namespace fos::grading
