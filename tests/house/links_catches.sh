#!/usr/bin/env bash
# links_catches.sh: links.sh finds each kind of link that leads nowhere, and no other.
# shellcheck disable=SC2016 # the backticks are Markdown's
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0

mkdir -p "$tree"/docs/{en,el,images}
touch "$tree/docs/images/a.png"
cat >"$tree/docs/el/b.md" <<'EOF'
# Ο τύπος, και τα «όρια» του!

## Twice

## Twice

## [Words](b.md) & `code`

<a id='named'></a>
EOF

expect() { # expect STATUS LINE…: of a page with these lines
  printf '%s\n' "${@:2}" >"$tree/docs/el/a.md"
  "$here/links.sh" "$tree" >/dev/null
  [[ $? == "$1" ]] || { echo "links.sh: not status $1 for ${*:2}" && failed=1; }
}

echo '[docs](docs/el/b.md#named) ![a](docs/images/a.png)' >"$tree/README.md"
expect 0 '# A' '[page](b.md) [up](../../README.md) [own](#a) ![a](../images/a.png) [folder](../images)'
expect 0 '[Greek](b.md#ο-τύπος-και-τα-όρια-του) [second](b.md#twice-1) [mixed](b.md#words--code)'
expect 0 '[named](b.md#named) [elsewhere](https://example.org/no#such) <a href="b.md">b</a>'
expect 0 '`[code](none.md)`' '```' '[code](none.md)' '```' '' '    [code](none.md)'
expect 1 '[page](none.md)'
expect 1 '![picture](../images/none.png)'
expect 1 '[![picture](../images/none.png)](b.md)'
expect 1 '[![picture](../images/a.png)](none.html)'
expect 1 '<img src="none.png">'
expect 1 '[anchor](b.md#none)'
expect 1 '[third](b.md#twice-2)'
expect 1 '[own](#none)'
expect 1 '[case](b.md#Named)'
expect 1 '[from the root](/docs/el/b.md)'
expect 1 '[out of the project](../../../../etc/passwd)'
expect 1 '```' '# No heading' '```' '[own](#no-heading)'
echo '[docs](el/b.md)' >"$tree/README.md"
expect 1 'a link of README that is right from docs only'
exit $failed
