# `./lab trade`: speed against accuracy, measured by fos_trade. Sourced by ./lab, whose words, options
# and build it uses.

# trade [STAGE]: builds the program, and the student's stage at every precision, and hands over.
trade() {
  local scene=$ROOT/labs/scenes/lecture.scene options=() stages=() plot='' targets=(fos_trade) others=()
  while (($#)); do
    TOOK=1
    case $1 in
      --scene | --scene=*) take "$@" && check_scene "$VALUE" && scene=$VALUE ;;
      --csv | --csv=*) take "$@" && check_csv "$VALUE" && options+=(--csv "$VALUE") ;;
      --plot | --plot=*) take "$@" && check_plot "$VALUE" && plot=plot options+=(--plot "$VALUE") ;;
      -*) require lab_unknown_option "$1" --scene --csv --plot --lang ;;
      *) stages+=("$1") ;;
    esac
    shift "$TOOK"
  done
  know_stages "${stages[@]}"
  ((${#stages[@]} <= 1)) || fail 2 lab_trade_one_stage

  command -v gnuplot >/dev/null && plot=''
  set_up build test ${plot:+plot}
  [[ -z $plot ]] || command -v gnuplot >/dev/null || give_up lab_no_gnuplot
  is_configured_with_tests || configure -DFOS_TESTS=ON
  know_stages "${stages[@]}"
  if ((${#stages[@]})); then
    # shellcheck source=/dev/null
    source "$BUILD/stages.sh"
    [[ -e $ROOT/labs/${FOS_STAGE_FILE[${stages[0]}]} ]] ||
      fail 1 lab_no_stage_file "labs/${FOS_STAGE_FILE[${stages[0]}]}"
    targets+=(empty_stage empty_stage_float empty_stage_extended "lab_${stages[0]}")
    others=("lab_${stages[0]}_float" "lab_${stages[0]}_extended")
    options+=(--stage "${stages[0]}" --programs "$BUILD/bin")
  fi
  build "$BUILD" "${targets[@]}" || say_what_failed "${targets[@]}"
  if ((${#others[@]})); then # only now: a mistake is told once, not at every precision
    build "$BUILD" "${others[@]}" || say_what_failed "${others[@]}"
  fi
  "$BUILD/bin/fos_trade" --scene "$scene" "${options[@]}"
}

check_csv() {
  case ${1,,} in *[^/].csv) check_place "$1" ;; *) fail 2 lab_bad_csv "$1" ;; esac
}
check_plot() {
  case ${1,,} in *[^/].png | *[^/].svg) check_place "$1" ;; *) fail 2 lab_bad_plot "$1" ;; esac
}

is_configured_with_tests() {
  is_configured && [[ $(<"$BUILD/CMakeCache.txt") == *$'\n'FOS_TESTS:BOOL=ON$'\n'* ]]
}

# say_what_failed TARGET…: whether the student's stage does not build, or something of ours.
say_what_failed() {
  local target
  for target; do
    [[ $target == lab_* ]] || is_built "$target" || fail 3 lab_no_trade_program
  done
  for target; do is_built "$target" || fail 1 lab_stage_does_not_build "${target#lab_}"; done
  fail 3 lab_no_trade_program # ninja itself
}
