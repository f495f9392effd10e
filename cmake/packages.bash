# What Fos needs from Debian or Ubuntu, and how ./lab gets it. Sourced by ./lab, whose words and
# ROOT it uses.

# The packages, by what they are for; the texts lab_missing_… say why.
declare -A PACKAGES=(
  [build]="g++ cmake ninja-build libglm-dev libfmt-dev tao-pegtl-dev libopenimageio-dev openimageio-tools zlib1g-dev fonts-dejavu-core"
  [exact]="libmpfi-dev libgmp-dev libmpfr-dev"
  [test]="catch2 libhwy-dev libmpfi-dev libgmp-dev libmpfr-dev"
  [grade]="bubblewrap libzip-dev libmd-dev nlohmann-json3-dev"
  [plot]="gnuplot-nox"
  [figures]="clang lld wasi-libc libc++-dev-wasm32 libclang-rt-dev-wasm32"
  [docs]="mkdocs mkdocs-material libjs-katex fonts-katex"
  [check]="clang clang-format clang-tidy libclang-rt-dev shellcheck hunspell hunspell-en-gb hunspell-el chromium chromium-driver libxml2-utils python3-yaml"
  [slurm]="slurmctld slurmd slurm-client munge"
)
APT_LOG=$ROOT/build/apt.log

# set_up PURPOSE…: installs the packages that are missing for these purposes. Where that may not be
# done it goes on: what is needed may be there in another form. ADVICE is what to say if it is not.
set_up() {
  local purpose package installed missing=() lacking answer
  if ! mkdir -p "$ROOT/build" 2>/dev/null || [[ ! -w $ROOT/build ]]; then
    fail 3 lab_no_build_folder "$ROOT/build"
  fi
  ADVICE=(lab_needs_by_name)
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then return 0; fi

  # shellcheck disable=SC2048,SC2086 # the lists are words
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' ${PACKAGES[*]} 2>/dev/null)
  for purpose; do
    lacking=()
    for package in ${PACKAGES[$purpose]}; do
      [[ $'\n'$installed$'\n' == *$'\n'"installed $package"$'\n'* ]] || lacking+=("$package")
    done
    ((${#lacking[@]})) && complain "lab_missing_$purpose" "${lacking[*]}"
    missing+=("${lacking[@]}")
  done
  ADVICE=()
  ((${#missing[@]})) || return 0

  ADVICE=(lab_administrator "apt-get install --no-install-recommends ${missing[*]}")
  if ! may_be_root; then
    complain "${ADVICE[@]}"
    return 0
  fi
  : >"$APT_LOG" || exit 3
  if ! plan "${missing[@]}"; then # no package lists, or old ones
    complain lab_apt_update
    apt update
    plan "${missing[@]}" || apt_failed
  fi
  complain lab_apt_install "$DOWNLOAD" "$DISK"
  if [[ -t 0 ]]; then
    printf 'lab: %s ' "$(say lab_apt_ask)" >&2
    read -r answer || answer=n
    case $answer in '' | y* | Y* | ν* | Ν*) ;; *) return 0 ;; esac
  fi
  if ! install "${missing[@]}"; then
    [[ $(<"$APT_LOG") == *' 404 '* ]] || apt_failed
    complain lab_apt_update # the lists name what is no longer there
    apt update
    install "${missing[@]}" || apt_failed
  fi
  ADVICE=()
  hash -r
}

# may_be_root: how, in AS_ROOT; false if there is no way.
may_be_root() {
  AS_ROOT=(env)
  [[ $(id -u) == 0 ]] && return
  AS_ROOT=(sudo env)
  command -v sudo >/dev/null || return
  sudo -n true 2>/dev/null || { [[ -t 0 ]] && sudo -v; }
}

# plan PACKAGE…: the sizes of what apt would do, DOWNLOAD and DISK; it does nothing yet.
plan() {
  local words
  words=$(LC_ALL=C apt-get install --assume-no --no-remove --no-install-recommends \
    -o Debug::NoLocking=true "$@" 2>&1 </dev/null)
  printf '%s\n' "$words" >>"$APT_LOG"
  DOWNLOAD='0 B'
  [[ $words =~ 'Need to get '([0-9.,]+ [kMG]?B) ]] && DOWNLOAD=${BASH_REMATCH[1]}
  [[ $words =~ 'After this operation, '([0-9.,]+ [kMG]?B) ]] && DISK=${BASH_REMATCH[1]}
}

# apt ARGUMENT…: apt-get as root. What it says goes to the log; Ctrl-C is left to it.
apt() {
  "${AS_ROOT[@]}" DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -o DPkg::Lock::Timeout=120 "$@" \
    2>&1 </dev/null | tee -i -a "$APT_LOG" | one_line
  return "${PIPESTATUS[0]}"
}
install() { apt install -y --no-remove --no-install-recommends "$@"; }

apt_failed() {
  tail -n 12 "$APT_LOG" >&2
  complain lab_apt_failed "$APT_LOG"
  fail 3 "${ADVICE[@]}"
}
