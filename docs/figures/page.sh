#!/usr/bin/env bash
# page.sh ROOT NAME PAGE MODULE.wasm…: puts the page of a figure together, one file that asks for no
# other: NAME.html with its style and scripts, the modules, the still picture and the words in both
# languages. page.sh ROOT --no-compiler: says why there is none here.
set -u -o pipefail
here=$1/docs/figures texts=$1/common/text name=$2

# words FILE KEY…: of the catalogue, whose entries have three lines, those whose key begins so; as
# JSON, for its strings are written as in C++.
words() {
  awk -v keys="^TEXT[(]($2)" '
    $0 ~ keys {
      sub(/^TEXT[(]/, ""); sub(/,$/, ""); key = $0
      getline english; sub(/^ *"/, "", english); sub(/",$/, "", english)
      getline greek; sub(/^ *"/, "", greek); sub(/"[)]$/, "", greek)
      printf "%s\"%s\": {\"en\": \"%s\", \"el\": \"%s\"}", comma, key, english, greek; comma = ",\n"
    }' "$texts/$1"
}
# word KEY LANGUAGE: one of figures.def.
word() { words figures.def "$1," | sed -E "s/.*\"$2\": \"([^\"]*)\".*/\1/"; }

if [[ $name == --no-compiler ]]; then
  language=${FOS_LANG:-${LC_ALL:-${LC_MESSAGES:-${LANG:-en}}}}
  [[ $language == el* ]] || language=en
  word figures_no_compiler "${language:0:2}" >&2
  exit 3
fi
page=$3
shift 3

# The catalogue of the mistakes, in its order: the tracer knows them by their number.
mistakes() {
  awk -F'[(,)]' '/^MISTAKE[(]/ {
      gsub(/[^A-Z]/, "", $4)
      printf "%s{\"id\": \"%s\", \"stages\": \"%s\"}", comma, $2, $4; comma = ",\n"
    }' "$here/../../tests/misconceptions/mistakes.inc"
}
# hash_of FILE: as a Content-Security-Policy has it.
hash_of() {
  local hex i
  hex=$(sha256sum <"$1")
  for ((i = 0; i < 64; i += 2)); do printf '%b' "\\x${hex:i:2}"; done | base64
}
# block ID TYPE: a script that is data; it reads the data.
block() { printf '<script id="%s" type="%s">\n%s\n</script>\n' "$1" "$2" "$(cat)"; }

work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
mkdir -p "${page%/*}" || exit 3
{ echo && cat "$here/figures.js" "$here/$name.js"; } >"$work/script" || exit 3
{ echo && cat "$here/figures.css"; } >"$work/style" || exit 3
still=$here/../images/figure-$name.png
cat "$still" "$here/$name.html" "$here/worker.js" "$texts/mistakes.def" "$@" >/dev/null || exit 3

head() {
  local policy="default-src 'none'; img-src data:; worker-src blob:;"
  policy+=" style-src 'sha256-$(hash_of "$work/style")';"
  policy+=" script-src 'sha256-$(hash_of "$work/script")' 'wasm-unsafe-eval'"
  printf '<meta http-equiv="Content-Security-Policy" content="%s">\n<style>' "$policy"
  cat "$work/style"
  echo '</style>'
}
body() {
  local language module
  echo '<noscript>'
  for language in en el; do
    printf '<h1 lang="%s">%s</h1>\n<p>%s</p>\n' "$language" \
      "$(word "figures_${name}_title" $language)" "$(word figures_still $language)"
  done
  printf '<img alt="" src="data:image/png;base64,%s">\n</noscript>\n' "$(base64 -w 0 "$still")"
  {
    printf '{'
    words figures.def "figures_"
    if [[ $name == mistakes ]]; then printf ',\n' && words mistakes.def "mistake_"; fi
    printf '}'
  } | block words application/json
  if [[ $name == mistakes ]]; then printf '[%s]' "$(mistakes)" | block mistakes application/json; fi
  for module; do
    base64 -w 0 "$module" | block "${module##*/}" text/plain
  done
  block worker text/plain <"$here/worker.js"
  printf '<script>'
  cat "$work/script"
  echo '</script>'
}
# What stands between `built without` and `end` is for who opens the source.
skip=''
while IFS= read -r line; do
  case $line in
    '<!-- head -->') head ;;
    '<!-- built without -->') skip=yes ;;
    '<!-- end -->') skip='' && body "$@" ;;
    *) [[ $skip ]] || printf '%s\n' "$line" ;;
  esac
done <"$here/$name.html" >"$page.new" && mv "$page.new" "$page" || exit 3
