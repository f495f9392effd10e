# `./lab explain`: one pixel, step by step, by fos_explain. Sourced by ./lab, whose words, options and
# build it uses.

# knows_exact: the build folder was made for this.
knows_exact() { is_configured && [[ $(<"$BUILD/CMakeCache.txt") == *$'\n'FOS_EXPLAIN:BOOL=ON$'\n'* ]]; }

# explain STAGE COLUMN ROW: what is right, beside what the student's stage gives.
explain() {
  local scene=$ROOT/labs/scenes/lecture.scene words=() word status=0 yours=()
  while (($#)); do
    TOOK=1
    case $1 in
      --scene | --scene=*) take "$@" && check_scene "$VALUE" && scene=$VALUE ;;
      -[0-9]*) words+=("$1") ;; # a number that is told so
      -*) require lab_unknown_option "$1" --scene --lang ;;
      *) words+=("$1") ;;
    esac
    shift "$TOOK"
  done
  ((${#words[@]} == 0)) || know_stages "${words[0]}"
  ((${#words[@]} == 3)) || fail 2 lab_explain_three
  for word in "${words[@]:1}"; do
    [[ $word =~ ^[0-9]{1,9}$ ]] || fail 2 lab_explain_bad_number "$word"
  done

  set_up build exact
  is_configured_with_tests || knows_exact || configure -DFOS_TESTS=OFF -DFOS_EXPLAIN=ON
  know_stages "${words[0]}"
  # shellcheck source=/dev/null
  source "$BUILD/stages.sh"
  if [[ -e $ROOT/labs/${FOS_STAGE_FILE[${words[0]}]} ]]; then
    yours=("lab_${words[0]}")
  else
    complain lab_no_stage_file "labs/${FOS_STAGE_FILE[${words[0]}]}"
    status=1
  fi
  if ! build "$BUILD" fos_explain "${yours[@]}"; then
    is_built fos_explain || fail 3 lab_no_explain_program
    if ((${#yours[@]})) && ! is_built "${yours[0]}"; then
      complain lab_stage_does_not_build "${words[0]}"
      yours=() status=1
    fi
  fi
  ((${#yours[@]})) && yours=(--program "$BUILD/bin/${yours[0]}")
  "$BUILD/bin/fos_explain" --stage "${words[0]}" --scene "$scene" "${yours[@]}" "${words[@]:1}" ||
    status=$?
  return "$status"
}
