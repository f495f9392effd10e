// Where nothing is named: at which link the chain from the ray to the color first goes wrong, as
// far as pixels can show it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "diagnostic_scenes.hpp"
#include "fos/frame.hpp"
#include "fos/stage_list.hpp"

namespace fos {

/// The links, in order: each can only be looked at where those before it hold.
enum class Link {
  none,        ///< nothing is wrong here, or a frame is missing, unwritten or not finite
  background,  ///< pixels that see no sphere
  spheres,     ///< which sphere is seen
  colors,      ///< the channels are not in the proportion of the sphere's color
  behind,      ///< which points a light reaches
  ambient,     ///< the light where no other reaches
  strength,    ///< how much of a light comes back
  sum,         ///< each light alone is right, together they are not
};

/// What the pixels show of the first link that is wrong, in the language of this process.
struct Location {
  Link link = Link::none;
  std::vector<std::string> words;  ///< a sentence each
};

/// `frames` as for diagnose(); `term_frames` for term_scenes(stage), in that order, to look at one
/// light at a time: without them only the ambient light is looked at. Throws MistakeDataError.
Location locate(const Stage& stage, std::span<const Frame> frames,
                std::span<const Frame> term_frames);

}  // namespace fos
