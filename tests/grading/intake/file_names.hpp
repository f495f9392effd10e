// Names of files and people: cleaned, recognised, and made safe.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fos::grading {

/// The path of a file in a zip as a relative one with `/`: backslashes of Windows turned, a drive,
/// a leading `/` and `.` dropped. Nothing where a `..` would lead elsewhere, or nothing is left.
std::optional<std::string> clean_path(std::string_view path);

/// The parts between the `/`.
std::vector<std::string_view> parts_of(std::string_view path);

/// The last part.
std::string_view file_name(std::string_view path);

/// A path for people to read, in one line: valid UTF-8, its middle left out where it is long.
std::string shown_path(std::string_view path);

/// What machines and editors put beside people's files: __MACOSX, ._a, .DS_Store, .git, Thumbs.db.
bool is_clutter(std::string_view path);

/// ASCII letters made small; others stay.
std::string lower(std::string_view text);

/// Whether the name ends in `.zip`, in any case.
bool is_zip_name(std::string_view name);

/// An archive that is not opened, by its name's ending: rar, 7z, tar, gz …; empty where it is none.
std::string_view other_archive(std::string_view name);

/// In Latin letters, small, words of [a-z0-9] kept and all else one space: Greek as ELOT 743 writes
/// it but for its diphthongs, accents dropped whether composed or not.
std::string latin(std::string_view text);

/// `name` as an id, [a-z0-9._-], at most 64 bytes, never empty, beginning with a letter or digit.
std::string safe_id(std::string_view name);

/// Whether it is such an id, so that it may name a folder.
bool is_safe_id(std::string_view id);

/// For each name an id, all different. Equal ones get a few digits of the hash of the name, so that
/// none depends on the others' order.
std::vector<std::string> unique_ids(const std::vector<std::string>& names,
                                    const std::vector<std::string>& sources);

}  // namespace fos::grading
