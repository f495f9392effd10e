#!/usr/bin/env bash
# data_is_current.sh FOS_MISTAKES DATA: the committed data are what the tracer makes, bit for bit.
made=$(mktemp -d) || exit 1
trap 'rm -rf "$made"' EXIT
"$1" data "$made" && diff -rq "$made" "$2"
