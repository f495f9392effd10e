#!/usr/bin/env bash
# includes.sh ROOT: who may include what (the rules of the house). Prints what breaks a rule.
cd "$1" || exit 1
broken=0

# includes FOLDER_OR_FILE…: its own headers as it includes them, as `file:header`.
includes() {
  grep -rEo --include='*.cpp' --include='*.hpp' '^ *# *include *("[^"]+"|<fos/[^>]+>)' "$@" \
    2>/dev/null | sed -E 's/: *# *include *["<]/:/; s/[">]$//'
}
# rule WORDS…: reports the lines on standard input, if there are any.
rule() {
  local line
  while IFS= read -r line; do
    echo "$*: $line"
    broken=1
  done
}

rule 'common includes from common only' < <(
  includes common | while IFS=: read -r file header; do
    [[ $header == fos/stages.inc || -e common/include/$header || -e common/src/$header ||
      -e common/text/$header ]] && [[ $header != *..* ]] || echo "$file: $header"
  done)
rule 'a stage includes fos/ headers only' < <(
  includes labs solutions | grep -v ':fos/[a-z_]*\.hpp$')
rule 'a figure includes fos/ headers and its own' < <(
  includes docs/figures | while IFS=: read -r file header; do
    [[ $header == fos/* || -e docs/figures/$header ]] && [[ $header != *..* ]] ||
      echo "$file: $header"
  done)
rule 'lecture 3 is built without closest_hit.hpp' < <(
  includes labs/lecture03 solutions/lecture03 | grep closest_hit)
rule 'of common, the oracle includes scene_text.hpp only' < <(
  includes tests/reference | grep -E ':(fos/|.*\.\.)' | grep -v ':fos/scene_text\.hpp$')
rule 'scene.hpp knows vectors and nothing else' < <(
  grep -EH '^ *# *include' common/include/fos/scene.hpp | grep -vE '<vector>|"fos/math.hpp"')
rule 'OpenImageIO stands behind the picture door' < <(
  grep -rlE '^ *# *include *[<"]OpenImageIO' common labs solutions tests |
    grep -vE '^(common/src/(picture|oiio_utf8)|tests/common/picture_test)\.cpp$')
rule 'no test links a stage' < <(
  find tests -name CMakeLists.txt -exec grep -EnH 'target_link_libraries.*\b(lab|solution)_' {} +)
exit $broken
