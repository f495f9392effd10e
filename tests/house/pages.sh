#!/usr/bin/env bash
# pages.sh ROOT: every page exists in both languages, with the same headings, pictures, quotes and
# questions.
cd "$1" || exit 1
broken=0
wrong() {
  echo "$*"
  broken=1
}
# headings FILE: their levels, in order.
headings() { awk '/^```/ { code = !code } !code && /^#+ / { print $1 }' "$1"; }
# shown FILE: its pictures, what it quotes, its questions, in order.
shown() {
  grep -oE '\]\((docs/|\.\./)images/[^)]*|^<!-- (from|run:) .*|^<details' "$1" | sed 's/-el\.png$/.png/'
}

for page in README.md docs/en/*.md; do
  twin=docs/el/${page##*/}
  [[ $page == README.md ]] && twin=README.el.md
  if [[ ! -e $twin ]]; then
    wrong "$page has no Greek twin, $twin"
  elif [[ $(headings "$page") != "$(headings "$twin")" ]]; then
    wrong "$page and $twin do not have the same headings"
  elif [[ $(shown "$page") != "$(shown "$twin")" ]]; then
    wrong "$page and $twin do not show the same"
  fi
done
for page in docs/el/*.md; do
  [[ -e docs/en/${page##*/} ]] || wrong "$page has no English twin"
done

exit $broken
