#!/usr/bin/env bash
# fos-slurm.sh CLASS OUTPUT [OPTION…]: grades CLASS on a cluster, as an array of jobs of 20 submissions or
# more, and merges their results into OUTPUT, which all machines must see. OPTIONs are those of
# `./lab grade` (--roster, --format …); SBATCH_… variables say the partition, the account, the time.
# What the jobs say is in OUTPUT/logs. The same command again goes on where one was ended.
set -u
AT_LEAST=20 # a job takes seconds to start

# What a job does: the script submits itself.
case ${1-} in
  --part) # LAB CLASS OUTPUT PARTS OPTION…
    exec "$2" grade "$3" --output "$4/parts/$SLURM_ARRAY_TASK_ID" --part "$SLURM_ARRAY_TASK_ID/$5" \
      --jobs "${SLURM_CPUS_PER_TASK:-1}" "${@:6}"
    ;;
  --merge) # LAB OUTPUT PARTS OPTION…
    folders=()
    for ((i = 1; i <= $4; i++)); do folders+=("$3/parts/$i"); done
    exec "$2" grade --merge "${folders[@]}" --output "$3" "${@:5}"
    ;;
esac

here=$(readlink -f -- "${BASH_SOURCE[0]%/*}")
lab=$here/fos/lab
if (($# < 2)); then
  echo 'fos-slurm.sh CLASS OUTPUT [OPTION…]' >&2
  exit 2
fi
class=$(readlink -f -- "$1") || exit 2
mkdir -p -- "$2/logs" || exit 2
output=$(readlink -e -- "$2") || exit 2
# shellcheck source=/dev/null
source "$here/fos/kit-settings.bash"
export FOS_LANG
chmod +x "$lab"

# Builds the grader, here and once, and counts.
list=$("$lab" grade "$class" --list) || exit
count=$(wc -l <<<"$list")
parts=$((count / AT_LEAST))
((parts)) || parts=1
((parts <= 1000)) || parts=1000 # more than that Slurm does not take unless told
settings=(--seed "$FOS_SEED" --feedback "$FOS_FEEDBACK" "${@:3}")
array=$(sbatch --parsable --job-name=fos --array="1-$parts" --output="$output/logs/part-%a.log" \
  "${BASH_SOURCE[0]}" --part "$lab" "$class" "$output" "$parts" "${settings[@]}") || exit 3
# After any end: a part that has not finished is named by the merge, and run again by this command.
merge=$(sbatch --parsable --job-name=fos-merge --dependency="afterany:${array%%;*}" --output="$output/logs/merge.log" \
  "${BASH_SOURCE[0]}" --merge "$lab" "$output" "$parts" "${settings[@]}") || exit 3
printf '%s: %s × %s; merge %s: %s\n' "$count" "${array%%;*}" "$parts" "${merge%%;*}" "$output/logs"
