# What the kits share: where one may go, and the zip itself. Sourced by ./lab, whose words it uses.

kit_place() {
  case ${1,,} in *[^/].zip) check_place "$1" ;; *) fail 2 lab_bad_zip "$1" ;; esac
}

# begin_kit NAME KIT_ZIP: KIT, the folder to fill, and KIT_ZIP, made absolute, or NAME.zip in build/kits.
begin_kit() {
  local kits=$ROOT/build/kits
  KIT_ZIP=${2:-$kits/$1.zip}
  [[ $KIT_ZIP == /* ]] || KIT_ZIP=$PWD/$KIT_ZIP
  KIT=$kits/.$1.$$.part PART=${KIT_ZIP%/*}/.${KIT_ZIP##*/}.$$.part
  trap 'rm -rf -- "$KIT" "$KIT.names" "$PART" 2>/dev/null' EXIT
  if ! mkdir -p "$KIT" 2>/dev/null || [[ -d $KIT_ZIP ]]; then fail 3 lab_kit_fails "$KIT_ZIP"; fi
}

# end_kit: all that is below KIT becomes the zip, whole or not at all, in one order and with one time for
# all files. (Of the moments that CMake keeps besides, a few bytes still differ from zip to zip.)
end_kit() {
  local names
  if ! chmod -R u=rwX,go=rX "$KIT" || ! cd "$KIT"; then return 1; fi
  mapfile -t names < <(shopt -s globstar dotglob && IFS='' LC_ALL=C &&
    for file in **; do [[ ! -f $file ]] || printf '%s\n' "$file"; done)
  printf '%s\n' "${names[@]}" >"$KIT.names" &&
    TZ=UTC cmake -E tar cf "$PART" --format=zip --mtime='2026-01-01 00:00:00' --files-from="$KIT.names" >&2 &&
    cd "$OLDPWD" && mv -f -- "$PART" "$KIT_ZIP" &&
    say lab_kit_made "${KIT_ZIP#"$PWD/"}" "${#names[@]}" "$(stat -c %s -- "$KIT_ZIP")"
}
