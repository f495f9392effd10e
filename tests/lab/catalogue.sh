#!/usr/bin/env bash
# The catalogue of ./lab: every word is there, in both languages, in the layout that bash can read.
# shellcheck source=tests/lab/harness.bash
source "$(dirname "$0")/harness.bash" "$1"

catalogue=$SOURCE/common/text/lab.def
scripts=("$SOURCE/lab" "$SOURCE/cmake/packages.bash" "$SOURCE/tests/lab/heavy_checks.bash"
  "$SOURCE/tests/numerics/trade.bash" "$SOURCE/tests/check/student.bash"
  "$SOURCE/tests/explain/explain.bash" "$SOURCE/tests/grading/grade.bash"
  "$SOURCE/tests/grading/kits/kit.bash")
keys=()
while IFS= read -r line; do
  [[ $line == //* ]] && continue
  check "an entry begins: $line" test "${line:0:9}" == 'TEXT(lab_'
  key=${line#TEXT(} key=${key%,}
  keys+=("$key")
  IFS= read -r english
  IFS= read -r greek
  check "$key in English" grep -qxE '     "[^"\\]+",' <<<"$english"
  check "$key in Greek" grep -qxE '     "[^"\\]+"\)' <<<"$greek"
  check "$key: the same placeholders" test \
    "$(grep -oE '\{[^}]*\}' <<<"$english" | sort -u)" == "$(grep -oE '\{[^}]*\}' <<<"$greek" | sort -u)"
done <"$catalogue"
check "there are entries" test "${#keys[@]}" -gt 40
check "no entry twice" test -z "$(printf '%s\n' "${keys[@]}" | sort | uniq -d)"

# A key that a script makes of a prefix and a name: the names are the commands, purposes and steps.
used=$(grep -ohE '\blab_[a-z_]+' "${scripts[@]}" | sort -u)
read -d ')' -ra commands < <(sed -nE '/^COMMANDS=/,/\)/ s/^(COMMANDS=\()?//p' "$SOURCE/lab")
for command in "${commands[@]}"; do
  used+=$'\n'"lab_help_${command%%:*}"
  check "the function of ${command%%:*}" grep -q "^command_${command%%:*}() {" "$SOURCE/lab"
done
used+=$'\n'$(sed -nE 's/^  \[([a-z]+)\]=".*/lab_missing_\1/p' "$SOURCE/cmake/packages.bash")
used+=$'\n'$(sed -nE 's/^  step ([a-z_]+) .*/lab_step_\1/p' "$SOURCE/tests/lab/heavy_checks.bash")
while IFS= read -r key; do
  case $key in lab_help_ | lab_usage_ | lab_missing_ | lab_step_) continue ;; esac
  check "the text $key exists" grep -q "^TEXT($key,\$" "$catalogue"
done <<<"$used"
for key in "${keys[@]}"; do
  case $key in lab_usage_*) continue ;; esac
  check "the text $key is used" grep -qx "$key" <<<"$used"
done

finish
