#!/usr/bin/env bash
# A step of the workflow: grades the stage files of the repository at hand. It sets the step's output
# `result` and its summary, and fails where a stage is not right yet.
FOS=$(cd "${BASH_SOURCE[0]%/*}/../../../.." && pwd) || exit 3
# shellcheck source=/dev/null
source "$FOS/kit-settings.bash"
export FOS_LANG
WORK=$(mktemp -d -p "${RUNNER_TEMP:-/tmp}")
mkdir "$WORK/submission"
if [[ -d labs ]]; then
  cp -R --no-dereference labs/. "$WORK/submission"
else
  tar --exclude=./.git --exclude=./.github -cf - . | tar -xf - -C "$WORK/submission"
fi
# A student's words must not be read as commands of the workflow: nothing of them is printed.
bash "$FOS/lab" grade "$WORK/submission" --one --output "$WORK/results" --format actions,html \
  --seed "$FOS_SEED" --feedback "$FOS_FEEDBACK"
status=$?
cat "$WORK"/results/submissions/*/github-output.txt >>"${GITHUB_OUTPUT:?}" || exit "$((status > 0 ? status : 3))"
cat "$WORK"/results/submissions/*/github-summary.md >>"${GITHUB_STEP_SUMMARY:?}" || exit 3
((status == 0)) || exit "$status"
[[ $(head -n 1 "$WORK"/results/results/*/result.json) == *'"status":"passed"'* ]]
