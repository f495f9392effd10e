#!/usr/bin/env bash
# container_test.sh ROOT: the container's files are whole, and its RUN line asks apt for what ./lab would.
# Where apt-get only pretends, nothing is installed; no container is made.
ROOT=$(readlink -f -- "$1")
WORK=$(mktemp -d)
trap 'rm -rf "$WORK"' EXIT
bad=0

for file in .devcontainer/devcontainer.json vcpkg.json; do
  # shellcheck disable=SC2016 # CMake's variable
  printf 'file(READ "%s" json)\nstring(JSON _ LENGTH "${json}")\n' "$ROOT/$file" >"$WORK/read.cmake"
  cmake -P "$WORK/read.cmake" || { echo "$file is no JSON" && bad=1; }
done

mkdir "$WORK/bin"
printf '#!/bin/bash\necho "$*" >>"%s/asked"\n' "$WORK" | tee "$WORK/bin/apt-get" >"$WORK/bin/rm"
chmod +x "$WORK"/bin/*
run=$(sed -n '/^RUN /,/[^\\]$/p' "$ROOT/.devcontainer/Dockerfile")
run=${run#RUN }
PATH=$WORK/bin:$PATH sh -c "${run//\/tmp/$ROOT/cmake}" || { echo "the RUN line fails" && bad=1; }
asked=$(grep '^install -y --no-install-recommends ' "$WORK/asked")
# shellcheck source=cmake/packages.bash
. "$ROOT/cmake/packages.bash"
for package in ${PACKAGES[build]} ${PACKAGES[exact]}; do
  [[ " ${asked//$'\n'/ } " == *" $package "* ]] || { echo "$package is not asked for" && bad=1; }
done
exit $bad
