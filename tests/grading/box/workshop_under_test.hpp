// The workshop that the tests compile in, made once.
#pragma once

#include "grading/box/compile.hpp"
#include "grading/box/workshop.hpp"

namespace fos::grading {

const Workshop& workshop_under_test();

}  // namespace fos::grading
