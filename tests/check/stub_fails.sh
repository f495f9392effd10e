#!/usr/bin/env bash
# stub_fails.sh STAGE BIN SOURCE: an untouched stub does nothing of what is asked. Exit status 77, which
# CTest shows as skipped, for a stub that someone has begun to fill in.
stage=$1 bin=$2 source=$3

. "${BASH_SOURCE[0]%/*}/../house/stub.bash"
if ! untouched "$source"; then
  echo "written: $source has code of its own, so it is no longer the stub that was shipped"
  exit 77
fi
FOS_STAGE=$stage FOS_PROGRAM=$bin/lab_$stage "$bin/stage_under_test" '[stub]'
