#!/usr/bin/env bash
# A study of six short runs as a Slurm job array, on a Slurm of its own on this machine: munged, slurmctld and slurmd on
# loopback, one node, no accounting, everything in a temporary folder. One task is told to stop and must queue itself
# again; the results must be those of the local pool, to the bit. Then one of two tasks nears its time limit, and both
# are cancelled. Needs root. Takes about four minutes: Slurm lets a requeued job wait for two.
#   tests/long/slurm.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
[ "$(id -u)" -eq 0 ] || { echo "slurmd and slurmctld need root here" >&2; exit 1; }
if ! command -v slurmctld >/dev/null || ! command -v slurmd >/dev/null || ! command -v munged >/dev/null; then
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends slurm-wlm munge
fi

work=$(mktemp -d)
services=()
finish() {
  for id in "${services[@]}"; do kill "$id" 2>/dev/null || true; done
  wait 2>/dev/null || true
  [ -n "${KEEP:-}" ] || rm -rf "$work"
}
trap finish EXIT
mkdir "$work"/{munge,state,spool}
chmod 755 "$work"
chmod 711 "$work/munge"
head -c 1024 /dev/urandom >"$work/munge/key"
chmod 600 "$work/munge/key"
port=$((20000 + $$ % 20000))
host=$(hostname -s)
cat >"$work/slurm.conf" <<END
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
SlurmUser=root
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=20
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=2000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
touch "$work/cgroup.conf"
export SLURM_CONF=$work/slurm.conf

munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
  --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" &
services+=($!)
for _ in $(seq 50); do [ -S "$work/munge/socket" ] && break || sleep 0.1; done
slurmctld -D -i &
services+=($!)
slurmd -D -N "$host" &
services+=($!)
for _ in $(seq 100); do sinfo -h -o %T 2>/dev/null | grep -q idle && break || sleep 0.3; done
sinfo -N -l

cd "$work"
cat >scenario.toml <<END
[ecm]
radius = "90 um"
[run]
duration = "${HOURS:-0.15} h"
[protrusion]
initiation_rate = "0.001 1/s"
END
cat >study.toml <<END
title = "Two stiffnesses"
scenario = "scenario.toml"
replicates = 3
readouts = ["v_migr_abs_um_per_h", "n_protrusions"]
[sweep]
ecm.youngs_modulus = ["100 Pa", "200 Pa"]
END

"$program" study submit study.toml -o slurm --throttle 2
for _ in $(seq 200); do pgrep -f "study task .*/slurm 1 --list" >/dev/null && break || sleep 0.1; done
sleep 0.5
victim=$(pgrep -f -o "study task .*/slurm 1 --list")
echo "telling task 1 (process $victim) to stop"
kill -TERM "$victim"
for i in $(seq 400); do
  [ -z "$(squeue -h -r)" ] && break
  [ $((i % 20)) -ne 0 ] || squeue -r
  sleep 1
done
"$program" study status slurm
grep -q "queued again" slurm/slurm/*_1.out || { echo "task 1 did not queue itself again" >&2; exit 1; }
"$program" study collect slurm --quiet
"$program" study run study.toml -o local --jobs 2 --quiet
cmp slurm/results.csv local/results.csv
cmp slurm/statistics.csv local/statistics.csv
"$program" study submit study.toml -o slurm | grep -q "nothing to submit"
echo "the same results from Slurm and from the local pool"

# What a cluster may ask for, sbatch's own options, and a folder whose name Slurm could misread.
sed 's/^replicates.*/replicates = 1/' study.toml >few.toml
odd="100 %A \$(touch PWNED) 'x' # y"
"$program" study submit few.toml -o "$odd" --account lab --time 1:00:00 --mem 200M --mail-user nobody --json \
  -- --comment="two words" --nice=7 >job.json
job=$(sed -n 's/.*"job": "\([0-9]*\)".*/\1/p' job.json)
scontrol show job "${job}_0" >job.txt
for field in "Account=lab" "TimeLimit=01:00:00" "MinMemoryNode=200M" "Comment=two words" "Nice=7"; do
  grep -qF "$field" job.txt || { echo "the job has no $field" >&2; cat job.txt >&2; exit 1; }
done
for _ in $(seq 200); do [ -z "$(squeue -h -r)" ] && break || sleep 1; done
ls "$odd/slurm/${job}_0.out" "$odd/slurm/${job}_1.out"
"$program" study status "$odd" | grep -qx "2 runs: 2 done" || { "$program" study status "$odd" >&2; exit 1; }
[ ! -e PWNED ]
echo "options are handed to Slurm, and a folder may have an odd name"

# A task that nears its time limit is queued again. What is cancelled stays cancelled.
sed 's/^replicates.*/replicates = 1/; s/^\[sweep\]/[set]\nrun.duration = "1000 h"\nprotrusion.initiation_rate = 0\n[sweep]/' study.toml >long.toml
job=$("$program" study submit long.toml -o cancelled --json | sed -n 's/.*"job": "\([0-9]*\)".*/\1/p')
for _ in $(seq 100); do [ "$(squeue -h -r -t R | wc -l)" -eq 2 ] && break || sleep 0.2; done
sleep 1
scancel --batch --signal=USR1 "${job}_0" # what Slurm sends before the time limit
for _ in $(seq 60); do grep -q "queued again" cancelled/slurm/*_0.out && break || sleep 0.5; done
grep -q "queued again" cancelled/slurm/*_0.out || { echo "a task at its time limit did not queue itself again" >&2; exit 1; }
scancel "$job"
for _ in $(seq 60); do [ -z "$(squeue -h -r)" ] && break || sleep 1; done
[ -z "$(squeue -h -r)" ] || { echo "a cancelled job is still there" >&2; squeue -r; exit 1; }
"$program" study status cancelled
! grep -q "queued again" cancelled/slurm/*_1.out
grep -l '"interrupted"' cancelled/runs/*/run.json | wc -l | grep -qx 2
echo "a task was queued again before its time limit; a cancelled one was not"
