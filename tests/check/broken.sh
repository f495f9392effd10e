#!/usr/bin/env bash
# broken.sh BUILD: each file in broken/ does not compile, and what is said of it, `// LINE: WORDS` in
# its first line, is right: the student's line, those words; in both languages it fits a screen. Each
# is compiled as a stage is.
set -u
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
cd "$1" || exit 3

# What g++ or clang++ is called with for a stage, up to the names of its files.
stage_flags() {
  local line
  while IFS= read -r line; do
    [[ $line == *'"command": '*' CMakeFiles/lab_'*.dir/* ]] || continue
    line=${line#*'"command": "'} line=${line%% -o CMakeFiles/lab_*}
    printf '%s\n' "${line//\\\"/\"}"
    return
  done <compile_commands.json
}

flags=$(stage_flags)
[[ $flags ]] || { echo "broken.sh: how is a stage compiled?" && exit 1; }
said=$(mktemp -d) || exit 3
export LC_ALL=C.UTF-8 # the compiler speaks English, and a Greek letter is one column
trap 'rm -rf "$said"' EXIT
export flags said

# shellcheck disable=SC2016 # the inner shell expands it
printf '%s\0' "$here"/broken/*.cpp | xargs -0 -P "$(nproc)" -I '{}' \
  bash -c 'eval "$flags -fsyntax-only \"\$1\"" >"$said/${1##*/}" 2>&1; true' _ '{}'

failed=0 count=0
for file in "$here"/broken/*.cpp; do
  name=${file##*/} count=$((count + 1))
  IFS= read -r expected <"$file"
  expected=${expected#// } words=${expected#*: } line=${expected%%: *}
  for language in en el; do
    out=$(FOS_LANG=$language bin/fos_compile_error "$file" "$name" <"$said/$name")
    wrong=''
    [[ $out == "$name:$line:"* ]] || wrong="not line $line"
    flat=${out//$'\n'/ } flat=${flat//   / } flat=${flat//  / }
    [[ $language == el || $flat == *"$words"* ]] || wrong="not: $words"
    mapfile -t lines <<<"$out"
    ((${#lines[@]} <= 8)) || wrong='more than 8 lines'
    for each in "${lines[@]}"; do ((${#each} <= 80)) || wrong='wider than 80 columns'; done
    if [[ $wrong ]]; then
      printf '%s (%s): %s\n%s\n' "$name" "$language" "$wrong" "$out"
      failed=1
    fi
  done
done
echo "$count files that do not compile"
((count > 40)) || failed=1
exit $failed
