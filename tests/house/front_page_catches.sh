#!/usr/bin/env bash
# front_page_catches.sh: front_page.sh finds a front page that is not ./lab's.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0

fresh() {
  # shellcheck disable=SC2016 # the backticks are Markdown's
  printf 'Run `./lab help`, and\n    ./lab render point\n' | tee "$tree"/README{,.el}.md >/dev/null
  printf '#!/bin/bash\necho Commands:\necho "  render [STAGE]  it"\necho "  help  it"\n' >"$tree/lab"
  chmod +x "$tree/lab"
}
expect() { # expect STATUS WHAT
  "$here/front_page.sh" "$tree" >/dev/null
  [[ $? == "$1" ]] || { echo "front_page.sh: not status $1 for $2" && failed=1; }
}

fresh && expect 0 'a page that agrees'
fresh && echo './lab fly' >>"$tree/README.md" && expect 1 'a command that is not there'
fresh && echo './lab fly' >>"$tree/README.el.md" && expect 1 'a command that is not there, in Greek'
fresh && echo 'echo "  check  it"' >>"$tree/lab" && expect 1 'a command that the page does not name'
fresh && yes | head -n 150 >>"$tree/README.md" && expect 1 'a long page'
fresh && echo exit >"$tree/lab" && expect 1 'a help that lists nothing'
exit $failed
