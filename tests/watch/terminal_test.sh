#!/usr/bin/env bash
# terminal_test.sh ROOT BUILD: watch in a terminal, and as a plain log: what it says at each save, its
# keys, and that it leaves the terminal as it found it, however it ends.
# shellcheck disable=SC2016,SC2317 # what the inner shell expands; functions for `check`
# shellcheck source=tests/watch/copied_tree.bash
source "$(dirname "$0")/copied_tree.bash" "$1" "$2"
command -v script >/dev/null || { echo "NOT RUN: the program 'script' is not here" && exit 77; }
export LC_ALL=C.UTF-8 FOS_LANG=en TERM=xterm
SOLUTION=$ROOT/solutions/lecture04/point.cpp

# session COMMANDS: watch of `point` in a terminal, after these commands of a shell; keys go to
# descriptor 4. The terminal's settings before and after, and how it ended, are in $WORK.
session() {
  rm -f "$WORK"/{keys,screen,before,after,status,pid}
  mkfifo "$WORK/keys"
  cat >"$WORK/inner" <<'EOT'
set -m
stty -a >"$WORK/before"
"$BUILD/bin/fos_watch" --root "$TREE" --build "$COPY" --stage point
status=$?
stty -a >"$WORK/after"
if jobs %% &>/dev/null; then # stopped, not ended
  echo stopped
  read -r _
  fg
  status=$?
  stty -a >"$WORK/after"
fi
echo "$status" >"$WORK/status"
EOT
  export WORK TREE COPY BUILD
  # A program in the background hears no Ctrl-C, unless it is told to.
  # The shell of `inner` is bash, whatever the user's own is.
  env --default-signal=INT,QUIT SHELL="$BASH" script -qfeac "$1 . '$WORK/inner'" "$WORK/screen" <"$WORK/keys" >/dev/null &
  SCRIPT=$!
  exec 4>"$WORK/keys"
}
press() { printf '%b' "$1" >&4; }
# ended STATUS: with it, and the terminal is as it was.
ended() {
  local i
  for ((i = 0; i < 200; i++)); do [[ ! -s $WORK/status ]] || break; sleep 0.05; done
  exec 4>&-
  [[ -s $WORK/status ]] || kill "$SCRIPT"
  wait "$SCRIPT"
  check "ends with $1, not $(cat "$WORK/status" 2>&1)" test "$(cat "$WORK/status" 2>/dev/null)" == "$1"
  check "the terminal is as it was, after $1" cmp -s "$WORK/before" "$WORK/after"
}
fresh() { : >"$WORK/screen"; } # what comes from now on (script appends)
not() { ! "$@"; }
shown() { grep -qF -- "$1" "$WORK/screen"; }
comes() { check "$1" wait_for "$@"; }
# process WORDS: the number of the one whose command line has these words.
process() {
  local line
  for line in /proc/[0-9]*/cmdline; do
    [[ $(tr '\0' ' ' <"$line") == *"$1"* ]] 2>/dev/null && line=${line%/*} && echo "${line##*/}" && return
  done
}

until_true() { # COMMAND…
  local i
  for ((i = 0; i < 400; i++)); do if "$@"; then return; fi; sleep 0.1; done
  false
}
IMAGES=$TREE/build/images
make_tree point directional

# From the stub to the solution, and q.
session ''
comes 'Nothing is written yet'
comes 'q quit'
comes 'file://'
check 'the path of the page has no space' not shown 'a tree/build/images/viewer.html'
fresh && press n
comes 'the next stage opens when'
fresh && put solutions point
comes 'Well done: Point light'
comes 'n next: directional'
press q
ended 0
check 'the page is there' test -s "$IMAGES/viewer.html"
check 'what it shows is there' grep -q fosView "$IMAGES/point-view.js"

# Every key, in Greek letters too; a child has the terminal as it was.
put labs point
session ''
comes 'q quit'
press h
comes 'child: hint point'
comes 'any key'
check 'a child reads lines' grep -qx $'icanon\r*' "$WORK/screen"
fresh && press ' '
comes 'Nothing is written yet'
fresh && press 'η'
comes 'child: hint point'
fresh && press '\e[A'
comes 'q quit'
fresh && press 'ε'
comes 'Which pixel'
press '37 120\n'
comes 'child: explain point 37 120'
comes 'any key'
fresh && press 'e'
comes 'Which pixel'
press '37\n'
comes 'two whole numbers'
fresh && press 'λ'
comes 'child: check'
comes 'any key'
fresh && printf '#error here\n' >"$TREE/labs/lecture04/point.cpp"
comes 'does not compile'
comes 'error here'
fresh && press c
comes 'error here'
fresh && put solutions point
comes 'Well done'
fresh && press 'ν'
comes 'Watching labs/lecture04/directional.cpp'
comes 'Nothing is written yet'
press ';' # q of a Greek keyboard
ended 1

# Ctrl-C, Ctrl-Z, a line that is being typed, signals, a crash of ours.
session ''
comes 'q quit'
press '\x03'
ended 130
session ''
comes 'q quit'
press e
comes 'Which pixel'
fresh && press '\x03'
comes 'two whole numbers'
press '\x03'
ended 130
session ''
comes 'q quit'
fresh && press '\x1a'
comes stopped
check 'stopped: the terminal is as it was' cmp -s "$WORK/before" "$WORK/after"
fresh && press '\n'
comes 'q quit'
press q
ended 0
for signal in TERM HUP SEGV ABRT; do
  session ''
  comes 'q quit'
  kill "-$signal" "$(process "fos_watch --root $TREE")"
  ended $((128 + $(kill -l "$signal")))
done

# A narrow, low window.
session 'stty columns 30 rows 12;'
comes 'q quit'
check 'the keys fit' grep -qx $'l list · c check again · q\r*\|.\{0,30\}\r*' <(tail -n 3 "$WORK/screen")
press q
ended 0

# A save while an endless loop is being checked: that one is dropped.
sed 's/return i;/for (volatile int one = 1; one == 1;) { } return i;/' "$SOLUTION" >"$TREE/labs/lecture04/point.cpp"
session ''
comes 'checking'
sleep 2
began=$SECONDS
put solutions point
comes 'Well done'
check 'the newest is not kept waiting' test $((SECONDS - began)) -le 8
check 'the old verdict is never shown' not shown 'endless loop'
press q
ended 0

# The file is gone, for a moment and for longer.
session ''
comes 'Well done'
fresh
mv "$TREE/labs/lecture04/point.cpp" "$WORK/kept" && sleep 0.4 && mv "$WORK/kept" "$TREE/labs/lecture04/point.cpp"
sleep 1.5
check 'gone for a moment' not shown 'is not there'
mv "$TREE/labs/lecture04/point.cpp" "$WORK/kept"
comes 'is not there'
fresh && mv "$WORK/kept" "$TREE/labs/lecture04/point.cpp"
comes 'Well done'
press q
ended 0

# Times in whole seconds, or wrong ones: the content counts.
put labs point
touch -d 2001-01-01 "$TREE/labs/lecture04/point.cpp"
session ''
comes 'Nothing is written yet'
cp "$SOLUTION" "$WORK/kept" && touch -d 2001-01-01 "$WORK/kept"
mv "$WORK/kept" "$TREE/labs/lecture04/point.cpp"
comes 'Well done'
press q
ended 0

# The picture program dies: the page keeps the words, and the next save has pictures.
put labs point
rm -f "$IMAGES"/* # of the sessions before
session ''
comes 'q quit'
check 'a picture' until_true test -s "$IMAGES/point-check.png"
check 'the page follows' until_true test "$IMAGES/view-now.js" -nt "$IMAGES/point-check.png"
kill -KILL "$(process "$COPY/bin/fos_picture serve")"
fresh && touch "$TREE/labs/lecture04/point.cpp"
comes 'no picture was made'
rm -f "$IMAGES/point-check.png" && touch "$TREE/labs/lecture04/point.cpp"
check 'a picture, by a new program' until_true test -s "$IMAGES/point-check.png"
press q
ended 1

# Without a terminal: a log, which ends when all is right.
put labs point
"$BUILD/bin/fos_watch" --root "$TREE" --build "$COPY" --stage point </dev/null >"$WORK/screen" 2>&1 &
watch=$!
comes 'verdict in'
check 'a log has no keys' not shown 'q quit'
check 'a log has no colors' not shown $'\e'
put solutions point
wait "$watch"
check 'a log ends with 0' test $? == 0
check 'a log says the last verdict' shown 'Well done'
for arguments in '--stage nosuch' '--root' '--measure 0' ''; do
  # shellcheck disable=SC2086 # the arguments are words
  "$BUILD/bin/fos_watch" $arguments &>/dev/null
  check "wrong: $arguments" test $? == 2
done
finish
