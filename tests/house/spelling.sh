#!/usr/bin/env bash
# shellcheck disable=SC2016 # the backticks are Markdown's
# spelling.sh ROOT: every word of the pages, and of what is said on the screen, is one of British
# English, of Greek, or of docs/words.txt. Code, links, mathematics, HTML, what has a digit in it, words
# of one or two letters and Greek capitals, which have no accents, are left out.
cd "$1" || exit 3
export LC_ALL=C.UTF-8
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT

# prose PAGE: what is to be read in it.
prose() {
  sed -E '/^ *```/,/^ *```/d; /^    /d; s/^\$\$.*\$\$//; /^\$\$/,/\$\$/d
    s/`[^`]*`/ /g; s/\$[^$]*\$/ /g; s/<[^>]*>/ /g; s/\]\([^)]*\)/] /g' "$1"
}

# said CATALOGUE: the texts in it, without what is a command, a file or a piece of code.
said() {
  sed -nE 's/^ +"(.*)"[,)]+$/\1/p' "$1" |
    sed -E 's/\\[n"]/ /g; s/\{[0-9]\}/ /g; s/[^ ]*[]_=<>{}@$/\\*+^|#&[][^ ]*/ /g; s/[^ ]*\.[^ ]+/ /g
      s/(^| )-[^ ]*/ /g'
}

# words: those of what it reads, a line each, as dictionaries have them: ό,τι without its comma, and
# without the second accent that a Greek word has before an enclitic.
words() {
  perl -CSD -Mutf8 -pe '
    tr/_/ /; s/([όΌ]),τι/$1τι/g; s/[\x{2019}\x{384}]/'\''/g; s/'\''s\b//g; s/\p{Greek}+'\''/ /g; s/\b\w*\d\w*\b/ /g; s/\b[Α-Ω]+\b/ /g
    ; s/\b(\w*[άέήίόύώ]\w*)([άέήίόύώ])([ςν]?)\b/$1 . $2 =~ tr{άέήίόύώ}{αεηιουω}r . $3/ge
    ; s/[^\w'\'']+/\n/g' | perl -CSD -ne 'print if /\w{3}/' | sort -u
}

mkdir "$work/files"
for file in README*.md docs/en/*.md docs/el/*.md common/text/*.def; do
  [[ $file == */texts.def ]] && continue # includes the others
  if [[ $file == *.def ]]; then said "$file"; else prose "$file"; fi |
    words >"$work/files/${file//\//:}"
  [[ -s $work/files/${file//\//:} ]] || { echo "$file: no words" && exit 3; }
done
# The Greek dictionary is in ISO 8859-7, and hunspell complains of each run in UTF-8.
{ echo wrogn && cat "$work"/files/*; } | sort -u |
  hunspell -l -i UTF-8 -d en_GB,el_GR -p docs/words.txt 2>"$work/trouble" >"$work/unknown"
if ! grep -qx wrogn "$work/unknown"; then # so that no word passes where nothing is looked up
  cat "$work/trouble"
  exit 3
fi
broken=0
while IFS= read -r word; do
  [[ $word == wrogn ]] && continue
  broken=1
  echo "$word: $(cd "$work/files" && grep -lwF -- "$word" * | tr ':\n' '/ ')"
done <"$work/unknown"
((broken)) && echo 'misspelt, or missing in docs/words.txt'
exit $broken
