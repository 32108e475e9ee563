#!/usr/bin/env bash
# examples/slurm_batch.sh under a Slurm of one node, which this script starts and ends: munged, slurmctld, slurmd of Debian in a temporary
# folder, with ports and a socket of their own. An array of four shards, one of its tasks killed, the same array again, the merger: the
# export has the bytes of one process. Root, and some fifteen seconds; not part of `make test`, as it installs and starts daemons.
# usage: slurm-check.sh [BUILD]     BUILD is the folder of the build, by default build
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
PATH=$(realpath "${1:-build}")/bin:$PATH
[ "$(id -u)" -eq 0 ] || { echo "slurm-check.sh starts daemons; run it as root" >&2; exit 1; }
scripts/install-packages.sh slurmctld slurmd slurm-client munge
folder=$(mktemp -d)
daemons=()
end() {
  local status=$?
  [ "$status" -eq 0 ] || tail -n 20 "$folder"/*.log "$folder"/job/*.out 2>/dev/null || true
  [ ${#daemons[@]} -eq 0 ] || kill "${daemons[@]}" 2>/dev/null || true
  wait
  rm -rf "$folder"
}
trap end EXIT
host=$(hostname -s)
mkdir -p "$folder"/{state,spool,job,munge}
chmod 755 "$folder"
chmod 700 "$folder/munge"
head -c 1024 /dev/urandom >"$folder/munge/key"
chmod 400 "$folder/munge/key"
munged --foreground --force --socket="$folder/munge.socket" --key-file="$folder/munge/key" --pid-file="$folder/munge/pid" \
  --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" >"$folder/munged.log" 2>&1 &
daemons+=($!)
cat >"$folder/slurm.conf" <<CONF
ClusterName=check
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_min_interval=100000
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4
CONF
export SLURM_CONF=$folder/slurm.conf
slurmctld -D >"$folder/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D >"$folder/slurmd.log" 2>&1 &
daemons+=($!)
for _ in $(seq 100); do
  [ "$(sinfo -h -o %T 2>/dev/null)" != idle ] || break
  sleep 0.1
done
sinfo

cd "$folder/job"
cp "$root"/examples/resonance*.dat .
for k in $(seq 60); do awk -v d="$k" '{ print $1 + d / 1000, $2 + d / 2000 }' resonance.dat >"moved.$k"; done
printf 'operation = "overlay"\ncurves = ["resonance*.dat", "moved.*"]\npairs = "all"\n' >job.toml
lober batch run job.toml --store whole.results --quiet
lober batch export whole.results -o whole.jsonl >/dev/null
submit=(sbatch --parsable --cpus-per-task=1 --mem-per-cpu=100M --output=%x-%A_%a.out)
script=$root/examples/slurm_batch.sh
array=$("${submit[@]}" --array=1-4 "$script" job.toml)
scancel --signal=KILL --full "${array}_2" || true  # whenever it is: before it starts, in the middle or afterwards
scancel "${array}_3"
again=$("${submit[@]}" --dependency=afterany:"$array" --array=1-4 "$script" job.toml)
sbatch --wait --cpus-per-task=1 --mem-per-cpu=100M --output=merge.out --dependency=afterany:"$again" "$script" job.toml >/dev/null
cat merge.out
lober batch export job.results -o job.jsonl >/dev/null
cmp whole.jsonl job.jsonl
echo "Slurm $(slurmctld -V | cut -d' ' -f2): an array of 4 shards, two tasks of it ended, gives the bytes of one process ($(wc -l <job.jsonl) jobs)"
