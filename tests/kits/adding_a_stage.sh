#!/usr/bin/env bash
# adding_a_stage.sh ROOT BUILD: follows docs/en/adding-a-stage.md to the letter on a copy of the tree. Its
# files and commands are taken from the page, in its order; and the new stage must then be there for every
# part of the toolkit, with no other file changed.
#
# Where bwrap can, the copy stands in the tree's own place, so that what is built already is built no more.
# shellcheck disable=SC2317 # functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
unset FOS_LANG LC_MESSAGES
export LC_ALL=C.UTF-8
COPY=$WORK/copy
PLACE=$COPY # where the copy's commands see it
FAILURES=0
failed() {
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $*"
}
check() { "${@:2}" || failed "$1"; } # WHAT COMMAND…
# in_copy COMMAND: in bash; its words are in $WORK/said.
in_copy() {
  if [[ $PLACE == "$COPY" ]]; then
    (cd "$COPY" && bash -c "$1")
  else
    bwrap --dev-bind / / --bind "$COPY" "$ROOT" --chdir "$ROOT" bash -c "$1"
  fi >"$WORK/said" 2>&1
}
said() { grep -qF -- "$1" "$WORK/said"; }

# blocks PAGE: its blocks of code into $WORK/blocks/01 and so on: a line that says what for, which is the
# file that was named last before it, or sh, and the block.
blocks() {
  rm -rf "$WORK/blocks" && mkdir "$WORK/blocks"
  awk -v folder="$WORK/blocks" '
    /^\*\*`.*`\*\*$/ { file = substr($0, 4, length($0) - 6); next }
    /^```/ && !inside { inside = 1; out = sprintf("%s/%02d", folder, ++n); print $0 == "```sh" ? "sh" : file >out; next }
    /^```/ { inside = 0; close(out); next }
    inside { print >out }' "$1"
}
# fill_hole FILE BLOCK: the first hole that is still as in the stub.
fill_hole() {
  awk -v block="$2" '
    /--- your code starts here ---/ { print; hole = 1; text = ""; next }
    hole && /--- your code ends here ---/ {
      if (!filled && text ~ /unwritten\(/) { filled = 1; while ((getline line <block) > 0) print line } else printf "%s", text
      hole = 0
    }
    hole { text = text $0 "\n"; next }
    { print }' "$1" >"$WORK/filled" && cp "$WORK/filled" "$1"
}
# add_entry FILE BLOCK: after the last stage, with a comma between.
add_entry() {
  awk -v block="$2" '
    { line[NR] = $0 }
    END {
      for (i = 1; i <= NR - 3; i++) print line[i]
      print line[NR - 2] ","
      while ((getline entry <block) > 0) print entry
      print line[NR - 1]; print line[NR]
    }' "$1" >"$WORK/list" && cp "$WORK/list" "$1"
}
# the_stages_part: what ./lab test does for one stage.
the_stages_part() {
  in_copy 'cmake --build build/release --target fos_mistakes stage_under_test lab_no_ambient solution_no_ambient \
    solution_no_ambient_float solution_no_ambient_extended variant_right variant_right_float variant_wrong \
    variant_wrong_float && ctest --test-dir build/release --output-on-failure -R "_no_ambient|^house_"' || return
  tail -n 30 "$WORK/said" | grep -A30 'tests passed'
  check "its proofs ran" grep -q 'proof_no_ambient .*Passed' "$WORK/said"
  check "its stub fails" grep -q 'stub_no_ambient .*Passed' "$WORK/said"
  check "its solution passes at three precisions" test "$(grep -c 'solution_no_ambient.* Passed' "$WORK/said")" == 3
}
marks() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR == 2 { print $at["total"] }' "$1"; }
# run_command LINE: as a reader of the page types it.
run_command() {
  local expected=0
  [[ $1 == *'# fails'* ]] && expected=1
  if [[ $1 == './lab test' ]]; then
    the_stages_part
  else
    in_copy "$1"
  fi
  local status=$?
  ((status == expected)) || failed "$1: status $status: $(tail -n 30 "$WORK/said")"
}

cd "$ROOT" || exit 3
mkdir "$COPY"
for path in * .[!.]*; do
  case $path in build | .git | *.zip) ;; *) cp -a -- "$path" "$COPY/" ;; esac
done
mkdir "$COPY/build"
if [[ $BUILD == "$ROOT/build/release" ]] && bwrap --dev-bind / / --bind "$COPY" "$ROOT" true 2>/dev/null; then
  PLACE=$ROOT
  cp -a "$BUILD" "$COPY/build/release"
else
  echo 'bwrap cannot put the copy in the place of the tree: it is built from nothing'
  in_copy 'cmake -S . -B build/release -G Ninja -DFOS_TESTS=ON' || failed "configuring"
fi

blocks docs/el/adding-a-stage.md && mv "$WORK/blocks" "$WORK/greek"
blocks docs/en/adding-a-stage.md
check "both languages show the same" diff -r "$WORK/greek" "$WORK/blocks"
named=()
for block in "$WORK"/blocks/*; do
  what=$(head -n 1 "$block")
  tail -n +2 "$block" >"$WORK/block"
  case $what in
    sh) while IFS= read -r line; do run_command "$line"; done <"$WORK/block" ;;
    labs/stages.json) add_entry "$COPY/$what" "$WORK/block" ;;
    solutions/*)
      [[ -e $COPY/$what ]] || cp "$COPY/labs/${what#solutions/}" "$COPY/$what"
      fill_hole "$COPY/$what" "$WORK/block"
      ;;
    *) cp "$WORK/block" "$COPY/$what" ;;
  esac
  [[ $what == sh || " ${named[*]} " == *" $what "* ]] || named+=("$what")
  case $what in # what a command has said, looked at where it was given
    sh)
      grep -q 'lab check' "$WORK/block" && check "a hint" said 'no_ambient: hint 1 of 2'
      if grep -q 'lab grade' "$WORK/block"; then
        check "full marks" test "$(marks "$COPY/build/results/grades.csv")" == 10
      fi
      ;;
  esac
done
check "the page names its files" test "${#named[@]}" == 6

# The picture and the kit have it; the files that changed are those of the page, the copied stub, the data.
check "the picture" test -s "$COPY/build/images/no_ambient-solution.png"
mkdir "$WORK/kit" && (cd "$WORK/kit" && cmake -E tar xf "$COPY/build/kits/fos-student-lecture-4.zip")
for file in labs/lecture04/no_ambient.cpp tests/check/stages/no_ambient_test.cpp docs/el/stage-no_ambient.md; do
  check "the kit has $file" cmp "$COPY/$file" "$WORK/kit/fos-student-lecture-4/$file"
done
changed=$(diff -rq --exclude=build --exclude=.git --exclude='*.zip' "$ROOT" "$COPY" |
  sed -E "s,^Only in $COPY/(.*): ,\1/,; s,^Files $ROOT/(.*) and .*,\1," | LC_ALL=C sort)
expected=$(printf '%s\n' "${named[@]}" tests/check/shipped/lecture04/no_ambient.cpp \
  tests/misconceptions/data/no_ambient.mistakes | LC_ALL=C sort)
check "no other file has changed" diff <(echo "$expected") <(echo "$changed")
for file in labs/lecture04/no_ambient.cpp solutions/lecture04/no_ambient.cpp tests/check/stages/no_ambient_test.cpp; do
  ! command -v clang-format >/dev/null || check "the format of $file" clang-format --dry-run -Werror "$COPY/$file"
done
echo "$FAILURES failed"
((FAILURES == 0))
