# `./lab grade`: a class, by fos_grade, which reads the options. Sourced by ./lab, whose words and build
# it uses.

grade() {
  set_up build test grade
  is_configured_with_tests || configure -DFOS_TESTS=ON
  build "$BUILD" fos_grade fos_picture fos_box_inside || fail 3 lab_no_grade_program
  exec "$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$@"
}
