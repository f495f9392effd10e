#!/usr/bin/env bash
# prove.sh STAGE BIN: the stage's tests pass every right program, at double and float, and fail every
# wrong one.
stage=$1 bin=$2

# shellcheck source=/dev/null
. "$bin/../stages.sh"
terms=${FOS_STAGE_TERMS[$stage]?there is no such stage}

right=(as_on_the_slides half_b geometric normalised_D normalised_D_simply factored_c stable_root fma float_throughout)
[[ $terms == *[pd]* ]] && right+=(max_with_0 normalised_L sqrt_of_squares
  N_over_r N_not_normalised lights_backwards static_lights)
[[ $terms == 1 ]] || right+=(color_per_light clamped)

# The catalogue's mistakes of this stage, if it knows the stage. A lecture-4 stage may bring its own
# closest_hit.
wrong=$("$bin/fos_mistakes" list "$stage") || exit 3
mapfile -t wrong < <(printf '%s' "$wrong")
[[ $terms == 1 ]] || wrong+=(O_forgotten b_without_2 r_not_squared without_4 tangent_misses
  divided_by_2 near_root_only far_root_only t_min_ignored t_min_behind upside_down last_sphere
  first_sphere last_of_equals black_background)
# What no student does, but a test could miss.
if [[ $terms == 1 ]]; then
  wrong+=(t_min_nearly far_is_1000 centre_behind_skipped eight_spheres whole_background)
else
  wrong+=(rounded not_a_number gamma a_percent_more)
fi
[[ $terms == *a* ]] && wrong+=(ambient_twice_alone lit_without_lights)
[[ $terms == *[pd]* ]] && wrong+=(three_lights hue_kept)
[[ $terms == *p* ]] && wrong+=(light_moved)

export FOS_TERMS=$terms FOS_STAGE=$stage
passes() { FOS_PROGRAM=$bin/$1 "$bin/stage_under_test" "[stage]" --abort &>/dev/null; }

bad=0
for suffix in '' _float; do
  for FOS_FORMULATION in "${right[@]}"; do
    export FOS_FORMULATION
    passes "variant_right$suffix" || { echo "right, but fails: $FOS_FORMULATION$suffix" && bad=1; }
  done
  for FOS_MISTAKE in "${wrong[@]}"; do
    export FOS_MISTAKE
    passes "variant_wrong$suffix" && { echo "wrong, but passes: $FOS_MISTAKE$suffix" && bad=1; }
  done
done
# Float in a double program is right, and is told so.
FOS_LANG=en FOS_FORMULATION=float_throughout FOS_PROGRAM=$bin/variant_right "$bin/stage_under_test" "[stage]" |
  grep -q 'float precision' || { echo "float_throughout passes without a note" && bad=1; }
export FOS_MISTAKE=none  # without a mistake the wrong programs are right
for program in variant_wrong variant_wrong_float; do
  passes "$program" || { echo "$program fails without a mistake too" && bad=1; }
done
echo "$stage: ${#right[@]} right and ${#wrong[@]} wrong programs, each at two precisions"
exit $bad
