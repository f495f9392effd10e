#!/usr/bin/env bash
# shipped.sh ROOT: the stubs that `./lab reset` brings back are those of labs, byte for byte. A stub
# that someone has begun to fill in is left alone.
. "${BASH_SOURCE[0]%/*}/stub.bash"
cd "$1" || exit 1
shipped=tests/check/shipped
broken=0
wrong() {
  echo "$*"
  broken=1
}

for stub in labs/lecture*/*.cpp; do
  copy=$shipped/${stub#labs/}
  if [[ ! -e $copy ]]; then
    wrong "$copy is missing"
  elif untouched "$stub"; then
    cmp "$stub" "$copy" || wrong "$stub and $copy differ"
  else
    echo "written: $stub"
  fi
done
for copy in "$shipped"/lecture*/*; do
  untouched "$copy" || wrong "$copy is no stub"
  [[ -e solutions/${copy#"$shipped"/} || -e labs/${copy#"$shipped"/} ]] || wrong "$copy is of no stage"
done
exit $broken
