#!/usr/bin/env bash
# includes_catches.sh: includes.sh finds each rule broken, one at a time.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0

fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/{common/include/fos,common/src,common/text,labs/lecture03,solutions/lecture03} \
    "$tree"/{docs/figures,tests/{reference,check}}
  printf '#include <vector>\n\n#include "fos/math.hpp"\n' >"$tree/common/include/fos/scene.hpp"
  touch "$tree"/common/include/fos/{math,scene_text,closest_hit,frame}.hpp
  echo '#include "fos/scene.hpp"' >"$tree/labs/lecture03/a.cpp"
  echo '#include "fos/scene_text.hpp"' >"$tree/tests/reference/a.cpp"
}
# breaks FILE LINE: with that line added to the file, includes.sh complains.
breaks() {
  fresh
  echo "$2" >>"$tree/$1"
  "$here/includes.sh" "$tree" >/dev/null && echo "not caught: $2 in $1" && failed=1
}

fresh
"$here/includes.sh" "$tree" || { echo 'a clean tree is refused' && failed=1; }
breaks common/src/a.cpp '#include "judge.hpp"'
breaks common/src/a.cpp '#include "../../labs/lecture03/a.cpp"'
breaks labs/lecture03/a.cpp '#include "helper.hpp"'
breaks solutions/lecture03/a.cpp '  # include "../tests/judge.hpp"'
breaks labs/lecture03/a.cpp '#include "fos/closest_hit.hpp"'
breaks labs/lecture03/a.cpp '#include <fos/closest_hit.hpp>'
breaks docs/figures/a.cpp '#include "mistakes.hpp"'
breaks docs/figures/a.cpp '#include "../../tests/check/judge.hpp"'
breaks tests/reference/a.cpp '#include "fos/frame.hpp"'
breaks tests/reference/a.cpp '#include "../../solutions/lecture03/a.cpp"'
breaks common/include/fos/scene.hpp '#include <fstream>'
breaks common/src/a.cpp '#include <OpenImageIO/imageio.h>'
breaks tests/check/CMakeLists.txt 'target_link_libraries(judge PRIVATE solution_point)'
exit $failed
