#!/usr/bin/env bash
# kit_test.sh ROOT BUILD: a student's kit, used as a student would, from the zip to the mark: unpacked into
# an empty folder, configured and built there from nothing, checked, filled in, handed in; and what was
# handed in is graded by the real tree. For the lectures 3 and 4.
# shellcheck disable=SC2317 # functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
unset FOS_LANG LC_MESSAGES
export LC_ALL=C.UTF-8
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $1: $(tail -n 20 "$WORK/said")"
}
# student COMMAND…: ./lab in the kit; STATUS and, in $WORK/said, its words.
student() {
  (cd "$KIT" && ./lab "$@") >"$WORK/said" 2>&1
  STATUS=$?
}
said() { grep -qF -- "$1" "$WORK/said"; }

# no_solution_in FOLDER LECTURE: what that lecture's solutions have in their holes stands nowhere in the
# kit, but for lines that a stub has too. Short lines are anybody's.
no_solution_in() {
  local solution line found=0
  # shellcheck source=tests/house/stub.bash
  . "$ROOT/tests/house/stub.bash"
  for solution in "$ROOT/solutions/lecture0$2"/*.cpp; do
    while IFS= read -r line; do
      line=${line#"${line%%[! ]*}"}
      ((${#line} < 24)) || grep -rqF -- "$line" "$ROOT/tests/check/shipped" && continue
      grep -rnF --include='*.?pp' -- "$line" "$1" && echo "that is of $solution" && found=1
    done < <(hole_code "$solution")
  done
  ((found == 0))
}
# links_hold FOLDER: every link of a page leads to a file of the kit.
links_hold() {
  local page target bad=0
  while IFS=: read -r page target; do
    target=${target#](} target=${target%%[)#]*}
    [[ -z $target || $target == *:* || -e ${page%/*}/$target ]] && continue
    echo "$page: $target is not in the kit" && bad=1
  done < <(grep -roE --include='*.md' '\]\([^)]+\)' "$1")
  ((bad == 0))
}
marks() { awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i } NR == 2 { print $at["total"] }' "$1"; }

for lecture in 3 4; do
  "$ROOT/lab" kit student --lecture "$lecture" --output "$WORK/kit $lecture.zip" >"$WORK/said" 2>&1 || exit 1
  mkdir "$WORK/a student $lecture" && cd "$WORK/a student $lecture" || exit 3
  cmake -E tar xf "$WORK/kit $lecture.zip"
  KIT=$PWD/fos-student-lecture-$lecture

  forbidden=(solutions tests/grading tests/kits tests/reference/scenes tests/check/variants tests/check/broken
    tests/misconceptions/submissions tests/misconceptions/mistaken_tracer.hpp tests/numerics)
  ((lecture == 3)) && forbidden+=(common/include/fos/closest_hit.hpp labs/lecture04)
  for path in "${forbidden[@]}"; do check "lecture $lecture: without $path" test ! -e "$KIT/$path"; done
  check "lecture $lecture: no line of a solution" no_solution_in "$KIT" "$lecture"
  check "lecture $lecture: its pages" links_hold "$KIT"
  student help
  for command in render check watch hint explain reset submit; do
    check "lecture $lecture: help lists $command" said "  $command "
  done
  for command in test trade grade kit; do
    check "lecture $lecture: help does not list $command" eval "! said '  $command '"
  done

  began=$SECONDS
  student check
  echo "lecture $lecture: configured, built and checked in $((SECONDS - began)) s"
  check "lecture $lecture: stubs fail" test "$STATUS" == 1
  check "lecture $lecture: none of them is begun" said ' · 0 of '
  check "lecture $lecture: as many as there are" test \
    "$(grep -c 'not begun' "$WORK/said")" == "$(find "$KIT/labs" -name '*.cpp' | wc -l)"
  student hint flat_color
  check "lecture $lecture: a hint" said 'flat_color: hint 1 of'
  for stub in "$KIT"/labs/*/*.cpp; do cp "$ROOT/solutions/${stub#"$KIT/labs/"}" "$stub"; done
  student check
  check "lecture $lecture: solutions pass" test "$STATUS" == 0
  student render
  check "lecture $lecture: pictures" test -s "$KIT/build/images/all.png"
  student submit
  check "lecture $lecture: handed in" test "$STATUS" == 0
  mkdir "$WORK/class" && mv "$KIT/fos-submission.zip" "$WORK/class/student.zip"
  stages=$(cd "$KIT/labs" && echo lecture*/*.cpp | sed -E 's,lecture[0-9]+/,,g; s,\.cpp,,g; s, ,\,,g')
  "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$WORK/class" --stages "$stages" --seed 1 \
    --output "$WORK/results $lecture" >"$WORK/said" 2>&1
  points=$(marks "$WORK/results $lecture/grades.csv")
  check "lecture $lecture: full marks, not $points" test "$points" == $((lecture == 3 ? 20 : 100))
  rm -r "$WORK/class"
  student reset flat_color
  check "lecture $lecture: the stub comes back" cmp "$KIT/labs/lecture03/flat_color.cpp" \
    "$ROOT/tests/check/shipped/lecture03/flat_color.cpp"
done

# An instructor's kit: CMake finds every file that its tests are made of, and the rules of the house hold.
for lecture in 3 4; do
  "$ROOT/lab" kit instructor --lecture "$lecture" --output "$WORK/kit.zip" >"$WORK/said" 2>&1 || exit 1
  cmake -E tar xf "$WORK/kit.zip"
  tree=$PWD/fos-instructor-lecture-$lecture
  cmake -S "$tree" -B "$tree/build/release" -G Ninja -DFOS_TESTS=ON >"$WORK/said" 2>&1
  check "an instructor's kit of lecture $lecture is configured" test $? == 0
  for rule in includes pages shipped twins; do
    "$ROOT/tests/house/$rule.sh" "$tree" >"$WORK/said" 2>&1
    check "an instructor's kit of lecture $lecture: house/$rule" test $? == 0
  done
done

# What only the largest kit is asked: one pixel in exact arithmetic, whose packages are of ./lab explain.
student explain point 300 349
check "explain: right, line by line" test "$STATUS" == 0
check "explain: the pixel of the handout" said '161 0 0'
echo "$FAILURES failed"
((FAILURES == 0))
