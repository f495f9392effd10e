#!/usr/bin/env bash
# merge_test.sh ROOT BUILD: a class that is graded in parts, and merged, is as if it had been graded at once.
# shellcheck disable=SC2317 # functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
export FOS_LANG=en
CLASS="$WORK/a class"
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $1: $(cat "$WORK/said")"
}
fos_grade() {
  "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$@" >"$WORK/said" 2>&1
  STATUS=$?
}
grade() { fos_grade "$CLASS" --stages ambient --seed 5 --format html,csv,junit "$@"; }
merge() { fos_grade --format html,csv,junit --merge "$@"; }
status() { [[ $STATUS == "$1" ]]; }
said() { grep -qF -- "$1" "$WORK/said"; }
not() { ! "$@"; }
# without_time FOLDER: its files, but for the date and the processor time in them.
without_time() {
  cp -R "$1" "$1.plain" && rm "$1.plain/journal.lock"
  find "$1.plain" -type f ! -name '*.png' -exec sed -i -E \
    -e 's/"date": "[^"]*"/"date": ""/; s/"cpu_seconds": [^,]*/"cpu_seconds": 0/; s/"sum":"[^"]*"/"sum":""/' \
    -e 's/ (time|timestamp)="[^"]*"//g; s/20[0-9]{2}-[0-9]{2}-[0-9]{2} [0-9]{2}:[0-9]{2}(:[0-9]{2})?//g' {} +
}
same() {
  rm -rf "$WORK"/*.plain && without_time "$1" && without_time "$2" && diff -r "$1.plain" "$2.plain"
}

for name in right wrong 'Ελένη Παππά' stub missing; do mkdir -p "$CLASS/$name"; done
cp "$ROOT/solutions/lecture04/ambient.cpp" "$CLASS/right"
cp "$ROOT/solutions/lecture04/ambient.cpp" "$CLASS/Ελένη Παππά"
cp "$ROOT/labs/lecture04/ambient.cpp" "$CLASS/stub"
cp "$ROOT/tests/misconceptions/submissions/ambient/half.cpp" "$CLASS/wrong/ambient.cpp"
cp "$ROOT/solutions/lecture04/point.cpp" "$CLASS/missing"

fos_grade "$CLASS" --list
check "the list" status 0
check "the list: a line each" test "$(grep -c $'\t' "$WORK/said")" == 5
grade --output "$WORK/whole" && check "the whole" status 0
grade --output "$WORK/1" --part 1/2 && check "a part" status 0
check "a part has its share only" said 'graded: 3; before: 0'
merge "$WORK/1" --output "$WORK/merged"
check "a part is missing" status 2
check "and named" said 'part 2/2 is missing'
check "then nothing is written" not test -e "$WORK/merged"
grade --output "$WORK/2" --part 2/2 && check "the other" status 0
merge "$WORK/2" "$WORK/1" --output "$WORK/merged"
check "merged" status 0
check "merged: all of them" said 'merged: 5, from 2 parts'
check "merged: what one run gives" same "$WORK/whole" "$WORK/merged"
check "merged: pictures too" compgen -G "$WORK/merged/submissions/wrong*/ambient-difference.png" >/dev/null
merge "$WORK/1" "$WORK/2" --output "$WORK/merged"
check "merged again" same "$WORK/whole" "$WORK/merged"
grade --output "$WORK/merged"
check "and a run over it has nothing to do" said 'graded: 0; before: 5'
sed -i '$s/$/ /' "$WORK/merged/grades.csv"
differs() { ! same "$@" >/dev/null; }
check "this test would see another mark" differs "$WORK/whole" "$WORK/merged"

# What is no whole class is not merged.
refused() { # WORDS
  check "status 2" status 2
  check "$1" said "$1"
}
merge "$WORK/1" "$WORK/1" --output "$WORK/bad" && refused 'are the same part, 1/2'
merge "$WORK/whole" "$WORK/1" --output "$WORK/bad" && refused 'not of the same run'
merge "$WORK" --output "$WORK/bad" && refused 'no results of a part'
merge --output "$WORK/bad" && refused '--merge needs'
merge "$WORK/1" && refused 'DIR is missing'
cp -R "$WORK/2" "$WORK/killed" && sed -i '/"finished"/,/\]/c"finished": null' "$WORK/killed/run.json"
merge "$WORK/1" "$WORK/killed" --output "$WORK/bad" && refused 'is not finished'
cp -R "$WORK/2" "$WORK/damaged" && echo x | tee "$WORK"/damaged/results/*/result.json >/dev/null
merge "$WORK/1" "$WORK/damaged" --output "$WORK/bad" && refused 'is not finished'
for part in 0/2 3/2 2 a/b 1/; do grade --output "$WORK/bad" --part "$part" && check "--part $part" status 2; done
((FAILURES == 0)) && echo passed
exit "$((FAILURES > 0))"
