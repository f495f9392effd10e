#!/usr/bin/env bash
# generate_reference_test.sh PROGRAM FOLDER: a whole scene comes out as it was committed; wrong usage
# and wrong input give one error, their exit status, and no file.
program=$1 folder=$2
out=$(mktemp -d) || exit 1
trap 'rm -rf "$out"' EXIT
failed=0
fail() { echo "$*"; failed=1; }

"$program" "$folder/scenes/tangent.scene" "$out/tangent.ref" || fail 'tangent.scene is refused'
cmp "$out/tangent.ref" "$folder/data/tangent.ref" || failed=1
rm -f "$out/tangent.ref"

# refuses STATUS WORDS ARGUMENTS…
refuses() {
  local status=$1 words=$2 message actual
  shift 2
  message=$("$program" "$@" 2>&1 >/dev/null)
  actual=$?
  [[ $actual == "$status" ]] || fail "$* gives $actual, not $status"
  [[ $message == *"$words"* ]] || fail "$* does not say '$words', but: $message"
}
echo 'sphere { center = (0, 0, x) }' >"$out/wrong.scene"
echo 'canvas_size = 2000 x 2000' >"$out/large.scene"
refuses 2 usage
refuses 2 'cannot be read' "$out/none.scene" "$out/a.ref"
refuses 2 'cannot be read' "$out" "$out/a.ref"
refuses 2 'wrong.scene:1:' "$out/wrong.scene" "$out/a.ref"
refuses 2 'more pixels' "$out/large.scene" "$out/a.ref"
refuses 3 'cannot be written' "$folder/scenes/tangent.scene" "$out/none/a.ref"
[[ $(cd "$out" && echo *) == 'large.scene wrong.scene' ]] || fail "left behind: $(ls "$out")"
exit $failed
