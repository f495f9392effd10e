#!/usr/bin/env bash
# site_test.sh ROOT [FOLDER]: the site that ./lab docs has made, in a real browser, headless; screenshots
# go to FOLDER. Then the same test before pages that are wrong, each of which it must find. Needs chromium,
# chromedriver and python3, which drives them.
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
site=$1/build/site
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
export LC_ALL=C.UTF-8 PYTHONPATH=$1/tests/watch FOS_SCREENSHOTS=${2-}

python3 -B "$here/site_test.py" "$site" || exit 1

# wrong WHAT FILE SCRIPT…: a copy whose FILE sed has changed does not pass.
missed=0
wrong() {
  rm -rf "$work/site" && cp -R "$site" "$work/site" && sed -i "${@:3}" "$work/site/$2" || exit 3
  ! cmp -s "$site/$2" "$work/site/$2" || { echo "nothing has changed: $1" && missed=1; }
  if FOS_SCREENSHOTS='' python3 -B "$here/site_test.py" "$work/site" en/stage-point.html >"$work/said" 2>&1; then
    echo "NOT FOUND: $1"
    missed=1
  else
    printf 'found: %s (%s)\n' "$1" "$(tail -n 1 "$work/said" | cut -c 1-100)"
  fi
}
page=en/stage-point.html
wrong "a picture that is not there" "$page" '0,/<img /s,src="[^"]*",src="../images/none.png",'
wrong "a picture without words" "$page" '0,/<img /s,alt="[^"]*",alt="",'
wrong "a request to another host" "$page" 's,</body>,<script src="http://127.0.0.1:9/x.js"></script></body>,'
wrong "a formula with a mistake" "$page" '0,/\\(/s,\\(,\\(\\frac{,'
wrong "arrows that are not seen" site.css 's/height: inherit/height: 0/'
wrong "a page wider than a phone" "$page" 's,</article>,<div style="width:600px">wide</div></article>,'
wrong "a link to nowhere" "$page" 's,</article>,<a href="none.html">x</a></article>,'
wrong "a link to no such place" "$page" 's,</article>,<a href="#none">x</a></article>,'
wrong "grey words" site.css '$ a p { color: #aaa }'
wrong "a page of another language" "$page" 's,<html lang="en",<html lang="el",'
wrong "the navigation on paper" site.css 's/display: none !important/display: block/'
exit "$missed"
