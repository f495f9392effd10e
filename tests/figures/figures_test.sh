#!/usr/bin/env bash
# figures_test.sh ROOT BUILD [FOLDER]: the live figures in a real browser, headless: what they show is,
# byte for byte, what native programs of the same sources make, and at the beginning what
# ./lab render makes. Screenshots go to FOLDER. Needs chromium, chromedriver and python3.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
export LC_ALL=C.UTF-8

"$2/bin/fos_picture" render --scene "$1/labs/scenes/lecture.scene" --images "$work" \
  --output "$work/lecture.png" "combined:combined:$2/bin/solution_combined" >/dev/null &&
  oiiotool "$work/lecture.png" -o "$work/lecture.ppm" || exit 1
for line in '' '0 0 600' '0 0 600 600 -1 0 0 0.2 255 255 255' 'one two'; do
  echo "$line" | "$2/bin/figure_combined" >/dev/null 2>&1
  [[ $? == 2 ]] || { echo "these are no figure, and it says nothing: '$line'" && exit 1; }
done
PYTHONPATH=$1/tests/watch python3 -B "$here/figures_test.py" "$2" "$work/lecture.ppm" ${3:+"$3"}
