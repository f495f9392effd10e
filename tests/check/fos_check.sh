#!/usr/bin/env bash
# fos_check.sh BIN: what fos_check says of right, wrong, unwritten and ending programs.
bin=$1
images=$(mktemp -d) && trap 'rm -rf "$images"' EXIT
export FOS_LANG=en LC_ALL=C.UTF-8
bad=0

# said STATUS PROGRAM PART…: of `point`, fos_check says every PART, in lines of up to 80 columns.
said() {
  local status=$1 program=$2 out one_line part line
  out=$("$bin/fos_check" --images "$images" --picture "$bin/fos_picture" "point=$program" 2>&1)
  [[ $? == "$status" ]] || wrong "status $status is missing: $program"
  one_line=$(tr -s ' \n' ' ' <<<"$out") # words may stand on two lines
  for part in "${@:3}"; do
    [[ $out$one_line == *"$part"* ]] || wrong "'$part' is missing: $program: $out"
  done
  while IFS= read -r line; do
    ((${#line} <= 80)) || [[ $line == *"$images"* ]] || wrong "over 80 columns: $line"
  done <<<"$out"
}
wrong() {
  echo "$*"
  bad=1
}

said 0 "$bin/solution_point" '✓ L parallel to N' '24 of 24 right · 30 of 30 points' 'directional.cpp'
[[ ! -e $images/point-check.png ]] || wrong 'a check that passes has made a picture'

export FOS_TERMS=ap FOS_MISTAKE=L_reversed
said 1 "$bin/variant_wrong" '✗ L parallel to N' '✓ L perpendicular to N' '6 of 24 right · 7.5 of 30' \
  'expected  (100, 50, 25)' 'came      (0, 0, 0)' './lab hint point' "./lab explain point 1 0 --scene"
[[ -s $images/point-check.png ]] || wrong 'no picture'
grep -q 'position = (0, 0, 0)' "$images/point-check.scene" || wrong 'no scene to explain'
FOS_MISTAKE=not_a_number said 1 "$bin/variant_wrong" NaN
FOS_MISTAKE=none said 0 "$bin/variant_wrong"
FOS_FORMULATION=float_throughout said 0 "$bin/variant_right" 'float precision only'

export FOS_AT=2
FOS_ENDING=null said 1 "$bin/variant_ending" 'crashed at column 0, row 1' 'points nowhere'
FOS_ENDING=division said 1 "$bin/variant_ending" 'a whole number was divided by 0'
FOS_ENDING=throw said 1 "$bin/variant_ending" 'Your program printed:' 'no idea what to do'
FOS_ENDING=loop said 1 "$bin/variant_ending" 'column 2, row 0' 'endless loop'
said 3 "$images/no-such-program" 'cannot be started'

out=$("$bin/fos_check" --images "$images" --overview "point=$bin/solution_point" \
  "directional=!log" "combined=$bin/variant_ending")
[[ $? == 1 && $out == *'1 of 5 stages · 31 of 100 points'* && $out == *'does not compile'* ]] ||
  wrong "overview: $out"
out=$("$bin/fos_check" --images "$images" --overview "point=$bin/solution_point")
[[ $? == 0 && $out == *'1 of 5 stages'* && $out != *complete* ]] ||
  wrong "a course of which stage files are missing: $out"
for arguments in 'point' 'nosuch=x' '--images' ''; do
  # shellcheck disable=SC2086 # none is an argument too
  "$bin/fos_check" $arguments &>/dev/null
  [[ $? == 2 ]] || wrong "'$arguments' is taken"
done
exit $bad
