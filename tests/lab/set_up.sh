#!/usr/bin/env bash
# The packages: who installs them, what is said and asked, and what happens where that fails.
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

line='apt-get install --no-install-recommends g++ tao-pegtl-dev'
asks_apt='-y --no-remove --no-install-recommends g++ tao-pegtl-dev'
# bare UID: a tree and a machine without two of the packages, and its user.
bare() {
  make_tree
  rm "$STATE/installed-g++" "$STATE/installed-tao-pegtl-dev"
  echo "$1" >"$STATE/uid"
}
sudo_that() { # yes: needs no password; no: needs one
  echo "$1" >"$STATE/sudo"
  pretend sudo <<'EOT'
[[ $1 == -n || $1 == -v ]] && { [[ $(<"$STATE/sudo") == yes ]]; exit; }
exec "$@"
EOT
}

make_tree
lab render point
check "all there: apt is not called" not called apt-get
check "all there: nothing is said" test -z "$ERR"

bare 0
lab render point
check "root: done" status 0
check "root: which are missing" err 'g++ tao-pegtl-dev'
check "root: not which are there" not err cmake
check "root: how much" err '1544 kB'
check "root: how much" err '7382 kB'
check "root, no terminal: nothing is asked" not err 'Y/n'
check "root: without what is merely recommended" called "$asks_apt"
check "root: no update where the lists will do" not called 'update'
check "root: is noted" grep -q 'Need to get' "$TREE/build/apt.log"
: >"$STATE/calls"
lab render point
check "root, the second time: straight through" not called apt-get

bare 0
rm "$STATE/lists"
lab render point
check "no lists: fetched first" status 0
check "no lists: fetched first" called update
bare 0
touch "$STATE/old-lists"
lab render point
check "old lists: fetched, and tried again" status 0
check "old lists: fetched" called update
bare 0
touch "$STATE/gone"
lab render point
check "what the lists name is gone for good" status 3
bare 0
rm "$STATE/network"
lab render point
check "no network" status 3
check "no network: apt's own word" err 'no network'
check "no network: the log" err build/apt.log
check "no network: the line for an administrator" err "$line"
check "no network: nothing was built" nothing_built
rm "$STATE/lists"
lab render point
check "no network and no lists" status 3
check "no network and no lists" err 'Unable to locate'

bare 1000
lab render point
check "no rights: goes on" status 0
check "no rights: the line for an administrator" err "$line"
check "no rights: apt is not called" not called apt-get
touch "$STATE/cmake-fails"
rm -r "$TREE/build"
lab render point
check "no rights, and it is needed" status 3
check "no rights, and it is needed: the line" err "$line"
check "no rights, in Greek" not err διαχειριστής
lab --lang el render point
check "no rights, in Greek" err διαχειριστής
check "no rights, in Greek" err "$line"

bare 1000
sudo_that yes
lab render point
check "sudo: done" status 0
check "sudo" called 'sudo env DEBIAN_FRONTEND=noninteractive'
bare 1000
sudo_that no
lab render point
check "sudo with a password, no terminal: goes on" status 0
check "sudo with a password, no terminal: the line" err "$line"
check "sudo with a password, no terminal: apt is not called" not called apt-get
check "sudo with a password, no terminal: is not asked for" not called 'sudo -v'

bare 0
rm "$WORK/bin/apt-get"
lab render point
check "no apt: goes on" status 0
check "no apt: nothing is said" test -z "$ERR"
rm -r "$TREE/build"
touch "$STATE/cmake-fails"
lab render point
check "no apt, and it is needed" status 3
check "no apt, and it is needed: what they are" err OpenImageIO
rm "$WORK/bin/cmake"
lab render point
check "no apt, no cmake" status 3
check "no apt, no cmake" err 'CMake'

# A person at a terminal. answer WORD ARGUMENT…: ./lab with a terminal, where WORD is typed.
answer() {
  local command
  printf -v command '%q ' env -i PATH="$WORK/bin" HOME="$WORK" STATE="$STATE" \
    WORK_BIN="$WORK/bin" "$TREE/lab" "${@:2}"
  ERR=$(printf '%s' "$1" | script -qec "$command" /dev/null)
  STATUS=$? OUT=''
}
if command -v script >/dev/null; then
  for word in $'\n' $'y\n' $'Yes\n' $'Ν\n' $'ναι\n'; do
    bare 0
    answer "$word" --lang el render point
    check "a terminal: asks" err 'Ν/ο'
    check "a terminal: yes is $word" called "$asks_apt"
    check "a terminal: done" status 0
  done
  for word in $'n\n' $'ο\n' $'\x04'; do
    bare 0
    answer "$word" render point
    check "a terminal: asks" err 'Y/n'
    check "a terminal: no is $word" not called "$asks_apt"
    check "a terminal: goes on after a no" status 0
  done
  make_tree
  answer '' render point
  check "a terminal, all there: asks nothing" not err 'Y/n'
  bare 1000
  sudo_that no
  answer '' render point
  check "a terminal, no right to sudo: asks for the password" called 'sudo -v'
  check "a terminal, no right to sudo: goes on" status 0
else
  echo "NOT RUN: what is asked at a terminal (the program 'script' is not here)"
fi

finish
