# `./lab docs`: the site, from docs/en, docs/el and the live figures. Sourced by ./lab, whose words and
# build it uses.

# docs: MkDocs makes each language by itself; both share the pictures, figures and styles beside them.
docs() {
  local work=$ROOT/build/site-parts site=$ROOT/build/site language
  local katex=${FOS_KATEX:-/usr/share/javascript/katex}
  (($# == 0)) || fail 2 lab_takes_nothing docs "$1"
  set_up build figures docs
  command -v mkdocs >/dev/null || give_up lab_no_mkdocs
  [[ -d $katex ]] || give_up lab_no_katex "$katex"
  is_configured || configure -DFOS_TESTS=ON
  build "$BUILD" figures || fail 3 lab_no_figures
  # shellcheck source=/dev/null
  source "$BUILD/stages.sh"

  rm -rf "$work" && mkdir -p "$work/site" || exit 3
  for language in en el; do
    make_site "$language" >"$work/$language.log" 2>&1 && continue
    tail -n 12 "$work/$language.log" >&2
    fail 1 lab_site_failed "$work/$language.log"
  done
  cp "$ROOT/docs/site/index.html" "$work/site/index.html" && rm -rf "$site" && mv "$work/site" "$site" || exit 3
  say lab_site_made "$site/index.html"
}

# make_site LANGUAGE: into site/LANGUAGE, and beside it what is the same for both.
make_site() {
  local source=$work/$1
  mkdir -p "$source/math" && ln -s "$ROOT/docs/$1" "$ROOT/docs/images" "$BUILD/figures" "$source" &&
    cp "$ROOT"/docs/site/{site.css,math.js} "$source" &&
    cp -L "$katex"/katex.min.{css,js} "$katex/contrib/auto-render.js" "$source/math" &&
    mkdir "$source/math/fonts" && cp "$katex"/fonts/*.woff2 "$source/math/fonts" &&
    FOS_LANG=$1 settings "$1" >"$work/$1.yml" &&
    NO_COLOR=1 mkdocs build --strict --config-file "$work/$1.yml" --site-dir "$work/made" &&
    rm -f "$work/made"/{404.html,sitemap*} && cp -R "$work/made/." "$work/site" && rm -r "$work/made"
}

# settings LANGUAGE: what the languages do not share, the order of the pages first of all.
settings() {
  local stage lecture last=''
  cat <<EOT
INHERIT: $(quoted "$ROOT/docs/site/mkdocs.yml")
hooks: [$(quoted "$ROOT/docs/site/hooks.py")]
docs_dir: $(quoted "$work/$1")
site_name: $(quoted "$(say lab_site_name)")
theme:
  language: $1
nav:
  - $1/start.md
  - $(quoted "$(say lab_site_lectures)"):
EOT
  for stage in "${FOS_STAGES[@]}"; do
    lecture=${FOS_STAGE_LECTURE[$stage]}
    [[ $lecture == "$last" ]] || pages "$1" "lecture-$(printf %02d "$lecture")"
    last=$lecture
    pages "$1" "stage-$stage"
  done
  printf '  - %s:\n' "$(quoted "$(say lab_site_working)")"
  pages "$1" checking mistakes scene-files conventions
  printf '  - %s:\n' "$(quoted "$(say lab_site_accuracy)")"
  pages "$1" numerics speed reference-data
  printf '  - %s:\n' "$(quoted "$(say lab_site_teaching)")"
  pages "$1" lecturing grading adding-a-stage
  printf '  - %s:\n' "$(quoted "$(say lab_site_inside)")"
  pages "$1" contributing dependencies platforms
}

quoted() { printf "'%s'" "${1//\'/\'\'}"; } # as YAML has it

# pages LANGUAGE NAME…: those that are there; their titles are their first headings.
pages() {
  local name
  for name in "${@:2}"; do
    [[ ! -f $ROOT/docs/$1/$name.md ]] || printf '    - %s/%s.md\n' "$1" "$name"
  done
}
