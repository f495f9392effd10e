# `./lab kit gradescope|actions|slurm`: the toolkit with what a platform starts, as a zip. Sourced by
# ./lab, whose words, options and build it uses.

KIT_KINDS=(gradescope actions slurm)

# kit_platform KIND [--output F.zip] [--seed S] [--feedback F]: the zip, whole or not at all.
kit_platform() {
  local kinds=() output='' seed='' feedback=hints known=("${KIT_KINDS[@]}")
  [[ -e $ROOT/tests/kits/kit.bash ]] && known=(student instructor "${known[@]}")
  while (($#)); do
    TOOK=1
    case $1 in
      --output | --output=*) take "$@" && kit_place "$VALUE" && output=$VALUE ;;
      --seed | --seed=*) take "$@" && kit_seed "$VALUE" && seed=$VALUE ;;
      --feedback | --feedback=*) take "$@" && require lab_kit_feedback "$VALUE" marks hints full && feedback=$VALUE ;;
      -*) require lab_unknown_option "$1" --output --seed --feedback --lang ;;
      *) require lab_unknown_kit "$1" "${known[@]}" && kinds+=("$1") ;;
    esac
    shift "$TOOK"
  done
  ((${#kinds[@]} == 1)) || fail 2 lab_one_kit "${known[*]}"
  [[ $seed ]] || seed=$((RANDOM << 15 | RANDOM))

  set_up build
  command -v cmake >/dev/null || give_up lab_no_cmake
  if [[ ! $output ]]; then
    mkdir -p "$ROOT/build/kits" || exit 3
    output=$ROOT/build/kits/fos-${kinds[0]}.zip
  fi
  [[ $output == /* ]] || output=$PWD/$output
  NEW=${output%/*}/.${output##*/}.$$.part KIT=$(mktemp -d) || exit 3
  trap 'rm -rf -- "$KIT" "$KIT.list" "$NEW"' EXIT
  if ! "kit_${kinds[0]}" || ! kit_zip || ! mv -f -- "$NEW" "$output"; then fail 3 lab_kit_fails "$output"; fi
  say lab_kit_done "${output#"$PWD/"}" "$seed" "$feedback"
}

kit_place() {
  case ${1,,} in *[^/].zip) check_place "$1" ;; *) fail 2 lab_bad_zip "$1" ;; esac
}
kit_seed() { [[ $1 =~ ^[0-9]{1,18}$ ]] || fail 2 lab_kit_seed "$1"; }

# Gradescope unpacks it in /autograder/source, and wants these two at the top.
kit_gradescope() {
  kit_tree fos solutions && cp "$ROOT/tests/grading/kits/gradescope/"{setup.sh,run_autograder} "$KIT"
}

# To lay over the repository that students get: where it is in nobody's way, and without right stages,
# also those in other words that tests have; of these the first line stays, for CMake reads the names.
kit_actions() {
  local tests=$KIT/.github/fos/tests
  kit_tree .github/fos && rm -rf "$tests/grading/red_team" &&
    find "$tests"/{misconceptions/submissions,check/variants} -name '*.cpp' -exec sed -i '2,$d' {} + &&
    mkdir -p "$KIT/.github/workflows" &&
    cp "$ROOT/tests/grading/kits/actions/fos.yml" "$KIT/.github/workflows"
}

kit_slurm() { kit_tree fos solutions && cp "$ROOT/tests/grading/kits/slurm/fos-slurm.sh" "$KIT"; }

# kit_tree FOLDER [PART…]: into the kit's FOLDER what is needed to build the grader and to grade, with
# these PARTs of the tree, and the settings; nothing hidden, and nothing that was made.
kit_tree() {
  local tree=$KIT/$1
  mkdir -p "$tree" && (cd "$ROOT" && find lab CMakeLists.txt LICENSE cmake common labs tests "${@:2}" \
    -type f ! -name '.*' ! -name '*.old' ! -name '*.pyc' -print0 |
    xargs -0 cp --parents -t "$tree") || return
  printf 'FOS_SEED=%s\nFOS_FEEDBACK=%s\nFOS_LANG=%s\n' "$seed" "$feedback" "$FOS_LANG" >"$tree/kit-settings.bash"
}

# kit_zip: NEW, of all that is in KIT, in one order and as of one time.
kit_zip() {
  chmod -R u=rwX,go=rX "$KIT" &&
    (cd "$KIT" && find . -type f -printf '%P\n' | LC_ALL=C sort >"$KIT.list" &&
      TZ=UTC cmake -E tar cf "$NEW" --format=zip --mtime='2026-01-01 00:00:00' --files-from="$KIT.list") >&2
}
