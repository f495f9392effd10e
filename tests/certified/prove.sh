#!/usr/bin/env bash
# prove.sh SOURCE BUGS WORK COUNT COMPILE LINK…: a bug planted in a bound is found. Each line of BUGS is
# one: a source file (and a header of its, where the bug is there), what stands there, what is put in
# its place. The file is compiled with it (COMPILE) and linked before the libraries (LINK…), and COUNT
# random scenes must find it; without a bug they must find nothing.
source=$1 bugs=$2 work=$3 count=$4 compile=$5
shift 5
mkdir -p "$work" || exit 1
bad=0 number=0

while IFS='|' read -r files was is; do
  number=$((number + 1))
  file=${files% *} changed=${files#* }
  [[ $files == *' '* ]] || changed=$file.cpp
  text=$(<"$source/$changed")
  if [[ $text != *"$was"* ]]; then
    echo "bug $number cannot be planted: $changed does not have: $was"
    bad=1
    continue
  fi
  rm -f "$work"/*.?pp
  # All headers too: one that is included by another is looked for beside it first.
  cp "$source/$file.cpp" "$source"/*.hpp "$work"
  printf '%s\n' "${text/"$was"/"$is"}" >"$work/$changed"
  # (The kernel includes itself, once for each instruction set: -I, so that it finds the copy.)
  # shellcheck disable=SC2086 # a command with its arguments
  if ! $compile -I"$work" -I"$source" -c "$work/$file.cpp" -o "$work/$file.o" >"$work/log" 2>&1 ||
    ! c++ "$work/$file.o" "$@" -o "$work/soak" >>"$work/log" 2>&1; then
    echo "bug $number does not compile: $was → $is"
    head -n 5 "$work/log"
    bad=1
  elif "$work/soak" 0 "$count" 24 >"$work/log" 2>&1; then
    echo "bug $number is not found: $was → $is"
    bad=1
  fi
done <"$bugs"

if ! c++ "$@" -o "$work/soak" || ! "$work/soak" 0 "$count" 24; then
  echo "without a bug something is found too"
  bad=1
fi
echo "$number bugs planted"
exit $bad
