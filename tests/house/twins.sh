#!/usr/bin/env bash
# twins.sh ROOT: stub and solution are the same file but for what stands between the markers, and a
# stub says in every hole what to do. A stub that someone has begun to fill in is left alone.
. "${BASH_SOURCE[0]%/*}/stub.bash"
cd "$1" || exit 1
broken=0
wrong() {
  echo "$*"
  broken=1
}

found=0
for stub in labs/lecture*/*.cpp; do
  solution=solutions/${stub#labs/}
  found=$((found + 1))
  if ! untouched "$stub"; then
    echo "written: $stub"
    continue
  fi
  starts=$(grep -c -- '--- your code starts here ---' "$stub")
  ends=$(grep -c -- '--- your code ends here ---' "$stub")
  todos=$(grep -c 'TODO: ' "$stub")
  unwritten=$(hole_code "$stub" | grep -c .)
  ((starts > 0)) || wrong "$stub: no hole to fill in"
  ((starts == ends && starts == todos && starts == unwritten)) ||
    wrong "$stub: $starts starts, $ends ends, $todos TODOs and $unwritten unwritten() do not match"
  [[ -e $solution ]] || { wrong "$solution is missing" && continue; }
  diff <(without_holes "$stub") <(without_holes "$solution") ||
    wrong "$stub and $solution differ outside their holes"
  hole_code "$solution" | grep -q unwritten && wrong "$solution has a hole that is not filled"
  lines=$(wc -l <"$solution")
  ((lines <= 60)) || wrong "$solution has $lines lines: a stage fits on one screen"
done
((found > 0)) || wrong "no stubs in $PWD"
exit $broken
