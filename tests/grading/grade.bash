# `./lab grade`: a class, by fos_grade, which reads the options. Sourced by ./lab, whose words and build
# it uses.

grade() {
  (($#)) || fail 2 lab_grade_needs_path
  set_up build test grade
  knows_grading || configure -DFOS_TESTS=ON
  build "$BUILD" fos_grade fos_picture || fail 3 lab_no_grade_program
  if [[ $1 == --self-test ]]; then exec "$ROOT/tests/grading/self_test.sh" "$ROOT" "$BUILD" "${@:2}"; fi
  exec "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$@"
}

# knows_grading: the build folder was made where all packages were there.
knows_grading() { is_configured_with_tests && [[ $(<"$BUILD/CMakeCache.txt") != *FOS_ZIP_HEADERS-NOTFOUND* ]]; }
