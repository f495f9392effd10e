#!/usr/bin/env bash
# grade_test.sh ROOT BUILD: a small class through the whole grader, in the strongest box there is.
# shellcheck disable=SC2317 # functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
export FOS_LANG=en
CLASS="$WORK/a class" OUT="$WORK/the results"
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  echo "FAILED: $1"
}
grade() {
  "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$CLASS" --output "$OUT" "$@" >"$WORK/said" 2>&1
  STATUS=$?
}
hand_in() { # NAME: the solutions
  mkdir -p "$CLASS/$1" && cp "$ROOT"/solutions/*/*.cpp "$CLASS/$1"
}
change() { sed -i "$3" "$CLASS/$1/$2.cpp"; } # NAME STAGE HOW
cell() { # NAME COLUMN
  awk -F, -v name="$1" -v column="$2" 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i }
    $at["name"] == name { print $at[column] }' "$OUT/grades.csv"
}
is() { [[ $(cell "$1" "$2") == "$3" ]] || { echo "$1 $2: $(cell "$1" "$2"), not $3" && false; }; }
below() { awk -v a="$(cell "$1" "$2")" -v b="$3" 'BEGIN { exit !(a != "" && a < b) }'; }
said() { grep -qF -- "$1" "$WORK/said"; }
page() { grep -qF -- "$2" "$OUT/submissions/$1/index.html"; }

hand_in right
mkdir -p "$CLASS/stubs" && cp "$ROOT"/labs/*/*.cpp "$CLASS/stubs"
without_O='s/P = O + hit->t/P = hit->t/'
hand_in wrong && change wrong point "$without_O"
hand_in carried && change carried point "$without_O" && change carried combined "$without_O"
hand_in crash && change crash point 's/  return i;/  const Real* volatile none = nullptr; return i + *none;/'
hand_in broken && echo 'int is_no_stage' >"$CLASS/broken/ambient.cpp"
hand_in missing && rm "$CLASS/missing/directional.cpp"
hand_in 'Ελένη Παππά'

grade --seed 1 --jobs 2
check "all are graded: $(cat "$WORK/said")" test "$STATUS" == 0
check "a right one has everything" is right total 100
check "so has one with a Greek name" is 'Ελένη Παππά' total 100
check "stubs have nothing" is stubs total 0
check "one mistake costs its stage" below wrong point 30
check "and no other" is wrong combined 20
check "a mistake that is carried over is charged once" below carried point 30
check "and not again" is carried combined 20
check "a crash is no right pixel" is crash point 0
check "a crash is placed by the sanitizer" page crash point.cpp
check "what does not compile has nothing" is broken ambient 0
check "a missing file has nothing" is missing directional 0
check "the class has its page" test -s "$OUT/index.html"
check "a wrong picture is there" test -s "$OUT/submissions/wrong/point-difference.png"

# Nothing is done twice; the same seed gives the same.
cp "$OUT/grades.csv" "$WORK/first.csv"
grade --seed 1
check "nothing is graded again: $(cat "$WORK/said")" said 'graded: 0; before: 8'
check "and nothing changes" cmp -s "$OUT/grades.csv" "$WORK/first.csv"
grade
check "the seed is kept" said 'graded: 0; before: 8'
cp "$CLASS/right/point.cpp" "$CLASS/wrong/point.cpp"
grade
check "what has changed is graded" said 'graded: 1; before: 7'
check "anew" is wrong total 100
printf 'broken' >"$OUT/results/right/result.json"
grade
check "a damaged result is graded again" said 'graded: 1; before: 7'

# Killed in the middle: what is finished stays, and the rest follows.
rm -rf "$OUT"
"$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$CLASS" --output "$OUT" --seed 1 --jobs 1 &>/dev/null &
run=$!
for ((i = 0; i < 1200; i++)); do compgen -G "$OUT/results/*/result.json" >/dev/null && break; sleep 0.05; done
kill -KILL "$run"
wait "$run" 2>/dev/null
kept=$(compgen -G "$OUT/results/*/result.json" | wc -l)
check "killed: something is finished" test "$kept" -gt 0
check "killed: not all is" test "$kept" -lt 8
grade --seed 1
check "killed: the rest is graded: $(cat "$WORK/said")" said "graded: $((8 - kept)); before: $kept"
check "killed: in the end all is there" is carried combined 20
"$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$CLASS" --output "$OUT" --seed 2 --jobs 1 &>"$WORK/said" &
run=$!
for ((i = 0; i < 600; ++i)); do # until it grades: by then it has written files
  grep -q '"seed": *2\b' "$OUT/run.json" && break
  sleep 0.1
done
kill -INT "$run"
wait "$run"
check "Ctrl-C ends it, with its own status" test $? == 130
check "Ctrl-C: and says so" said 'goes on from there'

# However it looks, it is one person's.
fos_one() { "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$CLASS" --list "$@" 2>/dev/null | grep -c $'\t'; }
check "the list of the class" test "$(fos_one)" == 8
check "--one: one submission" test "$(fos_one --one)" == 1

# An instructor's marks and list of names.
printf 'id,stage,points,reason\nstubs,point,12.5,ill\n' >"$WORK/marks.csv"
printf 'name,username,email\nright,it21001,it21001@example.org\n' >"$WORK/roster.csv"
grade --seed 1 --overrides "$WORK/marks.csv" --roster "$WORK/roster.csv" --format csv,eclass
check "an override counts: $(cat "$WORK/said")" is stubs total 12.5
check "a roster names" is right username it21001
check "Open eClass has who has a name" grep -q '^it21001,100' "$OUT/eclass.csv"

# Wrong usage and input.
wrong() { # WORDS ARGUMENT…
  "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "${@:2}" >"$WORK/said" 2>&1
  check "status 2: ${*:2}" test $? == 2
  check "$1: $(cat "$WORK/said")" said "$1"
}
wrong 'one PATH' --output "$OUT"
wrong 'DIR is missing' "$CLASS"
wrong "'--nonsense'" "$CLASS" --output "$OUT" --nonsense
wrong "'pont'" "$CLASS" --output "$OUT" --stages pont
wrong "'many'" "$CLASS" --output "$OUT" --jobs many
wrong "'pdf'" "$CLASS" --output "$OUT" --format pdf
wrong 'needs a value' "$CLASS" --output
wrong 'nosuch' "$WORK/nosuch" --output "$OUT"
wrong 'choose another' "$CLASS" --output "$CLASS/new/results"
wrong 'choose another' "$CLASS" --output "$CLASS"
((FAILURES == 0)) && echo passed
exit "$((FAILURES > 0))"
