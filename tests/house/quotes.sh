#!/usr/bin/env bash
# quotes.sh ROOT BIN [--write]: what a page shows of our code and our programs is what they are. A code
# block below one of these marks must equal what the mark names; --write makes it so. C++ has a mark.
#   <!-- from FILE -->                      the whole file
#   <!-- from FILE: NAME -->                its function or struct NAME
#   <!-- run: explain STAGE C R A-B -->     what is right at that pixel of the lecture's scene, of
#                                           explain's paragraphs those from A to B
#   <!-- run: check STAGE [SUBMISSION] -->  what check says of the solution, or of that file in
#                                           tests/misconceptions/submissions
#   <!-- run: read TEXT -->                 what is said of a scene file with this text
# Programs speak the language of the page.
root=$1 write=${3-}
bin=$(cd "$2" && pwd) || exit 3
shipped=tests/check/shipped # the stubs: those in labs may be filled in
cd "$root" || exit 3
work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
export LC_ALL=C.UTF-8
broken=0

# item FILE NAME: from the first line at the margin that has the word NAME to the next `}` there.
item() {
  awk -v name="$2" '
    !inside && /^[A-Za-z]/ && $0 ~ "(^|[^A-Za-z_])" name "([^A-Za-z_]|$)" { inside = 1 }
    inside
    inside && /^}/ { exit }' "$1" 2>/dev/null
}

# paragraphs A-B: those of what it reads.
paragraphs() {
  awk -v RS= -v from="${1%-*}" -v to="${1#*-}" '
    NR >= from && NR <= to { printf "%s%s\n", gap, $0; gap = "\n" }'
}

# quoted MARK: what the mark names.
quoted() {
  local words file
  read -ra words <<<"$1"
  case $1 in
    'from '*': '*)
      file=${1#from }
      item "$(source_of "${file%: *}")" "${file##*: }"
      ;;
    'from '*) cat "$(source_of "${1#from }")" 2>/dev/null ;;
    'run: explain '*)
      "$bin/fos_explain" --stage "${words[2]}" --scene labs/scenes/lecture.scene "${words[@]:3:2}" \
        >"$work/said" || return
      paragraphs "${words[5]}" <"$work/said"
      ;;
    'run: check '*)
      file=$bin/solution_${words[2]}
      [[ ${words[3]-} ]] && file=$bin/submission_${words[2]}_${words[3]}
      "$bin/fos_check" --root . --images "$work" --picture "$bin/fos_picture" "${words[2]}=$file" |
        sed "s|$work|build/images|"
      ;;
    'run: read '*)
      printf '%s\n' "${1#run: read }" >"$work/my.scene"
      (cd "$work" && "$bin/fos_picture" render --scene my.scene --images . \
        "point:point:$bin/solution_point" 2>&1)
      ;;
  esac
}

# source_of FILE: a stage of labs as it was shipped.
source_of() {
  if [[ $1 == labs/lecture* ]]; then echo "$shipped/${1#labs/}"; else echo "$1"; fi
}

# renewed PAGE: with each marked block as it should be.
renewed() {
  local line mark='' code='' skip=''
  while IFS= read -r line; do
    if [[ $code ]]; then # inside a block
      [[ $line == '```' ]] && code=''
      [[ $skip && $code ]] || printf '%s\n' "$line"
    elif [[ $line == '```'* ]]; then
      printf '%s\n' "$line"
      code=1 skip=$mark
      [[ $line == '```cpp' && ! $mark ]] && echo "$1: code of its own, without a mark" >>"$work/wrong"
      if [[ $mark ]]; then
        quoted "$mark" >"$work/quote"
        [[ -s $work/quote ]] || echo "$1: nothing is '$mark'" >>"$work/wrong"
        cat "$work/quote"
      fi
      mark=''
    else
      [[ $mark ]] && echo "$1: no code block below '$mark'" >>"$work/wrong"
      mark=''
      [[ $line =~ ^'<!-- '((from|run:)' '.*)' -->'$ ]] && mark=${BASH_REMATCH[1]}
      printf '%s\n' "$line"
    fi
  done <"$1"
}

: >"$work/wrong"
for page in README.md README.el.md docs/en/*.md docs/el/*.md; do
  [[ -e $page ]] || continue
  grep -qE '^(<!-- (from|run:) |```cpp)' "$page" || continue
  FOS_LANG=en
  [[ $page == *.el.md || $page == docs/el/* ]] && FOS_LANG=el
  export FOS_LANG
  renewed "$page" >"$work/page"
  cmp -s "$work/page" "$page" && continue
  if [[ $write ]]; then
    cp "$work/page" "$page.new" && mv "$page.new" "$page" || exit 3
  else
    diff -u --label "$page" --label 'as it is' "$page" "$work/page"
    broken=1
  fi
done
cat "$work/wrong"
[[ -s $work/wrong ]] && broken=1
exit $broken
