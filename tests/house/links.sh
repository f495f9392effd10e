#!/usr/bin/env bash
# shellcheck disable=SC2016 # the backticks are Markdown's
# links.sh ROOT: every link and picture of the pages that stays in the project leads to something that
# is there, and every #anchor to a heading or an <a id> of that page. Anchors are made as forges make
# them: lower case, without punctuation, spaces as hyphens, a number behind one that is there already.
cd "$1" || exit 3
export LC_ALL=C.UTF-8
broken=0
wrong() {
  echo "$*"
  broken=1
}

# text PAGE: what is neither in a code block nor between backticks.
text() {
  sed -E '/^ *```/,/^ *```/d; /^    /d; s/`[^`]*`//g' "$1"
}

# anchors PAGE: as KNOWN[page#anchor].
declare -A KNOWN=()
anchors() {
  local line slug suffix count link='(.*)\[([^]]*)\]\([^)]*\)(.*)'
  [[ ${KNOWN[$1]-} ]] && return
  KNOWN[$1]=1
  while IFS= read -r line; do
    if [[ $line =~ ^'#'+' '(.*)$ ]]; then
      slug=${BASH_REMATCH[1],,}
      while [[ $slug =~ $link ]]; do # a link in a heading counts by its words
        slug=${BASH_REMATCH[1]}${BASH_REMATCH[2]}${BASH_REMATCH[3]}
      done
      slug=${slug//[^[:alnum:] _-]/}
      slug=${slug// /-}
      suffix='' count=0
      while [[ ${KNOWN[$1#$slug$suffix]-} ]]; do suffix=-$((++count)); done
      KNOWN[$1#$slug$suffix]=1
    fi
  done < <(sed '/^ *```/,/^ *```/d' "$1")
  while IFS= read -r line; do KNOWN[$1#$line]=1; done < <(
    grep -oE "<a (id|name)=[\"'][^\"']*" "$1" | sed -E "s/.*[\"']//"
  )
}

# check PAGE TARGET: the target of one link.
check() {
  local file=${2%%#*} path
  [[ $2 == *://* || $2 == mailto:* ]] && return
  if [[ $file == /* ]]; then
    wrong "$1: $2 does not begin at the page"
    return
  fi
  path=$1
  if [[ $file ]]; then
    path=$(realpath -m --relative-to=. -- "${1%/*}/$file")
    [[ $1 == */* ]] || path=$(realpath -m --relative-to=. -- "$file")
  fi
  if [[ $path == ../* || ! -e $path ]]; then
    wrong "$1: $2 is not there"
  elif [[ $2 == *'#'* && $path == *.md ]]; then
    anchors "$path"
    [[ ${KNOWN[$path#${2#*#}]-} ]] || wrong "$1: $path has no #${2#*#}"
  fi
}

pages=(README*.md)
[[ -d docs ]] && while IFS= read -r page; do pages+=("$page"); done < <(find docs -name '*.md' | sort)
for page in "${pages[@]}"; do
  while IFS= read -r target; do
    check "$page" "$target"
  done < <(text "$page" | grep -oE "\]\([^) ]+|(href|src)=[\"'][^\"']+" | sed -E "s/^(\]\(|(href|src)=[\"'])//" | sort -u)
done
exit $broken
