#!/usr/bin/env bash
# full_disk_test.sh ROOT BUILD: the disk fills up in mid-run. The run ends and says so, what is finished is
# kept, and with room again the same command goes on. Exit status 77: not run, for no disk can be mounted.
# shellcheck disable=SC2317 # functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
if [[ ${3-} != inside ]]; then # a small disk that is gone with this process
  if [[ $(id -u) != 0 ]] || ! unshare -m true 2>/dev/null; then
    echo 'NOT RUN: no disk can be mounted here'
    exit 77
  fi
  exec unshare -m "$0" "$ROOT" "$BUILD" inside
fi
WORK=$(mktemp -d)
OUT=$WORK/disk/results
trap 'umount "$WORK/disk"; rm -rf "$WORK"' EXIT
export FOS_LANG=en
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $1: $(cat "$WORK/said")"
}
grade() { # FOLDER
  "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$WORK/class" --output "$1" --seed 1 --stages ambient \
    --jobs 1 >"$WORK/said" 2>&1
  STATUS=$?
}
status() { [[ $STATUS == "$1" ]]; }
said() { grep -qF -- "$1" "$WORK/said"; }

for i in {0..9}; do
  mkdir -p "$WORK/class/$i"
  { cat "$ROOT/tests/misconceptions/submissions/ambient/half.cpp" && echo "// $i"; } >"$WORK/class/$i/ambient.cpp"
done
grade "$WORK/elsewhere"
check "all are graded" status 0
need=$(du -sk "$WORK/elsewhere" | cut -f1)
mkdir "$WORK/disk" && mount -t tmpfs -o "size=$((need / 2))k" tmpfs "$WORK/disk" || exit 3
grade "$OUT"
check "a full disk is trouble of ours" status 3
check "and is named" said 'No space left on device'
kept=$(compgen -G "$OUT/results/*/result.json" | wc -l)
check "some are finished" test "$kept" -gt 0 -a "$kept" -lt 10
check "nothing is half there" test -z "$(find "$OUT/results" -name '*.json' -size 0)"
mount -o "remount,size=$((need * 4))k" "$WORK/disk"
grade "$OUT"
check "with room again, all is well" status 0
check "what was finished has been kept" said "graded: $((10 - kept)); before: $kept"
check "the marks are those of any other run" cmp "$OUT/grades.csv" "$WORK/elsewhere/grades.csv"
check "and there is the picture of each" test "$(compgen -G "$OUT/submissions/*/ambient-yours.png" | wc -l)" == 10
((FAILURES == 0)) && echo passed
exit "$((FAILURES > 0))"
