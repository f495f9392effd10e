#!/usr/bin/env bash
# `./lab kit`: which kits there are, what is in them, and every wrong word.
# shellcheck disable=SC2016,SC2317 # what the pretender expands; functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

tree_of_kits() {
  make_tree
  local name
  for name in xargs sed sort chmod mktemp; do ln -s "$(command -v "$name")" "$WORK/bin/$name"; done
  mkdir -p "$TREE/tests/grading" "$TREE/tests/misconceptions/submissions/point" "$TREE/tests/check/variants"
  cp -R "$SOURCE/tests/grading/kits" "$TREE/tests/grading/"
  cp -R "$SOURCE/tests/kits" "$TREE/tests/"
  printf '// named: x\nreturn right;\n' | tee "$TREE/tests/misconceptions/submissions/point/a.cpp" \
    >"$TREE/tests/check/variants/right.cpp"
  touch "$TREE/CMakeLists.txt" "$TREE/LICENSE" "$TREE/labs/lecture04/point.cpp.1.old" "$TREE/labs/.hidden"
  # The zip is the list of its files, and the settings that the kit has.
  pretend cmake <<'EOT'
[[ $2 == tar ]] || exit
[[ ! -e $STATE/zip-fails ]] || exit 1
{ cat "${7#*=}"; for file in {fos,.github/fos}/kit-settings.bash; do [[ -e $file ]] && cat "$file"; done
  cat .github/fos/tests/*/*/right.cpp 2>/dev/null || :; } >"$4"
EOT
}
zip="$TREE/build/kits/fos"
holds() { grep -qxF -- "$2" "$zip-$1.zip"; }

make_tree
lab kit slurm
check "without grading there is no such command" status 2
check "without grading there is no such command" err 'there is no command'
tree_of_kits
lab help kit
check "is in the help" out '--feedback marks|hints|full'
lab kit gradescope --seed 12 --feedback marks
check "gradescope" status 0
check "gradescope: says where" out 'fos-gradescope.zip: '
check "gradescope: says the seed" out 'seed 12, feedback marks'
check "gradescope: what it starts" holds gradescope run_autograder
check "gradescope: what it starts first" holds gradescope setup.sh
check "gradescope: the command" holds gradescope fos/lab
check "gradescope: solutions" holds gradescope fos/solutions/lecture04/point.cpp
check "gradescope: its seed" holds gradescope FOS_SEED=12
check "gradescope: its feedback" holds gradescope FOS_FEEDBACK=marks
check "gradescope: its language" holds gradescope FOS_LANG=en
check "nothing old" not holds gradescope fos/labs/lecture04/point.cpp.1.old
check "nothing hidden" not holds gradescope fos/labs/.hidden
check "nothing that was built" not grep -q '^fos/build' "$zip-gradescope.zip"
check "the names are in order" test -z "$(sed '/^FOS_/d' "$zip-gradescope.zip" | LC_ALL=C sort -c 2>&1)"
lab --lang el kit slurm
check "slurm" status 0
check "slurm: what it starts" holds slurm fos-slurm.sh
check "slurm: in Greek" holds slurm FOS_LANG=el
check "slurm: hints unless told" holds slurm FOS_FEEDBACK=hints
check "slurm: a seed is drawn" grep -qE '^FOS_SEED=[0-9]+$' "$zip-slurm.zip"
lab kit actions
check "actions: the workflow" holds actions .github/workflows/fos.yml
check "actions: the tree is out of the way" holds actions .github/fos/lab
check "actions: no solutions" not grep -q solutions "$zip-actions.zip"
check "actions: no right stage in other words" not holds actions 'return right;'
check "actions: but its name" holds actions '// named: x'

check "nothing is left over" test "$(cd "$TREE/build/kits" && echo .*.part)" == '.*.part'
lab kit slurm --output 'my kit.zip'
check "elsewhere, with a space" test -s "$WORK/my kit.zip"
echo older >"$WORK/my kit.zip"
touch "$STATE/zip-fails"
lab kit slurm --output 'my kit.zip'
check "it fails" status 3
check "it fails: says so" err 'cannot be written'
check "it fails: the older one stays" test "$(<"$WORK/my kit.zip")" == older
check "it fails: nothing is left over" test ! -e "$(compgen -G "$WORK/.my kit*" || echo /none)"
rm "$STATE/zip-fails"

wrong() { # WORDS ARGUMENT…
  lab kit "${@:2}"
  check "${*:2}: status 2" status 2
  check "${*:2}: one line" one_line_of_error
  check "${*:2}: $1" err "$1"
}
wrong 'gradescope actions slurm'
wrong "did you mean 'gradescope'?" gradscope
wrong "no option 'actions'" slurm actions
wrong "'--sed'; did you mean '--seed'?" slurm --sed 1
wrong 'is no seed' slurm --seed -1
wrong 'is no seed' slurm --seed 'one'
wrong 'is no seed' slurm --seed 1234567890123456789
wrong "there is no feedback 'all'" slurm --feedback all
wrong 'must end in .zip' slurm --output kit.tar
wrong 'there is no folder' slurm --output nosuch/kit.zip
wrong 'needs a value' slurm --output
finish
