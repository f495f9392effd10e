# `./lab kit gradescope|actions|slurm`: the toolkit with what a platform starts, as a zip. Sourced by
# ./lab, whose words and options it uses, and pack.bash.

# kit_platform KIND [--output F.zip] [--seed S] [--feedback F]
kit_platform() {
  local kind=$1 output='' seed='' feedback=hints
  shift
  while (($#)); do
    TOOK=1
    case $1 in
      --output | --output=*) take "$@" && kit_place "$VALUE" && output=$VALUE ;;
      --seed | --seed=*) take "$@" && kit_seed "$VALUE" && seed=$VALUE ;;
      --feedback | --feedback=*) take "$@" && require lab_kit_feedback "$VALUE" marks hints full && feedback=$VALUE ;;
      *) require lab_unknown_option "$1" --output --seed --feedback --lang ;;
    esac
    shift "$TOOK"
  done
  [[ $seed ]] || seed=$((RANDOM << 15 | RANDOM))

  set_up build
  command -v cmake >/dev/null || give_up lab_no_cmake
  begin_kit "fos-$kind" "$output"
  if ! "kit_$kind" || ! end_kit; then fail 3 lab_kit_fails "$KIT_ZIP"; fi
  say lab_kit_settings "$seed" "$feedback"
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
