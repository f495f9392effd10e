#!/usr/bin/env bash
# stub_fails.sh TEST PROGRAM SOURCE: an untouched stub fails every test case that asks for code.
# Exit status 77, which CTest shows as skipped, for a stub that someone has begun to fill in.
test=$1 program=$2 source=$3

. "${BASH_SOURCE[0]%/*}/../house/stub.bash"
if ! untouched "$source"; then
  echo "written: $source has code of its own, so it is no longer the stub that was shipped"
  exit 77
fi

summary=$(FOS_PROGRAM=$program "$test" '[code]' 2>&1 | grep '^test cases:')
echo "$summary"
[[ $summary =~ ^test\ cases:\ +([0-9]+)\ \|\ +([0-9]+)\ failed$ ]] &&
  [[ ${BASH_REMATCH[1]} == "${BASH_REMATCH[2]}" ]]
