#!/usr/bin/env bash
# report_test.sh ROOT BUILD [FOLDER]: the reports of a class in a real browser, headless, with hostile
# names and words among the students'; screenshots go to FOLDER. Needs chromium, chromedriver and
# python3, which drives them.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
export LC_ALL=C.UTF-8

# Past 144 every hostile text has been someone's name.
for language in en el; do
  FOS_LANG=$language "$2/bin/fos_example_report" "$work/$language" 150 || exit 1
done
for count in 0 1 5; do FOS_LANG=en "$2/bin/fos_example_report" "$work/$count" "$count" || exit 1; done
PYTHONPATH=$1/tests/watch python3 -B "$here/report_test.py" "$work" ${3:+"$3"}
