# The student's loop: check, watch, hint, reset, submit. Sourced by ./lab, whose words, options and
# build it uses.

SHIPPED=$ROOT/tests/check/shipped # the stubs, as a student gets them

# check_stages [STAGE…]: what each stage does and does not; without a STAGE all of them, in an overview.
check_stages() {
  local stage stages=() options=() jobs=() status=0 result
  for stage; do
    [[ $stage != -* ]] || require lab_unknown_option "$stage" --lang
    stages+=("$stage")
  done
  prepare "${stages[@]}"
  # shellcheck source=/dev/null
  source "$BUILD/stages.sh"
  ((${#stages[@]})) || { stages=("${FOS_STAGES[@]}") options=(--overview); }

  build_stages "${stages[@]}"
  for stage in "${stages[@]}"; do
    case ${MADE[$stage]} in
      yes) jobs+=("$stage=$BUILD/bin/lab_$stage") ;;
      no) jobs+=("$stage=!$ROOT/build/logs/lab_$stage.log") ;;
      missing)
        complain lab_no_stage_file "labs/${FOS_STAGE_FILE[$stage]}"
        complain lab_reset_brings_back "$stage"
        status=1
        ;;
    esac
  done
  ((${#jobs[@]})) || return "$status"
  "$BUILD/bin/fos_check" --root "$ROOT" --images "$ROOT/build/images" --picture "$BUILD/bin/fos_picture" \
    "${options[@]}" "${jobs[@]}"
  result=$?
  ((result > status)) && status=$result
  return "$status"
}

# watch_stage STAGE: checks it at every save; fos_watch itself builds the stage.
watch_stage() {
  one_stage watch "$@"
  prepare "$1"
  # shellcheck source=/dev/null
  source "$BUILD/stages.sh"
  [[ -e $ROOT/labs/${FOS_STAGE_FILE[$1]} ]] || fail 1 lab_no_stage_file "labs/${FOS_STAGE_FILE[$1]}"
  build "$BUILD" fos_watch fos_picture || fail 3 lab_no_check_program
  exec "$BUILD/bin/fos_watch" --root "$ROOT" --build "$BUILD" --stage "$1"
}

# one_stage COMMAND WORD…: fails unless the words are one stage.
one_stage() {
  local word
  for word in "${@:2}"; do [[ $word != -* ]] || require lab_unknown_option "$word" --lang; done
  know_stages "${@:2}"
  (($# == 2)) || fail 2 lab_one_stage "$1" "${FOS_STAGES[*]}"
}

# prepare STAGE…: a build folder, which knows these stages.
prepare() {
  know_stages "$@"
  set_up build
  is_configured || configure -DFOS_TESTS=OFF
  know_stages "$@"
}

# build_stages STAGE…: the programs of these stages and what checks them. MADE says of each stage: yes,
# no (what the compiler says is in build/logs/lab_STAGE.log), or missing. What the compiler says of a
# stage that it builds all the same goes to stderr, and so does what it says of ours, which is the end.
build_stages() {
  local stage targets=(fos_check fos_picture) alone=() line whose='' skip='' failed='' trouble=''
  local -A said=()
  declare -gA MADE=()
  mkdir -p "$ROOT"/build/{logs,images} || exit 3
  for stage; do
    MADE[$stage]=missing
    [[ -e $ROOT/labs/${FOS_STAGE_FILE[$stage]} ]] || continue
    MADE[$stage]=yes
    targets+=("lab_$stage")
  done
  command -v flock >/dev/null && alone=(flock "$BUILD/build.ninja") # as in build

  # A person waits, so ninja starts once for all. Whose a line is, the heading above it says.
  while IFS= read -r line; do
    if [[ $skip ]]; then # the whole command
      skip=''
    elif [[ $line == 'FAILED: '* || $line =~ ^\[[0-9]+/[0-9]+\]\  ]]; then
      whose=''
      [[ $line =~ (^|[/ ])lab_([a-z0-9_]+)(\.dir/|[ ]|$) ]] && whose=${BASH_REMATCH[2]}
      if [[ $line == 'FAILED: '* ]]; then
        skip=yes failed=yes
        if [[ $whose ]]; then MADE[$whose]=no; else trouble+=" $line"; fi
      else
        show_line "$line"
      fi
    elif [[ $line != '-- '* && ($line != 'ninja: '* || $line == 'ninja: error'*) ]]; then
      said[.$whose]+=$line$'\n'
    fi
  done < <(LC_ALL=C.UTF-8 NINJA_STATUS='[%f/%t] ' \
    "${alone[@]}" ninja -C "$BUILD" -k 0 "${targets[@]}" 2>&1)
  wait "$!" || [[ $failed ]] || trouble=ninja
  show_line

  for stage; do
    line=$ROOT/build/logs/lab_$stage.log
    rm -f "$line"
    if [[ ${MADE[$stage]} == no ]]; then
      printf '%s' "${said[.$stage]-}" >"$line" || exit 3
    else
      printf '%s' "${said[.$stage]-}" >&2
    fi
  done
  [[ $trouble ]] || return 0
  printf '%s' "${said[.]-}" >&2
  [[ $trouble == *fos_picture* ]] && fail 3 lab_no_picture_program
  fail 3 lab_no_check_program
}

# next_hint STAGE [--all|--reset]: fos_hint remembers which one was the last.
next_hint() {
  local words=() options=()
  while (($#)); do
    case $1 in
      --all | --reset) options+=("$1") ;;
      -*) require lab_unknown_option "$1" --all --reset --lang ;;
      *) words+=("$1") ;;
    esac
    shift
  done
  one_stage hint "${words[@]}"
  ((${#options[@]} <= 1)) || fail 2 lab_hint_one_option
  prepare "${words[0]}"
  build "$BUILD" fos_hint || fail 3 lab_no_check_program
  "$BUILD/bin/fos_hint" --state "$ROOT/build/hints" "${options[@]}" "${words[0]}"
}

# reset_stage STAGE: the stub as it was shipped; what was there is kept beside it. Nothing is lost,
# whatever comes in between: the old file is copied first, and the stub takes its place whole.
reset_stage() {
  local known=() file shipped=() stub old='' number=1
  for file in "$SHIPPED"/lecture*/*.cpp; do file=${file##*/} && known+=("${file%.cpp}"); done
  for file; do
    [[ $file != -* ]] || require lab_unknown_option "$file" --lang
    require lab_unknown_stage "$file" "${known[@]}"
  done
  (($# == 1)) || fail 2 lab_one_stage reset "${known[*]}"

  shipped=("$SHIPPED"/lecture*/"$1.cpp")
  stub=${shipped[0]#"$SHIPPED"/}
  file=$ROOT/labs/$stub
  [[ ! -d $file ]] || fail 3 lab_reset_is_folder "labs/$stub"
  if [[ -e $file ]] && is_stub "$file"; then
    say lab_reset_nothing "labs/$stub"
    return
  fi
  OLD='' NEW=$ROOT/labs/${stub%/*}/.$1.cpp.$$.part
  trap reset_undone EXIT
  mkdir -p "${file%/*}" 2>/dev/null
  cat <"${shipped[0]}" 2>/dev/null >"$NEW" || fail 3 lab_reset_fails "labs/$stub"
  if [[ -e $file ]]; then
    while old=$file.$number.old && [[ -e $old || -L $old ]]; do number=$((number + 1)); done
    (set -C && : >"$old") 2>/dev/null || fail 3 lab_reset_fails "labs/$stub"
    OLD=$old
    cat <"$file" 2>/dev/null >"$old" || fail 3 lab_reset_fails "labs/$stub"
  fi
  mv -f -- "$NEW" "$file" 2>/dev/null || fail 3 lab_reset_fails "labs/$stub"
  OLD=''
  trap - EXIT
  say lab_reset_done "labs/$stub"
  [[ -z $old ]] || say lab_reset_kept "labs/$stub.$number.old"
}
reset_undone() { rm -f -- "$NEW" ${OLD:+"$OLD"} 2>/dev/null; }

# is_stub FILE: a stage's file is as it was shipped.
is_stub() {
  [[ -f $1 && $(<"$1") == "$(<"$SHIPPED/${1#"$ROOT"/labs/}")" ]] 2>/dev/null
}

# hand_in [--output F.zip]: the stage files and nothing else, after what check says of them. Its verdict
# does not stand in the way: what is handed in is the student's to decide.
hand_in() {
  local output=$ROOT/fos-submission.zip stage file files=() bytes=0 stubs='' result
  while (($#)); do
    TOOK=1
    case $1 in
      --output | --output=*) take "$@" && check_zip "$VALUE" && output=$VALUE ;;
      -*) require lab_unknown_option "$1" --output --lang ;;
      *) fail 2 lab_submit_all "$1" ;;
    esac
    shift "$TOOK"
  done
  (check_stages) # in a shell of its own, so that trouble of ours leaves the zip possible
  result=$?
  if is_configured; then
    # shellcheck source=/dev/null
    source "$BUILD/stages.sh"
  else
    know_shipped
  fi
  for stage in "${FOS_STAGES[@]}"; do
    file=${FOS_STAGE_FILE[$stage]}
    check_hand_in "$stage" "$file"
    files+=("$file")
    is_stub "$ROOT/labs/$file" && stubs+=" $stage"
  done

  [[ $output == /* ]] || output=$PWD/$output
  NEW=${output%/*}/.${output##*/}.$$.part OLD=''
  trap reset_undone EXIT
  if ! (cd "$ROOT/labs" && cmake -E tar cf "$NEW" --format=zip -- "${files[@]}") >&2 ||
    ! bytes=$(stat -c %s -- "$NEW") || ! mv -f -- "$NEW" "$output"; then
    no_zip 3 lab_submit_fails "$output"
  fi
  trap - EXIT
  ((result == 1)) && say lab_submit_not_all
  ((result > 1)) && say lab_submit_unchecked
  [[ -z $stubs ]] || say lab_submit_stubs "${stubs# }"
  say lab_submit_done "${output#"$PWD/"}" "${#files[@]}" "$bytes"
}

# check_hand_in STAGE FILE: fails over a file that is not there or that the grader would not take.
check_hand_in() {
  local file=$ROOT/labs/$2
  if [[ -L $file ]]; then
    no_zip 2 lab_submit_link "labs/$2"
  elif [[ ! -e $file ]]; then
    complain lab_no_stage_file "labs/$2"
    no_zip 1 lab_reset_brings_back "$1"
  elif [[ ! -f $file || ! -r $file ]]; then
    no_zip 2 lab_submit_unreadable "labs/$2"
  elif (($(stat -c %s -- "$file") > 256 * 1024)); then
    no_zip 2 lab_submit_large "labs/$2"
  elif ! is_text "$file"; then
    no_zip 2 lab_submit_not_text "labs/$2"
  fi
}
no_zip() {
  complain "${@:2}"
  complain lab_submit_none
  [[ ! -e $output ]] || complain lab_submit_older "$output"
  exit "$1"
}
is_text() {
  [[ -z $(LC_ALL=C tr -d -c '\000' <"$1" | od -A n -N 1) ]] || return 1
  ! command -v iconv >/dev/null || iconv -f UTF-8 -t UTF-8 <"$1" >/dev/null 2>&1
}

# know_shipped: sets FOS_STAGES and FOS_STAGE_FILE where CMake could not, from the stubs.
know_shipped() {
  local file stage
  FOS_STAGES=()
  declare -gA FOS_STAGE_FILE=()
  for file in "$SHIPPED"/lecture*/*.cpp; do
    file=${file#"$SHIPPED"/} stage=${file##*/}
    FOS_STAGES+=("${stage%.cpp}")
    FOS_STAGE_FILE[${stage%.cpp}]=$file
  done
}

check_zip() {
  case ${1,,} in *[^/].zip) check_place "$1" ;; *) fail 2 lab_bad_zip "$1" ;; esac
}
