#!/usr/bin/env bash
# `./lab submit`: what is in the zip, what is said first, and what is refused.
# shellcheck disable=SC2317 # functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

zip=$TREE/fos-submission.zip
stage=$TREE/labs/lecture04/point.cpp
files='lecture03/flat_color.cpp lecture04/ambient.cpp lecture04/point.cpp'
holds() { [[ $(<"$1") == "$2" ]]; }
nothing_left() { [[ -z $(shopt -s nullglob && echo "$WORK"/.*.part "$TREE"/.*.part) ]]; }
stubs=$'the stub of lecture03/flat_color\nthe stub of lecture04/ambient\n'

make_tree
echo 'my work' >"$stage"
touch "$TREE/labs/lecture04/point.cpp.1.old" "$TREE/labs/lecture04/mine.cpp"
lab submit
check "done" status 0
check "the stages and nothing else, by these names" called "--format=zip -- $files"
check "the pretended zip" holds "$zip" "${stubs}my work"
check "checks all, first" called 'fos_check --root'
check "checks all, in an overview" called '--overview'
check "which are stubs" out 'nothing is written yet in: flat_color ambient'
check "ends with the file, from where the person is" test "${OUT##*$'\n'}" == \
  'a tree/fos-submission.zip: 3 files, 71 bytes'
check "nothing else is left" nothing_left
lab submit --output 'my zip.zip'
check "another name, from where the person is" holds "$WORK/my zip.zip" "${stubs}my work"
check "another name: said" out 'my zip.zip: 3 files'
lab --lang el submit
check "in Greek" out 'αρχεία'

echo 1 >"$STATE/picture-status"
lab submit
check "what fails is handed in too" status 0
check "what fails is handed in too: said" out 'not everything passes yet'
rm "$STATE/picture-status"
echo 'more work' | tee "$TREE/labs/lecture03/flat_color.cpp" >"$TREE/labs/lecture04/ambient.cpp"
lab submit
check "all of them written: no word of stubs" not out 'nothing is written yet'
echo fos_check >"$STATE/broken"
lab submit
check "without a checking program" status 0
check "without a checking program: said" out 'could not be checked'
check "without a checking program: the zip" test -s "$zip"
rm "$STATE/broken"
rm -r "$TREE/build" && touch "$STATE/cmake-fails" && rm "$zip"
lab submit
check "without a build" status 0
check "without a build: the zip" test -s "$zip"
rm "$STATE/cmake-fails"

# refused WHAT STATUS WORDS: no zip, and the one that was there stays and is named.
refused() {
  lab submit
  check "$1: status" status "$2"
  check "$1: why" err "$3"
  check "$1: no zip" err 'no zip was made'
  check "$1: the older one is left" holds "$zip" 'an older one'
  check "$1: the older one is named" err "$zip is from an earlier run"
  check "$1: nothing else is left" nothing_left
}
make_tree
echo 'an older one' >"$zip"
touch "$STATE/zip-fails"
refused "the disk is full" 3 'cannot be written'
rm "$STATE/zip-fails"
pretend mv <<<'exit 1'
refused "the zip cannot take its place" 3 'cannot be written'
make_machine
rm "$stage"
refused "a missing file" 1 "'./lab reset point' brings it back"
ln -s ../lecture04/ambient.cpp "$stage"
refused "a link" 2 'symbolic link'
rm "$stage" && mkdir "$stage"
refused "a folder" 2 'not a file that can be read'
rmdir "$stage" && head -c 262145 /dev/zero | tr '\0' x >"$stage"
refused "a large file" 2 'larger than 256 KiB'
printf 'a\xff\n' >"$stage"
refused "Latin text" 2 'not UTF-8'
printf 'a\0b\n' >"$stage"
refused "bytes that are no text" 2 'not UTF-8'
printf '// κείμενο\r\n' >"$stage"
lab submit
check "Greek text" status 0
head -c 262144 /dev/zero | tr '\0' x >"$stage"
lab submit
check "just small enough" status 0

finish
