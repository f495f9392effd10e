// A compiler's message as a beginner can read it.
#pragma once

#include <string>
#include <string_view>

namespace fos {

/// Straight quotes, no fos:: and no `aka`, glm::vec<3, …> as Vec3, standard containers without
/// their allocators, no name of a warning behind.
std::string clean_message(std::string_view message);

}  // namespace fos
