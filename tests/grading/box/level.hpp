// How strong the box is.
#pragma once

#include <optional>
#include <string_view>

namespace fos::grading {

/// From the strongest to none.
enum class Level {
  bubblewrap,  ///< namespaces of its own: no other files, processes or network are there
  landlock,  ///< files fenced by the kernel's Landlock, system calls filtered; a user of its own if
             ///< root
  uid,       ///< a user of its own and filtered system calls; only root can
  none       ///< limits, and nothing that is sure to keep evil in
};
inline constexpr Level levels[] = {Level::bubblewrap, Level::landlock, Level::uid, Level::none};

/// "bubblewrap", "landlock", "uid", "none".
std::string_view name(Level level);
std::optional<Level> level_named(std::string_view word);

}  // namespace fos::grading
