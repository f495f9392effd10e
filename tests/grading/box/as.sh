#!/usr/bin/env bash
# as.sh root|user PROGRAM ARGUMENT…: runs the program as root, or as somebody who is not; where that
# is not to be had it says NOT RUN.
who=$1
shift
case $who:$(id -u) in
  root:0) exec "$@" ;;
  user:0) TMPDIR=/tmp exec setpriv --reuid=61000 --regid=61000 --clear-groups "$@" ;;
  user:*) exec "$@" ;;
  *) echo "NOT RUN: this is not root" ;;
esac
