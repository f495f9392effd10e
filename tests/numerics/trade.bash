# `./lab trade`: speed against accuracy, measured by fos_trade. Sourced by ./lab, whose words, options
# and build it uses.

# trade [STAGE]: the ladder; --plan, --growth and --extremes [FAMILY…] are studies of their own.
trade() {
  local mode=ladder scene='' csv='' plot='' words=() options=()
  while (($#)); do
    TOOK=1
    case $1 in
      --scene | --scene=*) take "$@" && check_scene "$VALUE" && scene=$VALUE ;;
      --csv | --csv=*) take "$@" && check_csv "$VALUE" && csv=$VALUE ;;
      --plot | --plot=*) take "$@" && check_plot "$VALUE" && plot=$VALUE ;;
      --plan | --growth | --extremes)
        [[ $mode == ladder || $mode == "${1#--}" ]] || fail 2 lab_trade_one_study "--$mode" "$1"
        mode=${1#--}
        ;;
      -*) require lab_unknown_option "$1" --scene --csv --plot --plan --growth --extremes --lang ;;
      *) words+=("$1") ;;
    esac
    shift "$TOOK"
  done
  case $mode in
    plan) only_with --plan "${csv:+--csv}" "${plot:+--plot}" "${words[@]}" ;;
    growth) only_with --growth "${scene:+--scene}" "${words[@]}" ;;
    extremes)
      only_with --extremes "${scene:+--scene}" "${plot:+--plot}"
      [[ -d $ROOT/solutions ]] || fail 2 lab_no_solutions
      ;;
    ladder)
      know_stages "${words[@]}"
      ((${#words[@]} <= 1)) || fail 2 lab_trade_one_stage
      ;;
  esac
  [[ $mode == plan || $mode == ladder ]] && options+=(--scene "${scene:-$ROOT/labs/scenes/lecture.scene}")
  options+=(${csv:+--csv "$csv"} ${plot:+--plot "$plot"})

  command -v gnuplot >/dev/null && plot=''
  set_up build test ${plot:+plot}
  [[ -z $plot ]] || command -v gnuplot >/dev/null || give_up lab_no_gnuplot
  is_configured_with_tests || configure -DFOS_TESTS=ON
  if [[ $mode == ladder ]]; then
    climb "${words[@]}"
  else
    build "$BUILD" "fos_$mode" || fail 3 lab_no_trade_program
    "$BUILD/bin/fos_$mode" "${options[@]}" "${words[@]}"
  fi
}

# only_with STUDY WORD…: fails over words that say nothing to this study; empty ones are none.
only_with() {
  local word
  for word in "${@:2}"; do [[ -z $word ]] || fail 2 lab_trade_not_with "$1" "$word"; done
}

# climb [STAGE]: the ladder, with the student's stage on it, which is built at every precision. The
# options of the program are the caller's.
climb() {
  local targets=(fos_trade) others=()
  know_stages "$@"
  if (($#)); then
    # shellcheck source=/dev/null
    source "$BUILD/stages.sh"
    [[ -e $ROOT/labs/${FOS_STAGE_FILE[$1]} ]] ||
      fail 1 lab_no_stage_file "labs/${FOS_STAGE_FILE[$1]}"
    targets+=(empty_stage empty_stage_float empty_stage_extended "lab_$1")
    others=("lab_${1}_float" "lab_${1}_extended")
    options+=(--stage "$1" --programs "$BUILD/bin")
  fi
  build "$BUILD" "${targets[@]}" || say_what_failed "${targets[@]}"
  if ((${#others[@]})); then # only now: a mistake is told once, not at every precision
    build "$BUILD" "${others[@]}" || say_what_failed "${others[@]}"
  fi
  "$BUILD/bin/fos_trade" "${options[@]}"
}

check_csv() {
  case ${1,,} in *[^/].csv) check_place "$1" ;; *) fail 2 lab_bad_csv "$1" ;; esac
}
check_plot() {
  case ${1,,} in *[^/].png | *[^/].svg) check_place "$1" ;; *) fail 2 lab_bad_plot "$1" ;; esac
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
