// Which toolkit has graded: another one may judge otherwise.
#pragma once

#include <filesystem>
#include <string>

namespace fos::grading {

/// Twelve digits of the hash of all that results depend on: the grader, what stages are built with,
/// the references, the mistakes, the headers. Throws FileError where one of them cannot be read.
std::string toolkit_version(const std::filesystem::path& root, const std::filesystem::path& build);

}  // namespace fos::grading
