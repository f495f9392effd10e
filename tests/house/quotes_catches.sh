#!/usr/bin/env bash
# quotes_catches.sh: quotes.sh finds each way in which a quote drifts from what it quotes, and --write
# puts it right. The programs pretend.
# shellcheck disable=SC2016 # the backticks are Markdown's
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d) || exit 3
trap 'rm -rf "$tree"' EXIT
failed=0

mkdir -p "$tree"/{bin,docs/en,docs/el,labs/lecture04,tests/check/shipped/lecture04}
printf '%s\n' '// f is not here' 'struct fine {' '  int f;' '};' '' 'int f(int x) {' '  return x;' '}' 'int g() {' '}' \
  >"$tree/code.hpp"
echo 'filled in' >"$tree/labs/lecture04/point.cpp"
echo 'the stub' >"$tree/tests/check/shipped/lecture04/point.cpp"
cat >"$tree/bin/fos_explain" <<'EOF'
#!/bin/sh
printf '%s\n' "$FOS_LANG $2" '' 'a' 'b' '' "${5-} $6"
EOF
cat >"$tree/bin/fos_check" <<'EOF'
#!/bin/sh
echo "$FOS_LANG ${7##*/} in $4"
EOF
cat >"$tree/bin/fos_picture" <<'EOF'
#!/bin/sh
echo "$FOS_LANG: $(cat my.scene)" >&2
exit 2
EOF
chmod +x "$tree"/bin/*

quote() { # quote LANGUAGE MARK LINE…: a page with this mark over a block of these lines
  rm -f "$tree"/docs/*/a.md
  page=$tree/docs/$1/a.md
  { printf '# A\n\n<!-- %s -->\n```cpp\n' "$2" && printf '%s\n' "${@:3}" && printf '```\nend\n'; } >"$page"
}
expect() { # expect STATUS
  "$here/quotes.sh" "$tree" "$tree/bin" >"$tree/said"
  [[ $? == "$1" ]] || { echo "quotes.sh: not status $1 for $(cat "$page"): $(cat "$tree/said")" && failed=1; }
}
right() { # it agrees; with a line more, or less, it does not; --write brings it back
  quote "$@" && expect 0
  cp "$page" "$tree/right"
  quote "$@" 'a line more' && expect 1
  quote "${@:1:$#-1}" && expect 1
  "$here/quotes.sh" "$tree" "$tree/bin" --write >/dev/null && cmp "$page" "$tree/right" || failed=1
}

right en 'from code.hpp: f' 'int f(int x) {' '  return x;' '}'
right en 'from code.hpp: fine' 'struct fine {' '  int f;' '};'
right en 'from labs/lecture04/point.cpp' 'the stub'
right en 'run: explain point 1 2 2-3' a b '' '1 2'
right el 'run: explain point 1 2 1-1' 'el point'
right el 'run: check point' 'el solution_point in build/images'
right en 'run: check point wrong' 'en submission_point_wrong in build/images'
right en 'run: read light { }' 'en: light { }'
quote en 'from code.hpp: none' 'x' && expect 1
quote en 'from none.hpp' 'x' && expect 1
quote en 'run: dance point' 'x' && expect 1
quote en 'a remark' 'x' && sed -i 's/```cpp/```/' "$page" && expect 0
quote en 'a remark' 'x' && sed -i '/^<!--/d' "$page" && expect 1
printf '<!-- from code.hpp -->\nno block\n' >"$page" && expect 1
printf '```\n<!-- from none.hpp -->\n```\n' >"$page" && expect 0
exit $failed
