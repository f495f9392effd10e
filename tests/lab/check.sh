#!/usr/bin/env bash
# `./lab check`, `watch` and `hint`: what they build, what they ask of their programs, and that a stage
# that does not build is told by its log and not by the compiler's own words.
# shellcheck disable=SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

# asked PROGRAM ARGUMENT…: that program was called last, and so.
asked() { [[ $(tail -n 1 "$STATE/calls") == "$*" ]]; }
built() { [[ $(grep -e '^ninja.*-k 0' "$STATE/calls" | tail -n 1) == *"-k 0 $1" ]]; }
bin() { echo "$TREE/build/release/bin/$1"; }
with=(--images "$TREE/build/images" --picture "$(bin fos_picture)")
log() { echo "$TREE/build/logs/lab_$1.log"; }

make_tree
lab check
check "all of them, in an overview" asked fos_check "${with[@]}" --overview \
  "flat_color=$(bin lab_flat_color)" "ambient=$(bin lab_ambient)" "point=$(bin lab_point)"
check "all of them" status 0
check "without the tests" called FOS_TESTS=OFF
check "builds these and no more" built "fos_check fos_picture lab_flat_color lab_ambient lab_point"
check "is silent by itself" test -z "$OUT$ERR"
: >"$STATE/calls"
lab check point
check "one stage" asked fos_check "${with[@]}" "point=$(bin lab_point)"
check "the second run does not configure" not called "cmake -S"
check "the second run starts ninja once" test "$(grep -c '^ninja' "$STATE/calls")" == 1
lab check point ambient
check "two stages, as asked" asked fos_check "${with[@]}" "point=$(bin lab_point)" "ambient=$(bin lab_ambient)"
lab --lang el check point
check "the program hears of the language" test "$(<"$STATE/language")" == el
for status in 1 2 3; do
  echo "$status" >"$STATE/picture-status"
  lab check point
  check "the status of the program" status "$status"
done
rm "$STATE/picture-status"

echo lab_point >"$STATE/broken"
lab check
check "a broken stage, beside the others" asked fos_check "${with[@]}" --overview \
  "flat_color=$(bin lab_flat_color)" "ambient=$(bin lab_ambient)" "point=!$(log point)"
check "a broken stage: nothing of the compiler's" test -z "$OUT$ERR"
check "a broken stage: its log" test "$(<"$(log point)")" == 'lab_point.cpp:3: error: no such thing'
check "a stage that builds has no log" not test -e "$(log ambient)"
rm "$STATE/broken"
lab check point
check "a stage that builds again has no log" not test -e "$(log point)"
echo lab_ambient >"$STATE/warns"
lab check ambient
check "a stage that builds with a warning" err 'lab_ambient.cpp:3: warning: hm'
check "a stage that builds with a warning is checked" asked fos_check "${with[@]}" "ambient=$(bin lab_ambient)"
rm "$STATE/warns"

printf '%s\n' lab_point fos_check >"$STATE/broken"
: >"$STATE/calls"
lab check
check "no checking program" status 3
check "no checking program: the compiler's words" err 'fos_check.cpp:3: error: no such thing'
check "no checking program: not those about the stage" not err 'lab_point.cpp'
check "no checking program: named" err 'the program that checks does not build'
check "no checking program: is not called" not called 'bin/fos_check'
echo fos_picture >"$STATE/broken"
lab check point
check "no picture program" status 3
check "no picture program: named" err 'makes the pictures does not build'
rm "$STATE/broken"
touch "$STATE/ninja-error"
lab check point
check "ninja itself fails" status 3
check "ninja itself fails: its words" err 'loading build.ninja'
rm "$STATE/ninja-error"

rm "$TREE/labs/lecture04/point.cpp"
lab check
check "a missing stage file" status 1
check "a missing stage file: how to get it back" err './lab reset point'
check "a missing stage file: the others are checked" asked fos_check "${with[@]}" --overview \
  "flat_color=$(bin lab_flat_color)" "ambient=$(bin lab_ambient)"
: >"$STATE/calls"
lab check point
check "only a missing stage file" status 1
check "only a missing stage file: nothing is checked" not called 'fos_check --root'
lab watch point
check "watch: a missing stage file" status 1
check "watch: a missing stage file: is not called" not called 'fos_watch --root'

make_tree
lab watch point
check "watch" asked fos_watch --root "$TREE" --build "$TREE/build/release" --stage point
check "watch builds these" built "fos_watch fos_picture"
echo 1 >"$STATE/picture-status"
lab watch point
check "watch: the status" status 1
rm "$STATE/picture-status"
echo fos_watch >"$STATE/broken"
lab watch point
check "watch: no program" status 3
rm "$STATE/broken"

lab hint point
check "hint" asked fos_hint --state "$TREE/build/hints" point
check "hint builds this" built fos_hint
lab hint --all point
check "hint --all" asked fos_hint --state "$TREE/build/hints" --all point
lab hint point --reset
check "hint --reset" asked fos_hint --state "$TREE/build/hints" --reset point
echo fos_hint >"$STATE/broken"
lab hint point
check "hint: no program" status 3
rm "$STATE/broken"
rm "$TREE/labs/lecture04/point.cpp"
lab hint point
check "a hint needs no file" status 0

finish
