// What is wrong with a file or zip, in the language of this process.
#pragma once

#include <string>

#include "container.hpp"
#include "hand_in.hpp"

namespace fos::grading {

std::string trouble_words(Trouble trouble);

/// Of a stage's file at `path`; not for none, missing and twice.
std::string why_words(Why why, const std::string& path);

}  // namespace fos::grading
