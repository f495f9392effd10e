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
  step gcc g++ build_tree dev -DCMAKE_CXX_COMPILER=g++ -DFOS_WERROR=ON
  step clang clang++ test_tree clang -DCMAKE_CXX_COMPILER=clang++ -DFOS_WERROR=ON
  step tidy run-clang-tidy check_tidy
  step sanitize g++ test_tree sanitize -DFOS_SANITIZE=ON
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
  cd "$ROOT" && shellcheck -x lab .ci/run {cmake,common,labs,solutions,tests,docs}/**/*.{sh,bash}
}

build_tree() {
  local folder=$ROOT/build/$1
  cmake -S "$ROOT" -B "$folder" -G Ninja "${@:2}" && ninja -C "$folder" -k 0
}
test_tree() { build_tree "$@" && run_ctest "$ROOT/build/$1"; }

check_tidy() {
  run-clang-tidy -quiet -j "$(nproc)" -p "$ROOT/build/clang" '/(common|labs|solutions|tests)/.*\.cpp$'
}

# The reader of scene files against a minute of hostile ones, beginning with the committed corpus.
fuzz_scene() {
  local folder=$ROOT/build/fuzz
  cmake -S "$ROOT" -B "$folder" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DFOS_FUZZ=ON &&
    ninja -C "$folder" fuzz_scene &&
    rm -rf "$folder/corpus" && cp -R "$ROOT/tests/common/corpus" "$folder/corpus" &&
    "$folder/bin/fuzz_scene" -max_total_time=60 -print_final_stats=1 \
      -artifact_prefix="$folder/" "$folder/corpus"
}
