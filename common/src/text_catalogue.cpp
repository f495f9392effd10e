// The texts themselves.
#include "fos/text.hpp"

namespace fos::text {
#define TEXT(name, english, greek) constinit const Text name{english, greek};
#include "texts.def"
#undef TEXT
}  // namespace fos::text
