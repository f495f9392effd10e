#!/usr/bin/env bash
# shipped_catches.sh: shipped.sh finds each way in which a shipped stub may be wrong.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0
stub=$tree/labs/lecture04/a.cpp copy=$tree/tests/check/shipped/lecture04/a.cpp

fresh() {
  rm -rf "${tree:?}"/*
  mkdir -p "${stub%/*}" "${copy%/*}"
  printf '%s\n' 'Real f() {' '  // --- your code starts here ---' '  return unwritten("f");' \
    '  // --- your code ends here ---' '}' | tee "$stub" >"$copy"
}
expect() {  # expect STATUS WHAT
  "$here/shipped.sh" "$tree" &>/dev/null
  [[ $? == "$1" ]] || { echo "shipped.sh: not status $1 for $2" && failed=1; }
}

fresh && expect 0 'the same'
fresh && echo >>"$stub" && expect 1 'a changed stub'
fresh && rm "$copy" && expect 1 'a missing copy'
fresh && cp "$copy" "${copy%a.cpp}b.cpp" && expect 1 'a copy of nothing'
fresh && sed -i 's/return.*/return 2;/' "$stub" && expect 0 'a written stub'
sed -i 's/return.*/return 2;/' "$copy" && expect 1 'a copy with code'
exit $failed
