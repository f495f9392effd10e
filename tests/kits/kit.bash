# `./lab kit student|instructor --lecture N`: the zip to hand out. Sourced by ./lab, whose words and options
# it uses, and pack.bash. What goes in is said in files.txt alone; git is not asked, so a kit can be made
# in a kit.

# kit_course AUDIENCE --lecture N [--output F.zip]
kit_course() {
  local audience=$1 lecture='' output='' known=() folder name
  shift
  while (($#)); do
    TOOK=1
    case $1 in
      --lecture | --lecture=*) take "$@" && lecture=$VALUE ;;
      --output | --output=*) take "$@" && output=$VALUE && kit_place "$output" ;;
      *) require lab_unknown_option "$1" --lecture --output --lang ;;
    esac
    shift "$TOOK"
  done
  for folder in "$ROOT"/tests/check/shipped/lecture*/; do
    folder=${folder%/} && known+=("$((10#${folder##*lecture}))")
  done
  [[ $lecture ]] || fail 2 lab_kit_which_lecture "$audience" "${known[*]}"
  [[ $lecture =~ ^0*([1-9][0-9]{0,3})$ ]] && lecture=${BASH_REMATCH[1]}
  require lab_kit_no_lecture "$lecture" "${known[@]}"
  name=fos-$audience-lecture-$lecture

  set_up build
  begin_kit "$name" "$output"
  if ! fill_kit "$KIT/$name" || ! end_kit; then fail 3 lab_kit_fails "$KIT_ZIP"; fi
}

# fill_kit FOLDER: the tree that is to be in the zip. The stages are stubs, whatever stands in labs.
fill_kit() {
  local page file list=()
  local -A WORDS=() CHOSEN=()
  mkdir -p "$1" || return
  cmake -D STAGES="$ROOT/labs/stages.json" -D LECTURE="$lecture" -D OUTPUT="$1" \
    -P "$ROOT/tests/kits/cut_stages.cmake" || return
  # shellcheck source=/dev/null
  source "$1/kit.sh" && rm "$1/kit.sh" && choose_files || return
  for page in "${!CHOSEN[@]}"; do
    [[ $page == *.md ]] || continue
    if [[ $audience == instructor ]] && shows_later "$page"; then
      unset 'CHOSEN[$page]'
    else
      choose_pictures "$page"
    fi
  done
  list=("${!CHOSEN[@]}")
  (cd "$ROOT" && cp --parents -- "${list[@]}" "$1") &&
    mv "$1/stages.json" "$1/labs/stages.json" || return
  for file in ${WORDS[file]}; do
    mkdir -p "$1/labs/${file%/*}" && cp "$ROOT/tests/check/shipped/$file" "$1/labs/$file" || return
  done
  if [[ $audience == student || ${WORDS[later]} ]]; then cp "$ROOT"/tests/kits/student/README*.md "$1" || return; fi
  for page in "$1"/*.md "$1"/docs/*/*.md; do
    if [[ -e $page ]]; then without_dead_links "$page" || return; fi
  done
}

# choose_files: CHOSEN, from the section of files.txt for this audience.
choose_files() {
  local line section='' least
  while read -r line; do
    case $line in
      '' | '#'*) continue ;;
      '['*) section=$line && continue ;;
    esac
    [[ $section == "[$audience]" ]] || continue
    if [[ $line =~ ^([0-9]+)\+\ +(.*) ]]; then
      least=${BASH_REMATCH[1]} line=${BASH_REMATCH[2]}
      ((lecture >= least)) || continue
    elif [[ $line == 'newest '* ]]; then
      [[ -z ${WORDS[later]} ]] || continue
      line=${line#newest }
    fi
    choose_pattern "$line"
  done <"$ROOT/tests/kits/files.txt"
}

# choose_pattern PATTERN: once for each of the WORDS that it names.
choose_pattern() {
  local name word path
  if [[ $1 =~ \{([a-z_]+)\} ]]; then
    name=${BASH_REMATCH[1]}
    for word in ${WORDS[$name]?a word that files.txt does not explain}; do
      choose_pattern "${1//"{$name}"/$word}"
    done
    return
  fi
  # shellcheck disable=SC2086 # the pattern is to be expanded
  while IFS= read -r path; do
    if [[ ! $path ]]; then # nothing is of this pattern
      continue
    elif [[ $1 == '!'* ]]; then
      unset 'CHOSEN[$path]'
    elif [[ -f $ROOT/$path ]]; then
      CHOSEN[$path]=yes
    fi
  done < <(cd "$ROOT" && shopt -s globstar nullglob dotglob && IFS='' && printf '%s\n' ${1#!})
}

# shows_later PAGE: it quotes a stage that comes after the lecture, or what one gives. Students may read
# ahead; but where the tests of the pages are, what a page quotes must be there.
shows_later() {
  local mark stage
  while IFS= read -r mark; do
    [[ $mark == '<!-- '* ]] || continue
    for stage in ${WORDS[later]}; do
      case $mark in *[\ /]"$stage"[\ .]*) return 0 ;; esac
    done
  done <"$ROOT/$1"
  return 1
}

# choose_pictures PAGE: what of docs/images it shows.
choose_pictures() {
  local words picture
  words=$(<"$ROOT/$1")
  while [[ $words =~ images/([A-Za-z0-9_/.-]+\.(png|svg)) ]]; do
    picture=docs/images/${BASH_REMATCH[1]} words=${words#*"${BASH_REMATCH[0]}"}
    if [[ -f $ROOT/$picture ]]; then CHOSEN[$picture]=yes; fi
  done
}

# of_own_stages TEXT: sets OWN, the text with a stage of the kit where it shows a command with `point`.
of_own_stages() {
  local stage=${WORDS[stage]##* } command
  OWN=$1
  [[ " ${WORDS[stage]} " == *' point '* ]] && return
  for command in check watch hint explain reset; do OWN=${OWN//"./lab $command point"/"./lab $command $stage"}; done
  # shellcheck disable=SC2016 # the backticks are Markdown's
  OWN=${OWN//'`point`'/"\`$stage\`"} OWN=${OWN//point-check/"$stage-check"}
}

# without_dead_links PAGE: a link to what is not in the kit becomes its words. (A link may go over a line's
# end, so a paragraph is looked at as a whole.)
without_dead_links() {
  local line paragraph='' code='' out=''
  while IFS= read -r line; do
    if [[ $code || $line == '```'* || ! $line ]]; then
      living_links "${1%/*}" "$paragraph"
      paragraph='' out+=$LIVING$line$'\n'
      [[ $line != '```'* ]] || { [[ $code ]] && code='' || code=yes; }
    else
      paragraph+=$line$'\n'
    fi
  done <"$1"
  living_links "${1%/*}" "$paragraph"
  of_own_stages "$out$LIVING"
  printf '%s' "$OWN" >"$1"
}

# living_links FOLDER PARAGRAPH: sets LIVING, the paragraph with the links that hold in this folder.
living_links() {
  local rest=$2 text target before
  local link='\[(!\[[^]]*\]\([^)]*\)|[^][]*)\]\(([^][:space:])#]+)(#[^)]*)?\)'
  LIVING=''
  while [[ $rest =~ $link ]]; do
    text=${BASH_REMATCH[1]} target=${BASH_REMATCH[2]} before=${rest%%"${BASH_REMATCH[0]}"*}
    rest=${rest#*"${BASH_REMATCH[0]}"}
    if [[ $target == *:* || -e $1/$target ]]; then
      LIVING+=$before${BASH_REMATCH[0]}
    else
      LIVING+=${before%!}$text
    fi
  done
  LIVING+=$rest
}
