# What `./lab test all` adds to the project's own tests: the checks that need heavy tools or minutes.
# Sourced by ./lab. Each is a step that passes, fails or is NOT RUN; its words are in build/logs.

heavy_checks() {
  PASSED=0 FAILED=0 NOT_RUN=0
  LOGS=$ROOT/build/logs
  mkdir -p "$LOGS" || exit 3
  shopt -s globstar nullglob

  step tests ctest own_tests
  step format clang-format check_format
  step shell shellcheck check_shell
  step clang clang++ test_tree clang -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DFOS_WERROR=ON
  step tidy clang-tidy check_tidy
  step sanitize g++ test_tree sanitize --preset sanitize
  step random ctest random_scenes
  step browser chromedriver browser_page
  step report chromedriver report_pages
  step fuzz clang++ fuzz_scene
  ((NOT_RUN)) && say lab_steps_not_run "$NOT_RUN"
  say lab_steps_sum "$PASSED" "$FAILED"
  ((FAILED == 0))
}

# step NAME TOOL FUNCTION [ARGUMENT…]: runs the function, which needs the tool.
step() {
  local name=$1 tool=$2 began=$SECONDS log=$LOGS/$1.log
  printf '%s … ' "$(say "lab_step_$name")"
  if ! command -v "$tool" >/dev/null; then
    NOT_RUN=$((NOT_RUN + 1))
    say lab_step_not_run "$tool"
  elif ("${@:3}") >"$log" 2>&1 </dev/null; then
    PASSED=$((PASSED + 1))
    say lab_step_passed "$((SECONDS - began))"
  else
    FAILED=$((FAILED + 1))
    say lab_step_failed "$((SECONDS - began))" "$log"
    tail -n 40 "$log"
  fi
}

check_format() {
  clang-format --dry-run -Werror "$ROOT"/{common,labs,solutions,tests}/**/*.{cpp,hpp}
}

check_shell() {
  cd "$ROOT" &&
    shellcheck -x -P SCRIPTDIR:. lab .ci/run {cmake,common,labs,solutions,tests,docs}/**/*.{sh,bash}
}

# build_tree NAME ARGUMENT…: everything, in build/NAME, as CMake is told by the arguments.
build_tree() { cmake -S "$ROOT" -B "$ROOT/build/$1" "${@:2}" && build "$ROOT/build/$1" all; }
# Its tests, without those of bash, the proofs, which start a thousand programs, and what asks stages
# that crash: under a sanitizer they end in another way.
test_tree() {
  build_tree "$@" && run_ctest "$ROOT/build/$1" \
    -E '^((command|proof|watch)_.*|check|fos_check|explain|submissions|mistake_variants|broken.*)$'
}

# Random scenes by the hundred against the exact tracer, and the proof that they find planted bugs.
random_scenes() { build "$BUILD" all && run_ctest "$BUILD" -C Heavy -R '_(soak|proof)$'; }

# Each file once, as its first target compiles it: most are compiled at three precisions.
check_tidy() {
  local folder=$ROOT/build/tidy
  mkdir -p "$folder" && python3 -c '
import json, sys
entries = {}
for entry in json.load(open(sys.argv[1])):
    entries.setdefault(entry["file"], entry)
ours = [entry for file, entry in entries.items() if "/build/" not in file]
json.dump(ours, open(sys.argv[2], "w"))
print(*(entry["file"] for entry in ours), sep="\0", end="\0")
' "$ROOT/build/clang/compile_commands.json" "$folder/compile_commands.json" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy -quiet -p "$folder" 2> >(grep -v ' warnings generated')
}

# The page of ./lab watch in a real browser.
browser_page() { build "$BUILD" all && "$ROOT/tests/watch/viewer_test.sh" "$ROOT" "$BUILD"; }

# The reports of ./lab grade in one.
report_pages() { build "$BUILD" all && "$ROOT/tests/grading/report/report_test.sh" "$ROOT" "$BUILD"; }

# The reader of scene files against a minute of hostile ones, beginning with the committed corpus.
fuzz_scene() {
  local folder=$ROOT/build/fuzz
  cmake -S "$ROOT" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DFOS_FUZZ=ON &&
    build "$folder" fuzz_scene &&
    rm -rf "$folder/corpus" && cp -R "$ROOT/tests/common/corpus" "$folder/corpus" &&
    "$folder/bin/fuzz_scene" -max_total_time=60 -print_final_stats=1 \
      -artifact_prefix="$folder/" "$folder/corpus"
}
