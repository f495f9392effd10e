# What `./lab test all` adds to the project's own tests: the checks that need heavy tools or minutes.
# Sourced by ./lab. Each is a step that passes, fails or is NOT RUN; its words are in build/logs.

heavy_checks() {
  PASSED=0 FAILED=0 NOT_RUN=0
  LOGS=$ROOT/build/logs BUILD_CLANG=$ROOT/build/clang
  mkdir -p "$LOGS" || exit 3
  shopt -s globstar nullglob

  step tests ctest tests_once
  step format clang-format check_format
  step shell shellcheck check_shell
  step spelling hunspell check_spelling
  step clang clang++ clang_tree
  step tidy clang-tidy check_tidy
  step random ctest random_scenes
  step browser chromedriver browser_page
  step report chromedriver report_pages
  step figures 'chromedriver wasm-ld' live_figures
  step red_team bwrap red_team
  step site 'chromedriver mkdocs wasm-ld' site_pages
  step student_kit cmake student_kit
  step adding_a_stage cmake adding_a_stage
  step kits python3 platform_kits
  step slurm slurmctld slurm_kit
  step fuzz clang++ fuzz_scene
  ((NOT_RUN)) && say lab_steps_not_run "$NOT_RUN"
  say lab_steps_sum "$PASSED" "$FAILED"
  ((FAILED == 0))
}

# step NAME TOOLS FUNCTION [ARGUMENT…]: runs the function, which needs the tools; status 75 says that it
# needs more than these, and its last line what.
step() {
  local name=$1 began=$SECONDS log=$LOGS/$1.log tool missing=''
  for tool in $2; do command -v "$tool" >/dev/null || missing+=" $tool"; done
  printf '%s … ' "$(say "lab_step_$name")"
  if [[ $missing ]]; then
    NOT_RUN=$((NOT_RUN + 1))
    say lab_step_not_run "${missing# }"
  elif ("${@:3}") >"$log" 2>&1 </dev/null; then
    PASSED=$((PASSED + 1))
    say lab_step_passed "$((SECONDS - began))"
  elif (($? == 75)); then
    NOT_RUN=$((NOT_RUN + 1))
    say lab_step_not_run "$(tail -n 1 "$log")"
  else
    FAILED=$((FAILED + 1))
    say lab_step_failed "$((SECONDS - began))" "$log"
    tail -n 40 "$log"
  fi
}

# The project's own tests, unless they have passed and nothing has changed since they began.
tests_once() {
  local newer
  if newer=$(find "$ROOT" -path "$ROOT/build" -prune -o -path "$ROOT/.git" -prune \
    -o -newer "$PASSED_TESTS" -print -quit) && [[ ! $newer ]]; then
    echo 'passed before, and nothing has changed since'
  else
    own_tests
  fi
}

check_format() {
  clang-format --dry-run -Werror "$ROOT"/{common,labs,solutions,tests,docs}/**/*.{cpp,hpp}
}

check_shell() {
  cd "$ROOT" &&
    shellcheck -x -P SCRIPTDIR:. lab .ci/run {cmake,common,labs,solutions,tests,docs}/**/*.{sh,bash}
}

# The words of the pages and of the programs, and that a wrong one is found.
check_spelling() {
  "$ROOT/tests/house/spelling_catches.sh" && "$ROOT/tests/house/spelling.sh" "$ROOT"
}

# Everything by the other compiler, with its sanitizers, and its tests: without those of bash, the
# proofs, which start a thousand programs, and what asks stages that crash, for under a sanitizer they
# end in another way.
clang_tree() {
  cmake -S "$ROOT" -B "$BUILD_CLANG" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DFOS_WERROR=ON \
    -DFOS_SANITIZE=ON -DCMAKE_BUILD_TYPE=None \
    -DCMAKE_CXX_FLAGS='-O1 -gline-tables-only -Wreserved-identifier' &&
    build "$BUILD_CLANG" all &&
    run_ctest "$BUILD_CLANG" \
      -E '^((box|command|proof|watch)_.*|check|grade(_merge|_hostile|_full_disk)?|fos_check|explain|submissions|misconceptions|mistake.*|broken.*)$'
}

# Random scenes by the hundred against the exact tracer, and the proof that they find planted bugs.
random_scenes() { build "$BUILD" all && run_ctest "$BUILD" -C Heavy -R '_(soak|proof)$'; }

check_tidy() { "$ROOT/tests/lab/tidy.py" "$BUILD_CLANG/compile_commands.json" "$ROOT/build/tidy"; }

# The page of ./lab watch in a real browser.
browser_page() { build "$BUILD" all && "$ROOT/tests/watch/viewer_test.sh" "$ROOT" "$BUILD"; }

# The reports of ./lab grade in one.
report_pages() { build "$BUILD" all && "$ROOT/tests/grading/report/report_test.sh" "$ROOT" "$BUILD"; }

# The site of ./lab docs in one.
site_pages() {
  # shellcheck source=docs/site/docs.bash
  source "$ROOT/docs/site/docs.bash"
  # shellcheck disable=SC2119 # the words of ./lab are not for it
  docs && "$ROOT/tests/site/site_test.sh" "$ROOT"
}

# The figures of the docs: what they show is what native programs show.
live_figures() {
  build "$BUILD" figures figure_frames fos_picture solution_combined &&
    "$ROOT/tests/figures/figures_test.sh" "$ROOT" "$BUILD"
}

# The evil submissions before the whole grader.
red_team() { build "$BUILD" all && "$ROOT/tests/grading/self_test.sh" "$ROOT" "$BUILD"; }

# A kit in the hands of a student, from the zip to the mark.
student_kit() { build "$BUILD" all && "$ROOT/tests/kits/kit_test.sh" "$ROOT" "$BUILD"; }

# The page that says how a stage is added, followed to the letter.
adding_a_stage() { build "$BUILD" all && "$ROOT/tests/kits/adding_a_stage.sh" "$ROOT" "$BUILD"; }
# The kits, by what Gradescope, GitHub Actions and a Slurm of this machine alone do with them.
platform_kits() { build "$BUILD" all && "$ROOT/tests/grading/kits/kits_test.sh" "$ROOT" "$BUILD"; }
slurm_kit() { build "$BUILD" all && "$ROOT/tests/grading/kits/slurm_test.sh" "$ROOT" "$BUILD"; }

# The reader of scene files against a minute of hostile ones, beginning with the committed corpus.
fuzz_scene() {
  local folder=$ROOT/build/fuzz
  cmake -S "$ROOT" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DFOS_FUZZ=ON &&
    build "$folder" fuzz_scene &&
    rm -rf "$folder/corpus" && cp -R "$ROOT/tests/common/corpus" "$folder/corpus" &&
    "$folder/bin/fuzz_scene" -max_total_time=60 -print_final_stats=1 \
      -artifact_prefix="$folder/" "$folder/corpus"
}
