#!/usr/bin/env bash
# slurm_test.sh ROOT BUILD: the kit for Slurm on a real one, of this machine alone: 45 submissions in an
# array of two jobs, merged, are what one run gives. Exit status 75: not run; the last line says why.
# shellcheck disable=SC2317 # functions for `check`
ROOT=$(readlink -f -- "$1") BUILD=$(readlink -f -- "$2")
(($(id -u) == 0)) || { echo 'root (munged, slurmctld, slurmd)' && exit 75; }
for tool in munged slurmctld slurmd sbatch; do command -v "$tool" >/dev/null || { echo "$tool" && exit 75; }; done
WORK=$(mktemp -d) STATE=$(mktemp -d)
export FOS_LANG=en SLURM_CONF=$STATE/slurm.conf
FAILURES=0
check() { # WHAT COMMAND…
  "${@:2}" && return
  FAILURES=$((FAILURES + 1))
  printf 'FAILED: %s\n' "$1"
}

# Slurm: its own munge key and socket, ports of its own on the loopback, all state in one folder.
DAEMONS=()
ends() {
  scancel --user=root 2>/dev/null
  for ((i = ${#DAEMONS[@]} - 1; i >= 0; i--)); do kill "${DAEMONS[i]}" 2>/dev/null && wait "${DAEMONS[i]}" 2>/dev/null; done
  rm -rf "$WORK" "$STATE"
}
trap ends EXIT
port=$((20000 + RANDOM % 20000))
mkdir "$STATE"/{state,spool,log} && chmod 755 "$STATE" "$STATE/log"
head -c 1024 /dev/urandom >"$STATE/key" && chmod 400 "$STATE/key"
cat >"$SLURM_CONF" <<EOT
ClusterName=fos
SlurmctldHost=$(hostname -s)(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$STATE/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$STATE/state
SlurmdSpoolDir=$STATE/spool
SlurmctldPidFile=$STATE/slurmctld.pid
SlurmdPidFile=$STATE/slurmd.pid
SlurmctldPort=$port
SlurmdPort=$((port + 1))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,bf_interval=1
MpiDefault=none
ReturnToService=2
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=500 State=UNKNOWN
PartitionName=grade Nodes=$(hostname -s) Default=YES MaxTime=10:00 State=UP
EOT
start() { # NAME WORD…
  "${@:2}" >"$STATE/log/$1" 2>&1 &
  DAEMONS+=("$!")
}
until_true() { # SECONDS COMMAND…
  local tries=$((5 * $1))
  while ((tries--)); do "${@:2}" &>/dev/null && return; sleep 0.2; done
  false
}
start munged munged --foreground --force --key-file "$STATE/key" --socket "$STATE/munge" \
  --pid-file "$STATE/munged.pid" --log-file "$STATE/log/munge" --seed-file "$STATE/seed"
starts() { "$@" || { tail -n 5 "$STATE"/log/* && echo 'a machine on which Slurm starts' && exit 75; }; }
starts until_true 10 test -S "$STATE/munge"
start slurmctld slurmctld -D -c
start slurmd slurmd -D -N "$(hostname -s)"
is_idle() { [[ $(sinfo -h -o %t) == idle ]]; }
starts until_true 30 is_idle

# The class, graded at once, and by the kit. The grader in BUILD stands for one built from the kit.
# shellcheck source=tests/grading/class_of.bash
source "$ROOT/tests/grading/class_of.bash"
class_of "$ROOT" "$WORK/the class" 45
"$ROOT/lab" kit slurm --seed 7 --output "$WORK/kit.zip" >/dev/null || exit 3
mkdir -p "$WORK/kit/fos" && (cd "$WORK/kit" && cmake -E tar xf ../kit.zip fos-slurm.sh fos/kit-settings.bash) || exit 3
ln -s "$ROOT/lab" "$WORK/kit/fos/lab"
options=(--stages ambient --format csv)
"$WORK/kit/fos-slurm.sh" &>/dev/null
check "no class: status 2" test $? == 2
"$WORK/kit/fos-slurm.sh" "$WORK/no class" "$WORK/out" >"$WORK/said" 2>&1
check "a class that is not there: status 2" test $? == 2
check "and it is named" grep -q 'no class: No such file' "$WORK/said"
"$WORK/kit/fos-slurm.sh" "$WORK/the class" "$WORK/out" "${options[@]}" >"$WORK/said" 2>&1
check "is submitted: $(tail -n 3 "$WORK/said")" grep -q '^45: ' "$WORK/said"
check "in two parts" grep -qE '^45: [0-9]+ × 2;' "$WORK/said"
"$BUILD/bin/fos_grade" --root "$ROOT" --build "$BUILD" "$WORK/the class" --output "$WORK/whole" --seed 7 \
  --feedback hints "${options[@]}" &>/dev/null
none_is_left() { [[ -z $(squeue -h) ]]; }
check "all jobs end" until_true 90 none_is_left
check "merged: $(cat "$WORK"/out/logs/merge.log)" grep -q 'merged: 45, from 2 parts' "$WORK/out/logs/merge.log"
check "the marks of one run" cmp "$WORK/whole/grades.csv" "$WORK/out/grades.csv"
results() { # FOLDER: but for the processor time, and the sum over it
  (cd "$1/results" && find . -name result.json | sort | xargs sed -E 's/"cpu_seconds": [^,]*//; s/"sum":"[^"]*"//')
}
check "the results of one run" cmp <(results "$WORK/whole") <(results "$WORK/out")
check "and they are all there" test "$(results "$WORK/out" | grep -c '"id"')" == 45

((FAILURES == 0)) && echo passed
exit "$((FAILURES > 0))"
