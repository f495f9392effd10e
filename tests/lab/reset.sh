#!/usr/bin/env bash
# `./lab reset`: the stub comes back, and nothing that a student wrote is ever lost.
# shellcheck disable=SC2016,SC2317 # what the pretenders are to expand; functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

stage=$TREE/labs/lecture04/point.cpp
stub='the stub of lecture04/point'
holds() { [[ $(<"$1") == "$2" ]]; }
# only FILE…: lecture 4's folder holds these files, hidden ones too, and the other stage's.
only() { [[ $(shopt -s dotglob && cd "$TREE/labs/lecture04" && echo *) == "ambient.cpp $*" ]]; }

make_tree
lab reset point
check "already the stub" status 0
check "already the stub: said" out 'the stub already'
check "already the stub: nothing beside it" only point.cpp
echo 'my work' >"$stage"
lab reset point
check "done" status 0
check "the stub is back" holds "$stage" "$stub"
check "what was there is kept" holds "$stage.1.old" 'my work'
check "where it is kept is said" out 'labs/lecture04/point.cpp.1.old'
check "nothing else is left" only point.cpp point.cpp.1.old
check "nothing is installed, configured, built" nothing_built
echo 'more work' >"$stage"
lab --lang el reset point
check "an older copy is never overwritten" holds "$stage.1.old" 'my work'
check "the second copy" holds "$stage.2.old" 'more work'
check "in Greek" out 'βρίσκεται στο labs/lecture04/point.cpp.2.old'
rm "$stage.1.old" && ln -s nowhere "$stage.1.old" && echo 'third' >"$stage"
lab reset point
check "not through a link either" holds "$stage.3.old" 'third'
rm "$stage"
lab reset point
check "a file that is gone comes back" holds "$stage" "$stub"
check "a file that is gone comes back" status 0
rm -r "$TREE/labs/lecture04"
lab reset point
check "its folder too" holds "$stage" "$stub"

make_tree
mkdir "$WORK/elsewhere" && echo 'my work' >"$WORK/elsewhere/file" && ln -sf "$WORK/elsewhere/file" "$stage"
lab reset point
check "a link becomes the stub" test ! -L "$stage" -a -f "$stage"
check "what a link leads to is left alone" holds "$WORK/elsewhere/file" 'my work'
check "what a link leads to is kept" holds "$stage.1.old" 'my work'

# Each step that can fail.
refused() {
  check "$1: status" status 3
  check "$1: said" err 'nothing was changed'
  check "$1: the file is as it was" holds "$stage" 'my work'
  check "$1: nothing else is left" only point.cpp
}
make_tree
echo 'my work' >"$stage"
pretend mv <<<'exit 1'
lab reset point
refused "the stub cannot take its place"
# cat_fails WHERE HOW: cat gives up half-way where it writes into a file of that name.
cat_fails() {
  make_tree
  echo 'my work' >"$stage"
  rm "$WORK/bin/cat"
  printf '#!/bin/bash\n[[ $(readlink /proc/$$/fd/1) == *%s ]] && { echo half of; %s; }\nexec %q "$@"\n' \
    "$1" "$2" "$(command -v cat)" >"$WORK/bin/cat"
  chmod +x "$WORK/bin/cat"
  lab reset point
}
cat_fails .old 'exit 1'
refused "the disk is full while the old file is copied"
cat_fails .part 'exit 1'
refused "the disk is full while the stub is copied"
for where in .old .part; do
  cat_fails "$where" 'kill -INT "$PPID"; sleep 0.2; exit 1'
  check "Ctrl-C at $where" status 130
  check "Ctrl-C at $where: the file is as it was" holds "$stage" 'my work'
  check "Ctrl-C at $where: nothing else is left" only point.cpp
done
make_machine
if [[ $(id -u) != 0 ]]; then # root may write anywhere
  chmod a-w "$TREE/labs/lecture04"
  lab reset point
  refused "a folder that may not be written"
  chmod u+w "$TREE/labs/lecture04" && chmod a-r "$stage"
  lab reset point
  check "a file that may not be read" status 3
  chmod u+r "$stage"
fi
rm "$stage" && mkdir "$stage"
lab reset point
check "a folder in its place" status 3
check "a folder in its place: said" err 'is a folder'

finish
