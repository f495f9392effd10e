#!/usr/bin/env bash
# viewer_test.sh ROOT BUILD: the page of watch in a real browser, headless, while watch runs: what it
# shows, what a click and a key do, and that it follows each save. Needs chromium, chromedriver and
# python3, which drives them.
# shellcheck source=tests/watch/copied_tree.bash
source "$(dirname "$0")/copied_tree.bash" "$1" "$2"
export LC_ALL=C.UTF-8

# watch_in LANGUAGE: in the background, as a plain log.
watch_in() {
  FOS_LANG=$1 "$BUILD/bin/fos_watch" --root "$TREE" --build "$COPY" --stage point \
    </dev/null >"$WORK/screen" 2>&1 &
  WATCH=$!
  trap 'kill "$WATCH" 2>/dev/null; rm -rf "$WORK"' EXIT
}

make_tree point
file=$TREE/labs/lecture04/point.cpp
sed 's/light.position - P/P - light.position/' "$ROOT/solutions/lecture04/point.cpp" >"$file"
watch_in en
wait_for viewer.html || exit 1
url=$(grep -o 'file://.*viewer.html' "$WORK/screen")
wait_for 'verdict in' || exit 1
check "the page" python3 -B "$(dirname "$0")/viewer_test.py" "$url" "$file" \
  "$ROOT/solutions/lecture04/point.cpp" ${3:+"$3"}
kill "$WATCH" 2>/dev/null
wait "$WATCH"
finish
