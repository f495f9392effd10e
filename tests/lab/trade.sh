#!/usr/bin/env bash
# `./lab trade`: what it installs, builds and asks of the program, what it makes of failures.
# shellcheck disable=SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

asked() { [[ -e $STATE/picture && $(<"$STATE/picture") == "$(printf '%s\n' "$@")" ]]; }
built() { [[ $(grep -e '^ninja.*-k 0' "$STATE/calls" | tail -n 1) == *"-k 0 $1" ]]; }
bin="$TREE/build/release/bin"
scene="$TREE/labs/scenes/lecture.scene"
yours='fos_trade empty_stage empty_stage_float empty_stage_extended lab_point'

make_tree
lab trade
check "the lecture's scene" status 0
check "the lecture's scene" asked --scene "$scene"
check "with the tests" called 'FOS_TESTS=ON'
check "builds the program alone" built fos_trade
check "nothing is installed" not called apt-get

lab trade point --csv=x.csv
check "a stage" asked --scene "$scene" --csv x.csv --stage point --programs "$bin"
check "a stage" called "-k 0 $yours"
check "a stage at every precision" built 'lab_point_float lab_point_extended'
mkdir -p "$WORK/my files" && touch "$WORK/my files/a & b.scene"
lab trade --scene 'my files/a & b.scene' --csv 'my files/t t.CSV'
check "paths with spaces" asked --scene 'my files/a & b.scene' --csv 'my files/t t.CSV'
lab --lang el trade
check "the program hears of the language" test "$(<"$STATE/language")" == el

# The other studies, each a program of its own.
lab trade --plan --scene 'my files/a & b.scene'
check "the plan" built fos_plan
check "the plan" asked --scene 'my files/a & b.scene'
lab trade --growth --csv x.csv
check "the growth" built fos_growth
check "the growth" asked --csv x.csv
lab trade --extremes sun floor --csv=x.csv
check "the extremes" built fos_extremes
check "the extremes" asked --csv x.csv sun floor

# A build without the tests is configured anew, one with them is not.
lab render point
: >"$STATE/calls"
lab trade
check "a build without the tests" called 'FOS_TESTS=ON'
printf 'FOS_TESTS:BOOL=ON\nx\n' >>"$TREE/build/release/CMakeCache.txt"
: >"$STATE/calls"
lab trade
check "a build with the tests" not called 'cmake -S'

# gnuplot, for --plot only.
rm "$STATE/installed-gnuplot-nox"
: >"$STATE/calls"
lab trade
check "without --plot, no gnuplot is asked for" not called apt-get
lab trade --plot x.svg
check "--plot asks for gnuplot" called 'install -y --no-remove --no-install-recommends gnuplot-nox'
check "gnuplot did not come: before anything is measured" status 3
check "gnuplot did not come" err 'no gnuplot'
pretend gnuplot <<<''
rm "$STATE/installed-gnuplot-nox"
: >"$STATE/calls"
lab trade --plot x.svg
check "a gnuplot of another package" status 0
check "a gnuplot of another package" not called apt-get
check "a gnuplot of another package" asked --scene "$scene" --plot x.svg

for status in 1 2 3; do
  echo "$status" >"$STATE/picture-status"
  lab trade
  check "the status of the program" status "$status"
done
rm "$STATE/picture-status" "$STATE/picture"
echo lab_point_float >"$STATE/broken"
lab trade point
check "a broken stage" status 1
check "a broken stage: the compiler's words" err 'lab_point_float.cpp:3: error: no such thing'
check "a broken stage is named" err "'point_float' does not build"
check "a broken stage: nothing is measured" not test -e "$STATE/picture"
echo lab_point >"$STATE/broken"
: >"$STATE/calls"
lab trade point
check "a broken stage at double" status 1
check "a broken stage at double: the others are not tried" not called lab_point_float
for target in fos_trade empty_stage_extended; do
  echo "$target" >"$STATE/broken"
  lab trade point
  check "$target does not build" status 3
  check "$target does not build: nothing is measured" not test -e "$STATE/picture"
done
rm "$STATE/broken" "$TREE/labs/lecture04/point.cpp"
lab trade point
check "a missing stage file" status 1
check "a missing stage file is named" err 'labs/lecture04/point.cpp'

finish
