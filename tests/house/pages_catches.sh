#!/usr/bin/env bash
# pages_catches.sh: pages.sh finds each rule of the pages broken, one at a time.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0

fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "$tree"/docs/{en,el}
  printf '# A\n\n## B\n' | tee "$tree"/{README,README.el}.md >/dev/null
  # shellcheck disable=SC2016 # the backticks are Markdown's
  printf '# A\n\n```\n# no heading\n```\n' | tee "$tree"/docs/{en,el}/a.md >/dev/null
}
expect() {  # expect STATUS WHAT
  "$here/pages.sh" "$tree" >/dev/null
  [[ $? == "$1" ]] || { echo "pages.sh: not status $1 for $2" && failed=1; }
}

fresh && expect 0 'pages that agree'
fresh && rm "$tree/docs/el/a.md" && expect 1 'a page in English only'
fresh && rm "$tree/docs/en/a.md" && expect 1 'a page in Greek only'
fresh && echo '## C' >>"$tree/docs/el/a.md" && expect 1 'a heading in one language only'
for shown in '![a](../images/a.png)' '<!-- from code.hpp -->' '<details markdown>'; do
  fresh && echo "$shown" >>"$tree/docs/el/a.md" && expect 1 "$shown in one language only"
  fresh && echo "$shown" | tee -a "$tree"/docs/{en,el}/a.md >/dev/null && expect 0 "$shown in both"
done
fresh && echo '![a](../images/a.png)' >>"$tree/docs/en/a.md" && echo '![α](../images/a-el.png)' >>"$tree/docs/el/a.md" &&
  expect 0 'a picture with words, in each language'
exit $failed
