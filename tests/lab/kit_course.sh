#!/usr/bin/env bash
# `./lab kit student|instructor`: what is in the zip, and what is refused. CMake is the real one.
# shellcheck disable=SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

real() { # a tree that has what a kit is made of
  make_tree
  rm -r "$TREE"/{labs,solutions,tests/check/shipped}
  cp -R "$SOURCE/tests/kits" "$TREE/tests/kits"
  cp -R "$SOURCE/tests/check/shipped" "$TREE/tests/check/shipped"
  cp -R "$SOURCE/solutions" "$TREE/solutions"
  mkdir -p "$TREE/labs/lecture04" "$TREE/tests/grading" "$TREE/docs/en" "$TREE/docs/images"
  cp "$SOURCE/labs/stages.json" "$TREE/labs/"
  echo 'my own work' >"$TREE/labs/lecture04/point.cpp"
  mkdir -p "$TREE/common/include/fos" "$TREE/tests/check/stages"
  touch "$TREE/common/include/fos/"{closest_hit,math}.hpp "$TREE/docs/images/"{seen,unseen}.png
  touch "$TREE/tests/check/stages/"{flat_color,point}_test.cpp "$TREE/docs/en/stage-"{flat_color,point}.md
  # shellcheck disable=SC2016 # the backticks are Markdown's
  printf '%s\n' '[check](checking.md#a) and [grading' 'a class](grading.md), [a book](https://a.b/c)' \
    '[![picture](../images/seen.png)](../figures/a.html)' '```' '[](auto)' '```' >"$TREE/docs/en/start.md"
  touch "$TREE/docs/en/grading.md"
  # shellcheck disable=SC2016 # the backticks are Markdown's
  printf '%s\n' '    ./lab check point' 'build/images/point-check.png' 'a point, `point`' >"$TREE/docs/en/checking.md"
  echo '<!-- from labs/lecture04/point.cpp: trace_ray -->' >"$TREE/docs/en/quotes.md"
  rm "$WORK/bin/cmake"
  ln -s "$(command -v cmake)" "$WORK/bin/cmake"
  ln -sf "$(command -v chmod)" "$WORK/bin/chmod"
}
# kit ARGUMENT…: makes one and unpacks it into $WORK/kit.
kit() {
  lab kit "$@" --output 'a kit.zip'
  rm -rf "$WORK/kit" && mkdir "$WORK/kit" && (cd "$WORK/kit" && cmake -E tar xf '../a kit.zip')
}
in_kit() { [[ -n $(cd "$WORK/kit" && compgen -G "*/$1") ]]; }
stubs_only() { diff -r "$WORK/kit/$1/labs/lecture04" "$SOURCE/tests/check/shipped/lecture04"; }
nothing_left() { [[ -z $(shopt -s nullglob dotglob && echo "$WORK"/*.part "$TREE"/build/kits/*.part) ]]; }

real
kit student --lecture 4
check "student" status 0
check "student: the file and how much" out 'a kit.zip: '
check "student: nothing else is left" nothing_left
check "student: one folder" test "$(ls "$WORK/kit")" == fos-student-lecture-4
check "student: stubs, and not what someone wrote" stubs_only fos-student-lecture-4
check "student: the header of lecture 3's answer" in_kit common/include/fos/closest_hit.hpp
check "student: no solutions" not in_kit solutions
check "student: no grading" not in_kit tests/grading
check "student: nothing that makes kits" not in_kit tests/kits
check "student: its own front page" grep -qx '# Fos: το εργαστήριο' "$WORK"/kit/*/README.el.md
page=$(cat "$WORK"/kit/*/docs/en/start.md)
check "a link in the kit stays, another becomes its words" test "${page%%$'\n'"!["*}" == \
  $'[check](checking.md#a) and grading\na class, [a book](https://a.b/c)'
check "a link to a figure becomes its picture" grep -qx '!\[picture\](../images/seen.png)' <<<"$page"
check "code is no link" grep -qxF '[](auto)' <<<"$page"
check "the pictures of its pages" in_kit docs/images/seen.png
check "no other pictures" not in_kit docs/images/unseen.png

kit student --lecture=03
check "lecture 3" status 0
check "lecture 3: its folder" test "$(ls "$WORK/kit")" == fos-student-lecture-3
check "lecture 3: its stage" in_kit labs/lecture03/flat_color.cpp
check "lecture 3: no later stage" not in_kit 'labs/lecture04'
check "lecture 3: not its answer" not in_kit common/include/fos/closest_hit.hpp
check "lecture 3: its handout" in_kit docs/en/stage-flat_color.md
check "lecture 3: its pages name its stage" test "$(cat "$WORK"/kit/*/docs/en/checking.md)" == \
  $'    ./lab check flat_color\nbuild/images/flat_color-check.png\na point, `flat_color`'
check "lecture 3: not the page on five stages" not in_kit docs/en/start.md
check "lecture 3: no later handout" not in_kit docs/en/stage-point.md
check "lecture 3: what its stage must do" in_kit tests/check/stages/flat_color_test.cpp
check "lecture 3: not what later ones must" not in_kit tests/check/stages/point_test.cpp
check "lecture 3: no later stub to come back" not in_kit tests/check/shipped/lecture04
check "lecture 3: the list is cut" not grep -q combined "$WORK"/kit/*/labs/stages.json

touch "$TREE/labs/lecture04/point.cpp.1.old" "$TREE/fos-submission.zip"
kit instructor --lecture 4
check "instructor" status 0
check "instructor: the solutions" in_kit solutions/lecture04/point.cpp
check "instructor: the list is the same" cmp "$WORK"/kit/*/labs/stages.json "$TREE/labs/stages.json"
check "instructor: the pages that quote" in_kit docs/en/quotes.md
check "instructor: stubs" stubs_only fos-instructor-lecture-4
check "instructor: what makes kits" in_kit tests/kits/files.txt
check "instructor: no zip of someone's" not in_kit '*.zip'
kit instructor --lecture 3
check "instructor, lecture 3: no later solution" not in_kit solutions/lecture04
check "instructor, lecture 3: no page that quotes a later stage" not in_kit docs/en/quotes.md
check "instructor, lecture 3: the others" in_kit docs/en/start.md
check "instructor, lecture 3: no later stage's test" not in_kit tests/check/stages/point_test.cpp

lab kit student --lecture 4
check "without a name" out "a tree/build/kits/fos-student-lecture-4.zip: "
check "without a name: it is there" test -s "$TREE/build/kits/fos-student-lecture-4.zip"
lab --lang el kit student --lecture 4
check "in Greek" out 'αρχεία'

# refused WHAT: trouble of ours; the older zip stays.
refused() {
  lab kit student --lecture 4 --output 'a kit.zip'
  check "$1" status 3
  check "$1: said" err "a kit.zip' cannot be written"
  check "$1: the older one stays" test "$(<"$WORK/a kit.zip")" == older
  check "$1: nothing else is left" nothing_left
}
echo older >"$WORK/a kit.zip"
rm "$TREE/tests/check/shipped/lecture04/ambient.cpp"
refused "a stub is missing"
real
rm "$WORK/bin/cmake"
pretend cmake <<<"[[ \$2 != tar ]] && exec $(command -v cmake) \"\$@\""
refused "the disk is full"
real
echo '{' >"$TREE/labs/stages.json"
refused "a list of stages that is damaged"

# wrong WORDS ARGUMENT…: one line of error, status 2, and nothing is made.
wrong() {
  lab "${@:2}"
  check "wrong: ${*:2}" status 2
  check "wrong: ${*:2}" err "$1"
  check "wrong: ${*:2}" one_line_of_error
  check "wrong: ${*:2}" not test -e "$TREE/build"
}
real
mkdir "$WORK/folder.zip"
wrong 'name one kit' kit
wrong "did you mean 'student'" kit studnt --lecture 4
wrong "./lab kit student --lecture N, with N one of 3 4" kit student
wrong "there is no lecture '5'" kit student --lecture 5
wrong "there is no lecture 'τέσσερα'" kit instructor --lecture τέσσερα
wrong "there is no lecture '-3'" kit student --lecture=-3
wrong "up to which lecture" kit student --lecture=
wrong "'--lecture'" kit student --lecture
wrong "did you mean '--lecture'" kit student --lectur 4
wrong "there is no option '4'" kit student 4
wrong "'x.tar'" kit student --lecture 4 --output x.tar
wrong "'no/such/'" kit student --lecture 4 --output no/such/x.zip
wrong "folder" kit student --lecture 4 --output folder.zip

finish
