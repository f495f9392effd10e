#!/usr/bin/env bash
# twins_catches.sh: twins.sh finds each rule of the stubs broken, one at a time.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0
stub=$tree/labs/lecture04/a.cpp solution=$tree/solutions/lecture04/a.cpp

fresh() {
  mkdir -p "${stub%/*}" "${solution%/*}"
  printf '%s\n' 'Real f() {' '  // --- your code starts here ---' '  // TODO: do it' \
    '  return unwritten("f");' '  // --- your code ends here ---' '}' >"$stub"
  sed 's/return unwritten("f")/return 1/; /TODO/d' "$stub" >"$solution"
}
expect() {  # expect STATUS WHAT
  "$here/twins.sh" "$tree" &>/dev/null
  [[ $? == "$1" ]] || { echo "twins.sh: not status $1 for $2" && failed=1; }
}

fresh && expect 0 'twins'
fresh && sed -i 's/Real f/float f/' "$stub" && expect 1 'a difference outside the holes'
fresh && sed -i '/TODO/d' "$stub" && expect 1 'a hole without a TODO'
fresh && echo '// --- your code ends here ---' | tee -a "$stub" >>"$solution" && expect 1 'a second end'
fresh && cp "$stub" "$solution" && expect 1 'an unfilled solution'
fresh && rm "$solution" && expect 1 'a missing solution'
fresh && yes '// line' | head -80 | tee -a "$stub" >>"$solution" && expect 1 'a file of two screens'
fresh && sed -i 's/return unwritten("f")/return 2/; s/Real/float/' "$stub" && expect 0 'a written stub'
rm "$stub" "$solution" && expect 1 'no stubs at all'
exit $failed
