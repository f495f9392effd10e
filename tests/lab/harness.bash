# What the tests of ./lab share. Sourced with the source folder as $1: makes a small tree with spaces
# in its name, whose ./lab is the real one, and a PATH that holds nothing but bash, coreutils and
# programs that only pretend (apt-get, cmake, ninja …), so that nothing of the machine is touched.
# shellcheck disable=SC2016 # what the pretenders are to expand
set -u
SOURCE=$(readlink -f -- "$1")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
TREE="$WORK/a tree"
STATE=$WORK/state # what the pretenders are to do, and what they were asked
FAILURES=0
CHECKS=0

# make_tree: a fresh tree, on a machine with every package, as root, with a network.
make_tree() {
  local stage name
  rm -rf "$TREE" "$STATE"
  make_machine
  mkdir -p "$TREE/common/text" "$TREE/cmake" "$TREE"/{labs,solutions}/lecture0{3,4} \
    "$TREE/labs/scenes" "$TREE/tests/lab" "$TREE"/tests/{explain,numerics} "$TREE/tests/common/corpus" \
    "$TREE"/tests/check/shipped/lecture0{3,4} "$STATE"
  cp "$SOURCE/lab" "$TREE/lab"
  cp "$SOURCE/common/text/lab.def" "$TREE/common/text/"
  cp "$SOURCE/cmake/packages.bash" "$TREE/cmake/"
  cp "$SOURCE/tests/lab/heavy_checks.bash" "$TREE/tests/lab/"
  cp "$SOURCE/tests/numerics/trade.bash" "$TREE/tests/numerics/"
  cp "$SOURCE/tests/check/student.bash" "$TREE/tests/check/"
  cp "$SOURCE/tests/explain/explain.bash" "$TREE/tests/explain/"
  touch "$TREE/labs/scenes/lecture.scene" "$TREE/labs/stages.json"
  for stage in lecture03/flat_color lecture04/ambient lecture04/point; do
    touch "$TREE/solutions/$stage.cpp"
    echo "the stub of $stage" | tee "$TREE/labs/$stage.cpp" >"$TREE/tests/check/shipped/$stage.cpp"
  done
  for name in g++ cmake ninja-build libglm-dev libfmt-dev tao-pegtl-dev libopenimageio-dev openimageio-tools \
    fonts-dejavu-core catch2 libmpfi-dev libgmp-dev libmpfr-dev libhwy-dev zlib1g-dev libzip-dev libmd-dev nlohmann-json3-dev gnuplot-nox clang clang-format \
    clang-tidy libclang-rt-dev shellcheck chromium chromium-driver bubblewrap libxml2-utils python3-yaml \
    slurmctld slurmd slurm-client munge; do
    touch "$STATE/installed-$name"
  done
  touch "$STATE/lists" "$STATE/network"
  echo 0 >"$STATE/uid"
}

# pretend NAME <<'…': a program of that name for ./lab. It finds STATE in its environment and notes
# in $STATE/calls how it was called.
pretend() {
  rm -f "$WORK/bin/$1" # it may be a link to the real one
  { printf '#!/bin/bash\necho "%s $*" >>"$STATE/calls"\n' "$1" && cat; } >"$WORK/bin/$1"
  chmod +x "$WORK/bin/$1"
}

# make_machine: the PATH.
make_machine() {
  local name
  rm -rf "${WORK:?}/bin"
  mkdir -p "$WORK/bin"
  for name in bash readlink mkdir rm cp mv cat tail head tee tr od stat env nproc touch iconv find; do
    ln -s "$(command -v "$name")" "$WORK/bin/$name"
  done

  pretend id <<'EOT'
cat "$STATE/uid"
EOT

  pretend dpkg-query <<'EOT'
for name in "${@:4}"; do [[ -e $STATE/installed-$name ]] && echo "installed $name"; done
EOT

  pretend apt-get <<'EOT'
case " $* " in
  *' update '*) [[ -e $STATE/network ]] && touch "$STATE/lists" ;;
  *' --assume-no '*)
    [[ -e $STATE/lists ]] || { echo "E: Unable to locate package" && exit 100; }
    echo "Need to get 1544 kB/2427 kB of archives."
    echo "After this operation, 7382 kB of additional disk space will be used."
    exit 1
    ;;
  *' install '*)
    [[ -e $STATE/network ]] || { echo "E: Failed to fetch: no network" && exit 100; }
    [[ -e $STATE/gone ]] && echo "E: Failed to fetch  404  Not Found" && exit 100
    [[ -e $STATE/old-lists ]] && rm "$STATE/old-lists" && echo "E: Failed to fetch  404  Not Found" && exit 100
    for name; do touch "$STATE/installed-$name"; done
    ;;
esac
EOT

  pretend cmake <<'EOT'
[[ $2 == tar ]] && { [[ ! -e $STATE/zip-fails ]] && cat "${@:6}" >"$4"; exit; }
[[ $1 == --version ]] && echo "cmake version $(cat "$STATE/cmake" 2>/dev/null || echo 3.25.1)" && exit
mkdir -p "$4"
[[ -e $STATE/cmake-fails ]] && echo "-- hello" && echo "CMake Error: could not find GLM" && exit 1
touch "$4/build.ninja"
printf 'A:B=C\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\nD:E=F\n' "$2" >"$4/CMakeCache.txt"
cat >"$4/stages.sh" <<'EOS'
FOS_STAGES=(flat_color ambient point)
declare -A FOS_STAGE_FILE=([flat_color]=lecture03/flat_color.cpp [ambient]=lecture04/ambient.cpp [point]=lecture04/point.cpp )
EOS
EOT

  # Makes each target; one that is named in $STATE/broken keeps its old program and fails.
  pretend ninja <<'EOT'
folder=$2 status=0
[[ -e $STATE/ninja-error ]] && echo "ninja: error: loading build.ninja" && exit 1
[[ $3 == -k ]] && shift 2
mkdir -p "$folder/bin"
for target in "${@:3}"; do
  echo "[1/9] Building $target"
  if /bin/grep -qx "$target" "$STATE/broken" 2>/dev/null; then
    printf 'FAILED: %s\n/usr/bin/g++ -o %s\n%s.cpp:3: error: no such thing\n' "$target" "$target" "$target"
    status=1
  else
    if /bin/grep -qx "$target" "$STATE/warns" 2>/dev/null; then echo "$target.cpp:3: warning: hm"; fi
    cp "$WORK_BIN/picture" "$folder/bin/$target"
  fi
done
((status)) && echo "ninja: build stopped: cannot make progress due to previous errors."
exit "$status"
EOT
  pretend picture <<'EOT'
printf '%s\n' "$@" >"$STATE/picture"
echo "${0##*/} $*" >>"$STATE/calls"
echo "$FOS_LANG" >"$STATE/language"
exit "$(cat "$STATE/picture-status" 2>/dev/null || echo 0)"
EOT

  pretend ctest <<'EOT'
echo "${FOS_LANG-none}" >"$STATE/language"
[[ ! -e $STATE/ctest-fails ]]
EOT
}

# lab ARGUMENT…: runs the ./lab of the tree in the folder $WORK, in English unless LANGUAGE (a list
# of settings for env) says otherwise; sets STATUS, OUT and ERR.
lab() {
  (cd "$WORK" && env -i PATH="$WORK/bin" HOME="$WORK" STATE="$STATE" WORK_BIN="$WORK/bin" \
    ${LANGUAGE[@]+"${LANGUAGE[@]}"} "$TREE/lab" "$@" >"$WORK/out" 2>"$WORK/err" </dev/null)
  STATUS=$?
  OUT=$(<"$WORK/out")
  ERR=$(<"$WORK/err")
}
LANGUAGE=()

# check WHAT CONDITION…: one check, the condition being a command.
check() {
  CHECKS=$((CHECKS + 1))
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  printf 'FAILED: %s (%s)\n  status %s\n  stdout: %s\n  stderr: %s\n' "$1" "${*:2}" "${STATUS-}" \
    "${OUT-}" "${ERR-}"
}
status() { [[ $STATUS == "$1" ]]; }
out() { [[ $OUT == *"$1"* ]]; }
err() { [[ $ERR == *"$1"* ]]; }
silent() { [[ -z $OUT ]]; }
one_line_of_error() { [[ -n $ERR && $ERR != *$'\n'* && -z $OUT ]]; }
called() { [[ -e $STATE/calls && $(<"$STATE/calls") == *"$1"* ]]; }
not() { ! "$@"; }
nothing_built() { [[ ! -e $TREE/build/release ]]; }

finish() {
  echo "$((CHECKS - FAILURES)) passed, $FAILURES failed"
  ((FAILURES == 0))
  exit
}
