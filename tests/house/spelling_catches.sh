#!/usr/bin/env bash
# spelling_catches.sh: spelling.sh finds a misspelt word wherever a person would read it, and in nothing
# else.
# shellcheck disable=SC2016 # the backticks and dollars are Markdown's
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0

# said STATUS WORD…: spelling.sh names these words and no other.
said() {
  local status=$1 out
  out=$("$here/spelling.sh" "$tree")
  [[ $? == "$status" ]] || { echo "not status $status: $out" && failed=1; }
  out=$(sed -n 's/: .*//p' <<<"$out" | LC_ALL=C.UTF-8 sort)
  [[ $out == "$(printf '%s\n' "${@:2}" | LC_ALL=C.UTF-8 sort)" ]] || { echo "not '${*:2}': $out" && failed=1; }
}

mkdir -p "$tree"/{docs/en,docs/el,common/text}
echo Fos >"$tree/docs/words.txt"
echo 'Light' | tee "$tree"/{README.el,docs/en/a}.md >"$tree/README.md"
printf '%s\n' 'TEXT(a_kye,' '     "of build/imgaes, with --soluton and {0}",' '     "το φως")' >"$tree/common/text/a.def"
cat >"$tree/docs/el/a.md" <<'EOF'
Το φως, το διάνυσμά του και ό,τι άλλο. The colour of the light, by Fos. ΑΥΤΟ

`kode` $kode + x$ <b class="kode">light</b> [light](kode.md) k0de

    kode

```
kode
```

$$
kode
$$
EOF
said 0

echo 'The ligth' >"$tree/README.md"
printf '%s\n' 'TEXT(a_key,' '     "the vicktor",' '     "το φοως")' >"$tree/common/text/a.def"
cat >>"$tree/docs/el/a.md" <<'EOF'

# A hedding

**blod** and a color that is not British, [lnik](a.md)

| light | tabel |

Η αντανάκλαζη.
EOF
said 1 ligth vicktor φοως hedding blod color lnik tabel αντανάκλαζη

rm "$tree/docs/words.txt"
said 1 Fos ligth vicktor φοως hedding blod color lnik tabel αντανάκλαζη
echo >"$tree/docs/el/a.md" # nothing to look up has not passed
"$here/spelling.sh" "$tree" >/dev/null
[[ $? == 3 ]] || { echo 'a page without words passes' && failed=1; }
exit $failed
