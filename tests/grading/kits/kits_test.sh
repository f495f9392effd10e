#!/usr/bin/env bash
# kits_test.sh ROOT BUILD: the kits for Gradescope and for GitHub Actions, by what these do with them: the
# folders of the one are made again, the steps of the other are run. The grader in BUILD stands for one
# built from the kit; that the kit has all that it is built from is asked of CMake and Ninja.
# Exit status 75: not run, and the last line says what was missing.
# shellcheck disable=SC2016,SC2317 # scripts for other shells; functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
if [[ ${3-} != inside ]]; then
  # /autograder is Gradescope's own place, so it is made where nobody else sees it.
  unshare -m true 2>/dev/null && exec unshare -m "$0" "$ROOT" "$BUILD" inside
  [[ $(id -u) != 0 || -e /autograder ]] && echo 'unshare -m' && exit 75
fi
WORK=$(mktemp -d)
export FOS_LANG=en
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  printf 'FAILED: %s\n' "$1"
}
if [[ ${3-} == inside ]]; then
  own=$([[ -e /autograder ]] || echo yes)
  mkdir -p /autograder && mount -t tmpfs tmpfs /autograder || exit 3
  trap 'rm -rf "$WORK"; umount /autograder; [[ ! $own ]] || rmdir /autograder' EXIT
else
  mkdir /autograder || exit 3
  trap 'rm -rf "$WORK" /autograder' EXIT
fi

# kit KIND: in $WORK/KIND, unpacked.
kit() {
  "$ROOT/lab" kit "$1" --seed 7 --output "$WORK/$1.zip" >/dev/null || exit 3
  mkdir "$WORK/$1" && (cd "$WORK/$1" && cmake -E tar xf "../$1.zip") || exit 3
}
# can_be_built TREE: CMake takes it, and no file is missing for what grading builds.
can_be_built() {
  rm -rf "$WORK/configured"
  if ! { cmake -S "$1" -B "$WORK/configured" -G Ninja -DFOS_TESTS=ON &&
    ninja -C "$WORK/configured" -n fos_grade fos_picture; } >"$WORK/said" 2>&1; then
    tail "$WORK/said"
    return 1
  fi
}
hand_in() { # FOLDER KIND
  rm -rf "$1" && mkdir -p "$1"
  case $2 in
    right) cp "$ROOT"/solutions/*/*.cpp "$1" ;;
    partial) cp "$ROOT"/solutions/lecture03/*.cpp "$1" && mkdir "$1/more" && cp "$ROOT"/labs/lecture04/*.cpp "$1/more" ;;
    folders) mkdir "$1"/{a,b} && cp "$ROOT"/solutions/*/*.cpp "$1/a" && cp "$ROOT"/solutions/lecture03/*.cpp "$1/b" ;;
  esac
}
json() { python3 -c 'import json, sys; d = json.load(open(sys.argv[1])); print(eval(sys.argv[2]))' "$@"; }
is() { [[ $(json "$1" "$2") == "$3" ]] || { echo "$2: $(json "$1" "$2"), not $3" && false; }; }

kit gradescope
check "Gradescope: can be built" can_be_built "$WORK/gradescope/fos"
mkdir -p /autograder/{source,submission,results}
cp "$WORK/gradescope"/{setup.sh,run_autograder} /autograder/source && cp /autograder/source/run_autograder /autograder
check "Gradescope: both can be run" test -x /autograder/run_autograder -a -x "$WORK/gradescope/setup.sh"
mkdir /autograder/source/fos # ./lab finds its tree by its own real place
cp "$WORK/gradescope/fos/kit-settings.bash" /autograder/source/fos
ln -s "$ROOT/lab" /autograder/source/fos/lab && ln -s "$ROOT/labs" /autograder/source/fos/labs
check "Gradescope: setup.sh" bash -c '/autograder/source/setup.sh &>"$1/said" || { cat "$1/said" && false; }' _ "$WORK"
autograde() { # KIND
  hand_in /autograder/submission "$1"
  rm -f /autograder/results/results.json
  (cd /autograder && ./run_autograder >"$WORK/said" 2>&1)
  check "Gradescope, $1: ends well" test $? == 0
  RESULT=/autograder/results/results.json
  check "Gradescope, $1: the results are there" test -s "$RESULT"
  check "Gradescope, $1: their form" python3 "$ROOT/tests/grading/kits/gradescope_schema.py" "$RESULT"
}
autograde right
check "right: everything" is "$RESULT" 'd["score"]' 100
check "right: five tests, all passed" is "$RESULT" '[t["status"] for t in d["tests"]] == 5 * ["passed"]' True
cp "$RESULT" "$WORK/first.json"
autograde right
check "the same again" cmp "$RESULT" "$WORK/first.json"
autograde partial
check "partial: its stage" is "$RESULT" '[t["status"] for t in d["tests"]]' "['passed', 'failed', 'failed', 'failed', 'failed']"
autograde empty
check "empty: nothing" is "$RESULT" 'd["score"]' 0
autograde folders
check "two folders are still one submission" is "$RESULT" 'd["score"]' 100
mv /autograder/source/fos/kit-settings.bash "$WORK" # trouble of ours
(cd /autograder && rm -f results/results.json && ./run_autograder &>/dev/null)
check "our own trouble is no result" test $? != 0 -a ! -e /autograder/results/results.json

kit actions
check "Actions: can be built" can_be_built "$WORK/actions/.github/fos"
right_in() { find "$1" -name '*.cpp' -path "$2" -size +300c -print -quit | grep -q .; }
check "this test would see a right stage" right_in "$ROOT" '*/misconceptions/submissions/*'
not() { ! "$@"; }
check "Actions: no right stage" not right_in "$WORK/actions" '*/misconceptions/submissions/*'
check "Actions: no solutions" test ! -e "$WORK/actions/.github/fos/solutions"
# The commands of the workflow's steps, one file each; one job, and no expression in what a shell runs.
check "Actions: the workflow" python3 - "$WORK" <<'EOT'
import pathlib, sys, yaml
work = pathlib.Path(sys.argv[1])
jobs = yaml.safe_load((work / "actions/.github/workflows/fos.yml").read_text())["jobs"]
assert len(jobs) == 1
steps = [step["run"] for job in jobs.values() for step in job["steps"] if "run" in step]
assert len(steps) == 2 and not any("${{" in step for step in steps), steps
for number, step in enumerate(steps):
    (work / f"step{number}.sh").write_text(step)
EOT
# act KIND: a checkout of a student's repository with the kit laid over it, and its job.
act() {
  local repository=$WORK/repository
  rm -rf "$repository" && mkdir "$repository" && hand_in "$repository/labs/lecture04" "$1"
  mkdir -p "$repository/.github/fos" && cp -R "$WORK/actions/.github/workflows" "$repository/.github"
  ln -s "$ROOT"/{lab,labs,tests} "$WORK/actions/.github/fos/kit-settings.bash" "$repository/.github/fos"
  : >"$WORK/output" && : >"$WORK/summary"
  for step in "$WORK"/step?.sh; do
    (cd "$repository" && env GITHUB_OUTPUT="$WORK/output" GITHUB_STEP_SUMMARY="$WORK/summary" \
      RUNNER_TEMP="$WORK" bash --noprofile --norc -eo pipefail "$step" >"$WORK/said" 2>&1) || return
  done
}
act right || { tail -n 3 "$WORK/said" && check "Actions, right: passes" false; }
sed -n 's/^result=//p' "$WORK/output" | base64 -d >"$WORK/result.json"
check "Actions, right: the output" is "$WORK/result.json" 'd["status"], sum(t["score"] for t in d["tests"])' "('pass', 100)"
check "Actions, right: the summary" grep -q '100' "$WORK/summary"
act partial
check "Actions, partial: fails" test $? == 1
check "Actions, partial: and has its points all the same" grep -q '^result=.' "$WORK/output"
((FAILURES == 0)) && echo passed
exit "$((FAILURES > 0))"
