#!/usr/bin/env bash
# pages_are_current.sh FOS_MISTAKES DOCS: the pages on mistakes are what the catalogue makes, and each
# mistake has its picture.
docs=$2
made=$(mktemp -d) || exit 1
trap 'rm -rf "$made"' EXIT
mkdir "$made/en" "$made/el" && "$1" pages "$made" || exit 1
broken=0
for language in en el; do
  diff "$made/$language/mistakes.md" "$docs/$language/mistakes.md" || broken=1
done
while IFS= read -r picture; do
  [[ -s $docs/en/$picture ]] || { echo "there is no $picture" && broken=1; }
done < <(grep -oE '\.\./images/mistakes/[A-Za-z_0-9]+\.png' "$made/en/mistakes.md")
((broken)) && echo "cmake --build build/release --target mistakes_pages makes them anew"
exit $broken
