#!/usr/bin/env bash
# data_is_current.sh FOS_MISTAKES DATA: the committed data are what the tracer makes, bit for bit, and
# under 2 MiB.
made=$(mktemp -d) || exit 1
trap 'rm -rf "$made"' EXIT
"$1" data "$made" && diff -rq "$made" "$2" || exit 1
size=$(cat "$made"/* | wc -c)
((size < 2 * 1024 * 1024)) || { echo "the data have $size bytes" && exit 1; }
