#!/usr/bin/env bash
# `./lab explain`: what it builds and asks of the program, and what it makes of failures.
# shellcheck disable=SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

asked() { [[ -e $STATE/picture && $(<"$STATE/picture") == "$(printf '%s\n' "$@")" ]]; }
built() { [[ $(grep -e '^ninja.*-k 0' "$STATE/calls" | tail -n 1) == *"-k 0 $1" ]]; }
yours="$TREE/build/release/bin/lab_point"
scene="$TREE/labs/scenes/lecture.scene"

make_tree
lab explain point 300 349
check "the lecture's scene" status 0
check "the lecture's scene" asked --stage point --scene "$scene" --program "$yours" 300 349
check "with what explains" called 'FOS_EXPLAIN=ON'
check "without the tests" called 'FOS_TESTS=OFF'
check "builds the program and the stage" built 'fos_explain lab_point'
check "nothing is installed" not called apt-get
check "is silent by itself" test -z "$OUT$ERR"

mkdir -p "$WORK/my files" && touch "$WORK/my files/a & b.scene"
lab explain --scene 'my files/a & b.scene' point 0 007
check "paths with spaces" asked --stage point --scene 'my files/a & b.scene' --program "$yours" 0 007
lab explain point --scene='my files/a & b.scene' 3 4
check "an option anywhere" asked --stage point --scene 'my files/a & b.scene' --program "$yours" 3 4
lab --lang el explain point 3 4
check "the program hears of the language" test "$(<"$STATE/language")" == el

# A build without what explains is configured anew; one with it, or with the tests, is not.
for option in FOS_TESTS FOS_EXPLAIN; do
  lab render point
  printf '%s:BOOL=ON\nx\n' "$option" >>"$TREE/build/release/CMakeCache.txt"
  : >"$STATE/calls"
  lab explain point 3 4
  check "a build with $option" not called 'cmake -S'
  rm "$TREE/build/release/build.ninja"
done
lab render point
rm "$TREE/build/release/build.ninja"
lab render point
: >"$STATE/calls"
lab explain point 3 4
check "a build without either" called 'FOS_EXPLAIN=ON'

for status in 1 2 3; do
  echo "$status" >"$STATE/picture-status"
  lab explain point 3 4
  check "the status of the program" status "$status"
done
rm "$STATE/picture-status" "$STATE/picture"
echo lab_point >"$STATE/broken"
lab explain point 3 4
check "a broken stage" status 1
check "a broken stage: the compiler's words" err 'lab_point.cpp:3: error: no such thing'
check "a broken stage is named" err "'point' does not build"
check "a broken stage: what is right, without an old program" asked --stage point --scene "$scene" 3 4
echo 2 >"$STATE/picture-status"
lab explain point 3 4
check "a broken stage, and a scene with an error" status 2
rm "$STATE/picture-status" "$STATE/picture"
echo fos_explain >"$STATE/broken"
lab explain point 3 4
check "the program does not build" status 3
check "the program does not build: it is not run" not test -e "$STATE/picture"
rm "$STATE/broken"
touch "$STATE/ninja-error"
lab explain point 3 4
check "ninja itself fails" status 3
rm "$STATE/ninja-error" "$TREE/labs/lecture04/point.cpp"
lab explain point 3 4
check "a missing stage file" status 1
check "a missing stage file is named" err 'labs/lecture04/point.cpp'
check "a missing stage file: what is right" asked --stage point --scene "$scene" 3 4

finish
