#!/usr/bin/env bash
# `./lab grade`: what it sets up and builds, and that its words reach the program that grades.
# shellcheck disable=SC2016,SC2317 # what the pretender expands; functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

asked() { [[ -e $STATE/picture && $(<"$STATE/picture") == "$(printf '%s\n' "$@")" ]]; }
built() { [[ $(grep -e '^ninja.*-k 0' "$STATE/calls" | tail -n 1) == *"-k 0 $1" ]]; }
tree_of_grading() {
  make_tree
  mkdir -p "$TREE/tests/grading"
  cp "$SOURCE/tests/grading/grade.bash" "$TREE/tests/grading/"
  printf '#!/bin/bash\necho "self_test $*" >>"$STATE/calls"\n' >"$TREE/tests/grading/self_test.sh"
  chmod +x "$TREE/tests/grading/self_test.sh"
}
its_own=(--root "$TREE" --build "$TREE/build/release")

make_tree
lab grade x --output y
check "a kit without grading" status 2
check "a kit without grading" err 'there is no command'
tree_of_grading
lab help
check "is in the help" out 'grade PATH'
lab grade
check "nothing to grade" status 2
check "nothing to grade" err '--output DIR'
check "nothing to grade: nothing is built" nothing_built
lab --lang el grade
check "nothing to grade, in Greek" err 'χρειάζεται'

lab grade 'my class' --output 'my results' --seed 3
check "grades" status 0
check "its words, with spaces" asked "${its_own[@]}" 'my class' --output 'my results' --seed 3
check "with the tests" called 'FOS_TESTS=ON'
check "builds what grades" built 'fos_grade fos_picture'
check "nothing is installed" not called apt-get
lab --lang el grade x --output y
check "the program hears of the language" test "$(<"$STATE/language")" == el
printf 'FOS_TESTS:BOOL=ON\nx\n' >>"$TREE/build/release/CMakeCache.txt"
: >"$STATE/calls"
lab grade x --output y
check "a build that knows grading is not configured again" not called 'cmake -S'
printf 'FOS_ZIP_HEADERS:PATH=FOS_ZIP_HEADERS-NOTFOUND\n' >>"$TREE/build/release/CMakeCache.txt"
lab grade x --output y
check "one that was made without its packages is" called 'cmake -S'

lab grade --self-test --box landlock
check "the red team" called "self_test $TREE $TREE/build/release --box landlock"
echo 3 >"$STATE/picture-status"
lab grade x --output y
check "what the program ends with" status 3
rm "$STATE/picture-status"
echo fos_grade >"$STATE/broken"
lab grade x --output y
check "does not build" status 3
rm "$STATE/broken" "$STATE/installed-bubblewrap"
lab grade x --output y
check "the box is installed" called 'install -y --no-remove --no-install-recommends bubblewrap'
finish
