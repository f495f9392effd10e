#!/usr/bin/env bash
# ./lab and what a person types: help, languages, and every wrong command, option and value.
# shellcheck disable=SC2016,SC2317 # what must not be expanded; functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

make_tree

lab
check "no argument is help" status 0
check "help lists the commands" out 'render [STAGE'
plain=$OUT
lab help
check "help is help" test "$OUT" == "$plain"
lab --help
check "--help is help" test "$OUT" == "$plain"
lab render -h
check "a command's -h" status 0
check "a command's help names its options" out --precision
lab help test
check "help about one command says nothing of others" not out --precision
lab help nosuch
check "help about nothing" status 2

rm -r "$TREE/tests"
lab
check "a kit without tests has no test" not out 'test ['
check "a kit without tests checks nothing" not out 'check ['
lab test
check "a kit without tests runs none" status 2
lab trade
check "a kit without tests measures nothing" status 2
lab explain point 3 4
check "a kit without tests explains nothing" status 2
make_tree

# wrong WHAT-STDERR-MUST-NAME ARGUMENT…: one line of error, status 2, and nothing is made.
wrong() {
  lab "${@:2}"
  check "wrong: ${*:2}" status 2
  check "wrong: ${*:2}" err "$1"
  check "wrong: ${*:2}" one_line_of_error
  check "wrong: ${*:2}" nothing_built
  check "wrong: ${*:2}" not test -e "$STATE/calls"
}
touch "$WORK/unreadable" && mkdir -p "$WORK/folder.png" "$WORK/folder.zip"
wrong "did you mean 'render'" rendr
wrong "'nonsense' (there is: render check watch hint explain reset submit test trade help)" nonsense
wrong "'render test'" 'render test'
wrong "''" ''
wrong 'a{0}&\{1}*$(x)' 'a{0}&\{1}*$(x)'
wrong "did you mean '--size'" render --sise 3x3
wrong "did you mean '--size'" render --sise=3x3
wrong "'--nonsense=3'" render --nonsense=3
wrong "'--solution=yes'; did you mean '--solution'" render --solution=yes
wrong "did you mean 'point'" render pont
wrong "flat_color ambient point" render nosuch
wrong "there is no stage ''" render ''
wrong "'*'" render '*'
wrong "'../labs'" render ambient ../labs
wrong "'--scene'" render --scene
wrong "'nosuch.scene'" render --scene nosuch.scene
wrong "''" render --scene=
wrong "folder" render --scene "$TREE"
for size in 3 3x 0x3 3x0 16385x1 1x16385 -3x3 3x3x3 3.5x3 ' 3x3' 99999999999999999999x1 ''; do
  wrong "'$size'" render "--size=$size"
done
wrong "'--size'" render --size
wrong "'half'" render --precision half
wrong "did you mean 'double'" render --precision duble
wrong "'\$(touch x)'" render --precision '$(touch x)'
wrong "one stage" render --output x.png
wrong "one stage" render point ambient --output x.png
wrong "'x.jpg'" render point --output x.jpg
wrong "'x'" render point --output x
wrong "''" render point --output=
wrong "'.png'" render point --output .png
wrong "'folder.png'" render point --output folder.png
wrong "'no/such/'" render point --output no/such/x.png
for command in check watch hint reset; do
  wrong "did you mean 'point'" "$command" pont
  wrong "there is no stage ''" "$command" ''
  wrong "'--nonsense'" "$command" --nonsense
  wrong "'../labs'" "$command" ../labs
done
for command in watch hint reset; do
  wrong "one of flat_color ambient point" "$command"
  wrong "one of flat_color ambient point" "$command" point ambient
done
wrong "'pont'" check ambient pont
wrong "did you mean '--reset'" hint point --rest
wrong "do not go together" hint point --all --reset
wrong "'point'" submit point
wrong "did you mean '--output'" submit --outptu x.zip
wrong "'--output'" submit --output
wrong "'x.tar'" submit --output x.tar
wrong "'.zip'" submit --output=.zip
wrong "'no/such/'" submit --output no/such/x.zip
wrong "'folder.zip'" submit --output folder.zip
wrong "needs a stage, a column and a row" explain
wrong "needs a stage, a column and a row" explain point
wrong "needs a stage, a column and a row" explain point 3
wrong "needs a stage, a column and a row" explain point 3 4 5
wrong "did you mean 'point'" explain pont 3 4
wrong "there is no stage '3'" explain 3 4
wrong "there is no stage ''" explain '' 3 4
for number in -3 3.5 x '' ' 3' 3x4 0x10 99999999999 '$(touch x)'; do
  wrong "'$number'" explain point "$number" 4
  wrong "'$number'" explain point 4 "$number"
done
wrong "did you mean '--scene'" explain point 3 4 --scen x.scene
wrong "'--nonsense'" explain --nonsense point 3 4
wrong "'--scene'" explain point 3 4 --scene
wrong "'nosuch.scene'" explain point 3 4 --scene nosuch.scene
wrong "folder" explain point 3 4 --scene "$TREE"
wrong "did you mean '--scene'" trade --scen x.scene
wrong "did you mean '--plot'" trade --plt=x.png
wrong "'--nonsense'" trade --nonsense
wrong "did you mean 'point'" trade pont
wrong "flat_color ambient point" trade nosuch
wrong "there is no stage ''" trade ''
wrong "one stage at a time" trade point ambient
wrong "'--scene'" trade --scene
wrong "'nosuch.scene'" trade --scene nosuch.scene
wrong "folder" trade --scene "$TREE"
wrong "'--csv'" trade --csv
wrong "'x.txt'" trade --csv x.txt
wrong "'.csv'" trade --csv .csv
wrong "''" trade --csv=
wrong "'no/such/'" trade --csv no/such/x.csv
wrong "'x.jpg'" trade --plot x.jpg
wrong "'.svg'" trade --plot=.svg
wrong "'folder.png'" trade --plot folder.png
wrong "'no/such/'" trade --plot no/such/x.png
wrong "did you mean '--growth'" trade --grwth
wrong "two studies" trade --plan --growth
wrong "'--csv' says nothing to 'trade --plan'" trade --plan --csv x.csv
wrong "'point' says nothing" trade point --plan
wrong "'--scene' says nothing to 'trade --growth'" trade --growth --scene "$TREE/labs/scenes/lecture.scene"
wrong "'--plot' says nothing" trade --extremes --plot x.png
wrong "'everything'" test everything
wrong "'all all'" test all all
wrong "'fr'" render --lang fr
wrong "'--lang'" render --lang
rm -r "$TREE/solutions"
wrong "no solutions" render --solution
wrong "no solutions" trade --extremes
make_tree

# Languages: the option, wherever it stands, before FOS_LANG, LC_ALL, LC_MESSAGES and LANG.
greek() { err 'δεν υπάρχει στάδιο'; }
lab --lang el render nosuch
check "--lang first" greek
lab render nosuch --lang=el
check "--lang last" greek
lab --lang=el
check "help in Greek" out 'ΕΝΤΟΛΗ'
LANGUAGE=(LANG=el_GR.UTF-8) && lab render nosuch
check "LANG" greek
check "Greek, status" status 2
LANGUAGE=(LANG=el_GR.UTF-8 LC_MESSAGES=C) && lab render nosuch
check "LC_MESSAGES before LANG" not greek
LANGUAGE=(LC_ALL=C LC_MESSAGES=el_GR) && lab render nosuch
check "LC_ALL before LC_MESSAGES" not greek
LANGUAGE=(LC_ALL='' LANG=el) && lab render nosuch
check "an empty LC_ALL is none" greek
LANGUAGE=(FOS_LANG=en LANG=el_GR.UTF-8) && lab render nosuch
check "FOS_LANG before LANG" not greek
LANGUAGE=(FOS_LANG=en LC_ALL=el_GR.UTF-8) && lab render nosuch
check "FOS_LANG before LC_ALL" not greek
LANGUAGE=(FOS_LANG=el) && lab --lang en render nosuch
check "--lang before FOS_LANG" not greek
LANGUAGE=()

# From elsewhere, by a link.
ln -s "$TREE/lab" "$WORK/link to lab"
(cd / && PATH="$WORK/bin" "$WORK/link to lab" help) >"$WORK/out" 2>&1
OUT=$(<"$WORK/out")
check "by a link" out 'render [STAGE'

finish
