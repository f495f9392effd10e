#!/usr/bin/env bash
# `./lab render`: what it builds, what it asks of the picture program, what it makes of failures.
# shellcheck disable=SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

# asked LINE…: the picture program was given these arguments and no others.
asked() { [[ -e $STATE/picture && $(<"$STATE/picture") == "$(printf '%s\n' "$@")" ]]; }
built() { [[ $(grep -e '^ninja.*-k 0' "$STATE/calls" | tail -n 1) == *"-k 0 $1" ]]; }
bin() { echo "$TREE/build/release/bin/$1"; }
images="$TREE/build/images"
scene="$TREE/labs/scenes/lecture.scene"

make_tree
lab render
check "all of them" status 0
check "all of them" asked render --scene "$scene" --images "$images" --sheet \
  "flat_color:flat_color:$(bin lab_flat_color)" "ambient:ambient:$(bin lab_ambient)" \
  "point:point:$(bin lab_point)" "flat_color-solution:flat_color:$(bin solution_flat_color)" \
  "ambient-solution:ambient:$(bin solution_ambient)" "point-solution:point:$(bin solution_point)"
check "without the tests" called "FOS_TESTS=OFF"
check "builds these and no more" built \
  "fos_picture lab_flat_color lab_ambient lab_point solution_flat_color solution_ambient solution_point"
check "is silent by itself" test -z "$OUT$ERR"
: >"$STATE/calls"
lab render point
check "one stage" asked render --scene "$scene" --images "$images" "point:point:$(bin lab_point)"
check "one stage builds itself" built "fos_picture lab_point"
check "the second run does not configure" not called "cmake -S"
check "the second run does not install" not called apt-get

lab render ambient point --solution --size=30x20
check "solutions" asked render --scene "$scene" --images "$images" --size 30x20 \
  "ambient-solution:ambient:$(bin solution_ambient)" "point-solution:point:$(bin solution_point)"
mkdir -p "$WORK/my files" && touch "$WORK/my files/a & b.scene"
lab render --output 'my files/x.exr' point --precision float --scene 'my files/a & b.scene'
check "paths with spaces, relative to the person" asked render --scene 'my files/a & b.scene' \
  --images "$images" --output 'my files/x.exr' "point:point:$(bin lab_point_float)"
lab render point --output X.TIFF
check "an extension in capitals" status 0
lab render point --precision=extended
check "extended" built "fos_picture lab_point_extended"
lab render point --precision=float --precision=double
check "the last one counts" built "fos_picture lab_point"
lab --lang el render point
check "the programs hear of the language" test "$(<"$STATE/language")" == el

echo lab_point >"$STATE/broken"
lab render
check "a broken stage" status 1
check "a broken stage: the compiler's words" err 'lab_point.cpp:3: error: no such thing'
check "a broken stage: not its command" not err '/usr/bin/g++'
check "a broken stage: not ninja's words" not err ninja
check "a broken stage is named" err "'point' does not build"
check "a broken stage: the others, and no old program" asked render --scene "$scene" \
  --images "$images" --sheet "flat_color:flat_color:$(bin lab_flat_color)" \
  "ambient:ambient:$(bin lab_ambient)" "flat_color-solution:flat_color:$(bin solution_flat_color)" \
  "ambient-solution:ambient:$(bin solution_ambient)" "point-solution:point:$(bin solution_point)"
rm "$STATE/picture"
lab render point
check "only a broken stage" status 1
check "only a broken stage: no picture" not test -e "$STATE/picture"
echo fos_picture >"$STATE/broken"
lab render point
check "no picture program" status 3
check "no picture program: no picture" not test -e "$STATE/picture"
rm "$STATE/broken"
touch "$STATE/ninja-error"
lab render point
check "ninja itself fails" status 3
check "ninja itself fails: its words" err 'loading build.ninja'
rm "$STATE/ninja-error"

for status in 1 2 3; do
  echo "$status" >"$STATE/picture-status"
  lab render point
  check "the status of the picture program" status "$status"
done
echo lab_ambient >"$STATE/broken"
lab render point ambient
check "the worst status" status 3
rm "$STATE/broken"
echo 0 >"$STATE/picture-status"

rm "$TREE/labs/lecture04/point.cpp" "$TREE/solutions/lecture04/point.cpp"
lab render
check "a missing stage file" status 1
check "a missing stage file is named" err 'labs/lecture04/point.cpp'
check "a missing solution is no error" not err 'solutions/lecture04/point.cpp'
check "a missing file is not built" not built "lab_point"
rm -r "$TREE/solutions"
lab render ambient
check "without solutions" status 0
touch "$TREE/labs/lecture04/point.cpp"

# The build folder.
make_tree
lab render point
touch "$TREE/build/release/old"
mv "$TREE" "$WORK/moved tree" && TREE="$WORK/moved tree"
: >"$STATE/calls"
lab render point
check "a moved tree is configured anew" called "cmake -S $TREE"
check "a moved tree keeps nothing that names its old place" not test -e "$TREE/build/release/old"
: >"$STATE/calls"
touch -d '+1 hour' "$TREE/labs/stages.json"
lab render point
check "a changed list of stages is read anew" called "cmake -S"
make_tree
echo 3.21.9 >"$STATE/cmake"
lab render
check "an old cmake" status 3
check "an old cmake" err '3.21'
rm "$STATE/cmake"
touch "$STATE/cmake-fails"
lab render
check "cmake fails" status 3
check "cmake fails: its error" err 'CMake Error: could not find GLM'
check "cmake fails: not its chatter" not err hello
check "cmake fails: leaves nothing half-made" nothing_built
make_tree
touch "$TREE/build"
lab render
check "no room for the build folder" status 3
check "no room for the build folder" err "$TREE/build"
if [[ $(id -u) != 0 ]]; then # root may write anywhere
  make_tree
  mkdir "$TREE/build" && chmod a-w "$TREE/build"
  lab render
  check "a build folder that may not be written" status 3
  check "a build folder that may not be written" err "$TREE/build"
fi

finish
