#!/usr/bin/env bash
# hostile_class_test.sh ROOT BUILD: a class with hand-ins that are meant to harm, or just named as people name
# things, through the whole grader: the honest ones among them have their marks, and nothing else is touched.
# shellcheck disable=SC2016,SC2317 # a name that must not be run; functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
export FOS_LANG=en
CLASS="$WORK/the class" OUT=$WORK/results
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $1: $(tail -n 5 "$WORK/said")"
}
right=$ROOT/solutions/lecture04/ambient.cpp
mkdir -p "$CLASS" "$WORK/below/inside"
zip() { (cd "$WORK/below/inside" && cmake -E tar cf "$CLASS/$1.zip" --format=zip -- "${@:2}"); }

# Names.
names=('Ελένη Παππά' "O'Brien \"the\" student" $'two\nlines' '🙂 emoji' ' spaces  around ' '-rf' '$(touch victim)' '=1+1')
for name in "${names[@]}"; do mkdir "$CLASS/$name" && cp "$right" "$CLASS/$name"; done
# Zips.
cp "$right" "$WORK/below/inside" && zip honest ambient.cpp
echo victim >"$WORK/below/ambient.cpp" && zip slip ../ambient.cpp
head -c 300M /dev/zero >"$WORK/below/inside/point.cpp" && zip bomb point.cpp ambient.cpp && rm "$WORK/below/inside/point.cpp"
printf 'PK\5\6\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0' >"$CLASS/empty.zip"
printf 'PK\3\4' >"$CLASS/broken.zip"
touch "$CLASS/nothing.zip"

state() { (cd "$WORK/below" && find . -maxdepth 2 -type f -exec cksum {} +) && ls -A "$WORK" "$CLASS"; }
touch "$WORK/said" "$WORK/before" && state >"$WORK/before"
# Its own most memory, as the kernel counts it.
"$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$CLASS" --output "$OUT" --seed 1 --stages ambient \
  --format html,csv,junit >"$WORK/said" 2>&1 &
run=$!
peak=0
while kill -0 "$run" 2>/dev/null; do
  kib=$(awk '/^VmHWM/ { print $2 }' "/proc/$run/status" 2>/dev/null)
  ((${kib:-0} > peak)) && peak=$kib
  sleep 0.05
done
wait "$run"
check "all are graded" test $? == 0
check "in less than 1 GiB: $peak KiB" test "$peak" -gt 0 -a "$peak" -lt 1048576
mark() { # ID
  sed -n 's/.*"points": \([0-9]*\),*$/\1/p' "$OUT/results/$1/result.json" | sort -n | tail -n 1
}
full=$(mark honest)
check "an honest one has its mark" test "${full:-0}" -gt 0
count=0
for result in "$OUT"/results/*/; do
  id=${result%/} id=${id##*/}
  case $id in
    slip | empty | broken | nothing) check "$id: no mark" test "$(mark "$id")" == 0 ;;
    *) check "$id: the mark of its right stage" test "$(mark "$id")" == "$full" ;;
  esac
  check "$id: a page" test -s "$OUT/submissions/$id/index.html"
  count=$((count + 1))
done
check "each has a result: $count" test "$count" == $((${#names[@]} + 6))
rm -rf "${OUT:?}.moved" && mv "$OUT" "$OUT.moved" && state >"$WORK/after" && sed -i '/^results.moved$/d; /^after$/d' "$WORK/after"
check "nothing outside has changed: $(diff "$WORK/before" "$WORK/after")" cmp -s "$WORK/before" "$WORK/after"
((FAILURES == 0)) && echo passed
exit "$((FAILURES > 0))"
