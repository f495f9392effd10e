// How much of a hand-in is looked at. All that a student can make large is cut off by one of these,
// so that no hand-in costs more than some seconds and some tens of megabytes.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fos::grading {

inline constexpr std::size_t kibibyte = 1024;
inline constexpr std::size_t mebibyte = 1024 * kibibyte;
inline constexpr std::size_t most_file = 256 * kibibyte;        ///< bytes of a stage file
inline constexpr std::size_t most_files = 100'000;              ///< in one hand-in, of any kind
inline constexpr std::size_t most_copies = 16;                  ///< of one stage file
inline constexpr std::size_t most_inner_zip = 32 * mebibyte;    ///< bytes of a zip inside a zip
inline constexpr std::size_t most_unpacked = 96 * mebibyte;     ///< bytes, of one hand-in
inline constexpr int most_zips = 64;                            ///< opened for one hand-in
inline constexpr int most_nested = 3;                           ///< zip in zip in zip, no deeper
inline constexpr std::size_t most_depth = 32;                   ///< folders in folders
inline constexpr std::size_t most_path = 4096;                  ///< bytes of a path
inline constexpr std::size_t most_notes = 20;                   ///< of one hand-in
inline constexpr std::uint64_t most_directory = 24 * mebibyte;  ///< a zip's list of its files
// PATH itself is an instructor's, not a student's: it may hold a whole course.
inline constexpr std::uint64_t most_class_directory = 256 * mebibyte;
inline constexpr std::size_t most_class_files = 2'000'000;
inline constexpr std::size_t most_table = 16 * mebibyte;  ///< bytes of a roster

}  // namespace fos::grading
