#!/usr/bin/env bash
# prove.sh SOURCE WORK COUNT COMPILE LINK…: a bug planted in a bound is found. Each line at the end is
# one: a source file (and a header of its, where the bug is there), what stands there, what is put in
# its place. The file is compiled with it (COMPILE) and linked before the libraries (LINK…), and COUNT
# random scenes must find it; without a bug they must find nothing.
source=$1 work=$2 count=$3 compile=$4
shift 4
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
  cp "$source/$file.cpp" "$work"
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
done <<'BUGS'
row_sphere|static_cast<float>(1.05 / g_least)|0
row_sphere|2 * largest_h <= sphere.c|true
row_sphere|std::floor(middle + half)|std::floor(middle + half) - 1
row_sphere|sphere.c / (2 * largest_h)|sphere.c / largest_h
float_row|hn::MulAdd(set(each.I), eN, set(each.rest))|set(each.rest)
float_row|hn::Gt(disc, E)|hn::Gt(disc, set(0))
float_row|hn::Lt(disc, hn::Neg(E))|hn::Le(disc, set(0))
float_row|hn::Mul(set(lights.sum_share), light.I)|set(0)
float_row|hn::Or(same, hn::AndNot(light.lit, good))|hn::Not(none())
float_row|nearest.unsure = hn::Or(nearest.unsure, hn::And(open, hn::Not(hn::Or(nearer, farther))));|
float_row|undecided.push_back({column + i, sphere})|undecided.push_back({column + i % 3, sphere})
double_pixel|disc.low() >= 0|true
double_pixel|const bool in_range = t.low() >= 1;|const bool in_range = true;
double_pixel|!is_less(nearest->t, candidate.t)|false
double_pixel|low != high|false
double_pixel bounded.hpp|std::abs(value) * 0x1p-52 + tiny|0
camera_scene|const double slack = 1 +|const double slack = -3 +
plan|2 * std::sin(std::asin(sine) / 2)|1e-4 * sine
BUGS

if ! c++ "$@" -o "$work/soak" || ! "$work/soak" 0 "$count" 24; then
  echo "without a bug something is found too"
  bad=1
fi
echo "$number bugs planted"
exit $bad
