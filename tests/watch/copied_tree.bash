# What the tests of watch share: a copy of the tree's labs and of as much of a build folder as a stage
# needs, so that nothing is written into the real ones. Sourced with ROOT and BUILD as $1 and $2.
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
TREE="$WORK/a tree"
COPY=$WORK/build
FAILURES=0

# make_tree STAGE…: the labs as they were shipped, and a build folder that makes these stages' programs
# of them, by the commands of the real one. ./lab there says what it is asked.
make_tree() {
  local stage file object commands compile link
  rm -rf "$TREE" "$COPY"
  mkdir -p "$TREE" "$COPY/bin"
  cp -R "$ROOT/labs" "$TREE/labs"
  ln -s "$BUILD/bin/fos_picture" "$COPY/bin/fos_picture"
  cat >"$TREE/lab" <<'EOT'
#!/bin/bash
echo "child: $*"
[[ $1 != hint ]] || stty -a | grep -o -e '-\?icanon'
EOT
  chmod +x "$TREE/lab"
  # shellcheck disable=SC2016 # ninja's variable
  printf 'rule run\n  command = cd %s && $cmd\n' "$BUILD" >"$COPY/build.ninja"
  for stage; do
    file=$(cd "$ROOT" && echo labs/lecture*/"$stage.cpp")
    object=CMakeFiles/lab_$stage.dir/$file.o
    commands=$(ninja -C "$BUILD" -t commands "lab_$stage")
    compile=$(grep -F -- "-o $object -c" <<<"$commands") link=$(tail -n 1 <<<"$commands")
    compile=${compile//"$ROOT/$file"/"'$TREE/$file'"}
    compile=${compile//"$object"/"$COPY/$object"}
    link=${link//"$object"/"$COPY/$object"} link=${link/"-o bin/"/"-o $COPY/bin/"}
    printf 'build %s: run %s\n  cmd = %s\nbuild bin/lab_%s: run %s\n  cmd = %s\nbuild lab_%s: phony bin/lab_%s\n' \
      "$object" "${TREE// /\$ }/$file" "${compile//\$/\$\$}" "$stage" "$object" "${link//\$/\$\$}" "$stage" "$stage" \
      >>"$COPY/build.ninja"
  done
}

# write_stub, write_solution STAGE: the stage's file in the copy.
put() { # FOLDER STAGE: as editors do, by another file that takes its place
  local file
  file=$(cd "$ROOT/$1" && echo lecture*/"$2.cpp")
  cp "$ROOT/$1/$file" "$TREE/labs/$file.new" && mv "$TREE/labs/$file.new" "$TREE/labs/$file"
}

check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $1"
}

# wait_for WORDS [SECONDS]: until they stand in $WORK/screen.
wait_for() {
  local i
  for ((i = 0; i < ${2:-40} * 20; i++)); do
    grep -qF -- "$1" "$WORK/screen" 2>/dev/null && return
    sleep 0.05
  done
  echo "never came: $1"
  tail -n 60 "$WORK/screen"
  return 1
}

finish() {
  ((FAILURES == 0)) && echo passed
  exit "$((FAILURES > 0))"
}
