#!/usr/bin/env bash
# self_test.sh ROOT BUILD [OPTION…]: the red team before the grader. Each evil submission gets what its
# honest part deserves, and nothing outside the box has changed. OPTIONs are fos_grade's: --box landlock.
#
# Exit status: 0 all defended, 1 not, 3 no box.
# shellcheck disable=SC2317 # functions for `tell`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
TEAM=$ROOT/tests/grading/red_team
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT

# What a submission could reach if the box had a hole: the toolkit's files, others' files and processes.
mkdir "$WORK/class" && cp -R "$TEAM"/*/ "$WORK/class/"
printf 'nobody writes here\n' >"$WORK/canary" && chmod 666 "$WORK/canary"
state() { find "$ROOT"/{common,labs,tests} "$WORK/canary" -type f -exec cksum {} + | sort; }
state >"$WORK/before"
sleep 3600 &
bystander=$!
processes() { ps -e -o pid=,uid=,comm= | awk '$2 >= 60000 && $2 < 65534' | wc -l; } # of the box's users
before=$(processes)

"$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$WORK/class" --output "$WORK/results" \
  --stages point --seed 7 --format csv "${@:3}" || exit 3

# points NAME: percent of those that there are.
points() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i }
    $column["name"] == name { print int(100 * $column["point"] / $column["maximum"] + 0.5) }' \
    "$WORK/results/grades.csv"
}
black=$(points black) # right where there is no light, and so more than nothing
bad=0
tell() { # WHAT COMMAND…
  local what=$1
  if "${@:2}"; then
    printf 'defended      %s\n' "$what"
  else
    printf 'NOT DEFENDED  %s\n' "$what"
    bad=1
  fi
}
deserved() { # PERCENT DESERVES
  case $2 in
    full) [[ $1 == 100 ]] ;;
    nothing) [[ $1 ]] && (($1 <= black)) ;;
    at_most* | in_part*) [[ $1 ]] && (($1 <= ${2##* })) ;;
    *) false ;;
  esac
}
for folder in "$TEAM"/*/; do
  name=$(basename "$folder")
  tries=$(sed -n '1s,^// tries: ,,p' "$folder/point.cpp")
  deserves=$(sed -n '2s,^// deserves: point ,,p' "$folder/point.cpp")
  got=$(points "$name")
  tell "$name: $tries (deserves $deserves, got ${got:-no mark} %)" deserved "$got" "$deserves"
done
tell "a black picture gets next to nothing (${black:-no mark} %)" test "${black:-100}" -le 5
state >"$WORK/after"
tell 'no file outside has changed' cmp -s "$WORK/before" "$WORK/after"
tell 'no other process was ended' kill "$bystander"
tell 'no process is left' test "$(processes)" -le "$before"
exit "$bad"
