#!/usr/bin/env bash
# front_page.sh ROOT: the front page, in both languages, is short and names the commands that ./lab help
# lists, each of them and no other.
cd "$1" || exit 1
broken=0
wrong() {
  echo "$*"
  broken=1
}
listed=$(FOS_LANG=en ./lab help | sed -n 's/^  \([a-z]*\) .*/\1/p' | sort -u)
[[ $listed ]] || wrong "./lab help lists nothing"
for page in README.md README.el.md; do
  named=$(grep -o '\./lab [a-z]*' "$page" | cut -d ' ' -f 2 | sort -u)
  [[ $named == "$listed" ]] || wrong "$page and ./lab help do not name the same commands:" \
    "$(comm -3 <(echo "$named") <(echo "$listed") | tr -s '\t\n' ' ')"
  (($(wc -l <"$page") < 150)) || wrong "$page is longer than a front page"
done
exit $broken
