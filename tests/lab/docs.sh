#!/usr/bin/env bash
# `./lab docs`: what it sets up, what it hands to MkDocs, and that a site is there whole or not at all.
# shellcheck disable=SC2016,SC2317 # what the pretender expands; functions for `check`
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

LANGUAGE=(FOS_KATEX="$WORK/katex")
site() { echo "$TREE/build/site/$1"; }
settings() { [[ $(<"$TREE/build/site-parts/$1.yml") == *"$2"* ]]; }
tree_of_docs() {
  make_tree
  mkdir -p "$TREE/docs/images" "$WORK/katex/contrib" "$WORK/katex/fonts"
  cp -R "$SOURCE/docs/site" "$TREE/docs/"
  for language in en el; do
    mkdir -p "$TREE/docs/$language"
    touch "$TREE/docs/$language"/{start,lecture-04,stage-point,grading}.md
  done
  touch "$WORK/katex/"{katex.min.css,katex.min.js,contrib/auto-render.js,fonts/a.woff2}
  cat >"$STATE/stages" <<'EOT'
FOS_STAGES=(flat_color point)
declare -A FOS_STAGE_LECTURE=([flat_color]=3 [point]=4)
EOT
  pretend cmake <<'EOT'
[[ $1 == --version ]] && echo "cmake version 3.25.1" && exit
mkdir -p "$4" && touch "$4/build.ninja" && cp "$STATE/stages" "$4/stages.sh"
printf 'A:B=C\nCMAKE_HOME_DIRECTORY:INTERNAL=%s\nFOS_TESTS:BOOL=ON\n' "$2" >"$4/CMakeCache.txt"
EOT
  pretend mkdocs <<'EOT'
[[ ! -e $STATE/mkdocs-fails ]] || { echo "WARNING - what it says" && exit 1; }
name=${4##*/}
mkdir -p "${@: -1}/pages" && echo "$*" >"${@: -1}/pages/${name%.yml}"
EOT
}

make_tree
lab docs
check "a kit without it" status 2
tree_of_docs
lab docs
check "made" status 0
check "made: where it is" out "$(site index.html)"
check "made: with the figures" called 'ninja -C'
check "made: with the figures" called '-k 0 figures'
check "made: both languages" test -e "$(site pages/en)" -a -e "$(site pages/el)" -a -e "$(site index.html)"
check "made: a warning is an error" called 'build --strict'
check "its own language" settings el 'language: el'
check "its own name" settings el "site_name: 'Fos: το φως"
check "the tree has spaces" settings en "docs_dir: '$TREE/build/site-parts/en'"
check "a lecture before its stages" settings en $'- en/lecture-04.md\n    - en/stage-point.md'
check "pages that are not there are not asked for" not settings en stage-flat_color
check "nothing is installed" not called apt-get

echo old >"$(site index.html)"
touch "$STATE/mkdocs-fails"
lab docs
check "it does not build" status 1
check "it does not build: its words" err 'what it says'
check "it does not build: the old site stays" test "$(<"$(site index.html)")" == old
rm "$STATE/mkdocs-fails"
echo figures >"$STATE/broken"
lab docs
check "no figures" status 3
check "no figures: the old site stays" test "$(<"$(site index.html)")" == old
rm "$STATE/broken"
lab docs more
check "a word too many" status 2
lab --lang el docs more
check "a word too many, in Greek" err 'δεν παίρνει'
rm -r "$WORK/katex"
lab docs
check "no KaTeX" status 3
check "no KaTeX" err "$WORK/katex"
rm "$STATE/installed-mkdocs"
lab docs
check "it is installed" called 'install -y --no-remove --no-install-recommends mkdocs'
finish
