#!/usr/bin/env bash
# `./lab test` and `./lab test all`: what runs, and that nothing counts as passed that did not.
# shellcheck disable=SC2016,SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

make_tree
lab test
check "test" status 0
check "test: with the tests" called FOS_TESTS=ON
check "test: builds everything" called '-k 0 all'
check "test: runs the tests" called "ctest --test-dir $TREE/build/release"
check "test: no heavy package is asked for" not called apt-get
lab --lang el test
check "the tests hear nothing of the person's language" test "$(<"$STATE/language")" == none
touch "$STATE/ctest-fails"
lab test
check "a test fails" status 1
rm "$STATE/ctest-fails"
echo "of an older run" | tee "$TREE/build/release/"{mistakes,submissions}-share.txt >/dev/null
lab test
check "the shares: none of an older run" not out "of an older run"
check "the shares: none are needed" status 0
pretend ctest <<'EOT'
echo "all of them named" >"$2/mistakes-share.txt"
echo "none wrongly" >"$2/submissions-share.txt"
[[ ! -e $STATE/ctest-fails ]]
EOT
lab test
check "the shares: the last lines" test "${OUT: -30}" == $'all of them named\nnone wrongly'
touch "$STATE/ctest-fails"
lab test
check "the shares: not when a test fails" status 1
check "the shares: not when a test fails" not out named
rm "$STATE/ctest-fails"
echo all >"$STATE/broken"
: >"$STATE/calls"
lab test
check "not everything builds" status 1
check "not everything builds: nothing is tested" not called ctest
rm "$STATE/broken" "$STATE/installed-catch2"
lab test
check "the packages of the tests" called 'install -y --no-remove --no-install-recommends catch2'

# The heavy checks. The scripts of their steps, which here only pretend:
SCRIPTS=(
  watch/viewer_test
  grading/report/report_test
  figures/figures_test
  grading/self_test
  site/site_test
  house/spelling
  house/spelling_catches
  kits/kit_test
  kits/adding_a_stage
  grading/kits/kits_test
  grading/kits/slurm_test
)
STEPS=$(grep -c '^  step ' "$SOURCE/tests/lab/heavy_checks.bash")
BROWSERS=$(grep -cE "^  step [a-z_]* '?chromedriver[ ']" "$SOURCE/tests/lab/heavy_checks.bash")
WASM=$(grep -cE "^  step [a-z_]* '.*wasm-ld" "$SOURCE/tests/lab/heavy_checks.bash")
tools() {
  local tool
  for tool in clang-format shellcheck hunspell clang++ clang-tidy chromedriver wasm-ld mkdocs bwrap python3 slurmctld; do
    pretend "$tool" <<'EOT'
[[ $(cat "$STATE/fails" 2>/dev/null) != "${0##*/}" ]] || { echo "what it says"; exit 1; }
EOT
  done
  local script
  mkdir -p "$TREE/tests/lab"
  cat >"$TREE/tests/lab/tidy.py" <<'EOT'
#!/bin/bash
echo "tidy $*" >>"$STATE/calls"
clang-tidy
EOT
  chmod +x "$TREE/tests/lab/tidy.py"
  mkdir -p "$TREE/docs/site"
  echo 'docs() { echo docs >>"$STATE/calls"; }' >"$TREE/docs/site/docs.bash"
  for script in "${SCRIPTS[@]}"; do
    mkdir -p "$TREE/tests/${script%/*}"
    cat >"$TREE/tests/$script.sh" <<'EOT'
#!/bin/bash
name=${0##*/}
echo "${name%.sh} $*" >>"$STATE/calls"
[[ ! -e $STATE/${name%.sh}-fails ]]
EOT
    chmod +x "$TREE/tests/$script.sh"
  done
}
own_tests_ran() { grep -qE "^ctest .*/release --output-on-failure -j [0-9]+ *$" "$STATE/calls"; }
closing() { # FAILED [NOT_RUN]
  [[ ${OUT##*$'\n'} == "$((STEPS - $1 - ${2:-0})) passed, $1 failed" ]]
}
make_tree
tools
lab test all
check "all" status 0
check "all: the last line" closing 0
check "all: no step is left out" not out 'NOT RUN'
check "all: the fuzzer runs a minute" called 'max_total_time=60'
check "all: the sanitizers, by clang++" called 'FOS_SANITIZE=ON'
check "all: random scenes" called "ctest --test-dir $TREE/build/release --output-on-failure"
check "all: random scenes" called '-C Heavy'
check "all: the page in the browser" called "viewer_test $TREE $TREE/build/release"
check "all: the reports in the browser" called "report_test $TREE $TREE/build/release"
check "all: the site is made, and read in the browser" called $'docs\n'"site_test $TREE"
check "all: the figures in the browser" called "figures_test $TREE $TREE/build/release"
check "all: the red team before the box" called "self_test $TREE $TREE/build/release"
check "all: the spelling" called "spelling $TREE"
check "all: a student's kit" called "kit_test $TREE $TREE/build/release"
check "all: a stage is added" called "adding_a_stage $TREE $TREE/build/release"
check "all: the kits, as their platforms use them" called "kits_test $TREE $TREE/build/release"
check "all: one of them before Slurm" called "slurm_test $TREE $TREE/build/release"
check "all: warnings are errors, for clang++" called '-DCMAKE_CXX_COMPILER=clang++ -DFOS_WERROR=ON'
check "all: the linter has the commands of clang++" called "tidy $TREE/build/clang/compile_commands.json"
: >"$STATE/calls"
lab test all
check "again: what has just passed is not tested again" not own_tests_ran
check "again: and counts" closing 0
touch "$TREE/labs/new" && lab test all
check "something is new: the tests run" own_tests_ran
for tool in clang-format shellcheck clang-tidy; do
  echo "$tool" >"$STATE/fails"
  lab test all
  check "$tool fails" status 1
  check "$tool fails: the others go on" closing 1
  check "$tool fails: its words" out 'what it says'
done
rm "$STATE/fails"
echo all >"$STATE/broken"
: >"$STATE/calls"
touch "$TREE/labs/new" && lab test all
check "not everything builds" status 1
check "not everything builds: the other checks go on" called 'max_total_time=60'
rm "$STATE/broken"
touch "$STATE/ctest-fails"
touch "$TREE/labs/new" && lab test all
check "tests fail, in two builds, and random scenes" closing 3
check "tests that fail have not passed" not test -e "$TREE/build/release/tests-passed"
rm "$STATE/ctest-fails"
echo 77 >"$STATE/picture-status" # the fuzzer pretends, like every program here
lab test all
check "the fuzzer finds something" closing 1
rm "$STATE/picture-status"
for script in "${SCRIPTS[@]##*/}"; do
  touch "$STATE/$script-fails"
  lab test all
  check "$script fails" closing 1
  rm "$STATE/$script-fails"
done
printf '#!/bin/bash\necho some word\necho "a mount of its own"\nexit 75\n' >"$TREE/tests/grading/kits/kits_test.sh"
lab test all
check "a step that cannot run: not run, and why" out 'NOT RUN: a mount of its own'
check "a step that cannot run: not passed" closing 0 1
tools
mv "$WORK/bin/chromedriver" "$WORK/chromedriver"
lab test all
check "no browser: not run" out 'NOT RUN: chromedriver'
check "no browser: not passed" closing 0 "$BROWSERS"
mv "$WORK/chromedriver" "$WORK/bin/chromedriver"
rm "$WORK/bin/clang-tidy"
lab test all
check "a tool is missing: not run" out 'NOT RUN: clang-tidy'
check "a tool is missing: counted" out '1 not run'
check "a tool is missing: not passed" closing 0 1
check "a tool is missing: nothing failed" status 0
mv "$WORK/bin/wasm-ld" "$WORK/wasm-ld"
lab test all
check "one of a step's tools is missing: not run" out 'NOT RUN: wasm-ld'
check "one of a step's tools is missing: not passed" closing 0 "$((1 + WASM))"
mv "$WORK/wasm-ld" "$WORK/bin/wasm-ld"

finish
