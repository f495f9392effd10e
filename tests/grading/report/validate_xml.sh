#!/usr/bin/env bash
# validate_xml.sh BIN: the JUnit files of a class with hostile names, against the format's schema.
command -v xmllint >/dev/null || { echo "NOT RUN: xmllint is not here" && exit 77; }
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
folder=$(mktemp -d) || exit 3
trap 'rm -rf "$folder"' EXIT
validate() { xmllint --noout --nonet --schema "$here/junit.xsd" "$@"; }

FOS_LANG=en "$1/fos_example_report" "$folder" 150 >/dev/null || exit 1
validate "$folder"/submissions/*/junit.xml >"$folder/words" 2>&1 ||
  { grep -v ' validates$' "$folder/words" | head -n 20 && exit 1; }
validate "$here"/golden/junit*.xml || exit 1

# A file that is not as it should be is found.
sed 's/ tests="/ test="/' "$here/golden/junit.xml" >"$folder/wrong.xml"
! validate "$folder/wrong.xml" 2>/dev/null
