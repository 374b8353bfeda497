#!/usr/bin/env bash
# Runs a campaign on a cluster of one machine: Debian's Slurm with its accounts, 64 tasks, a quarter of which are killed and queued again.
# The merged results must have the bytes of one run's. Needs root, and the packages slurm-wlm, slurmdbd, munge, mariadb-server and procps.
# slurm.sh VIDNO
set -euo pipefail
export VIDNO=$1
tasks=64
killed_tasks=16
work=$(mktemp -d)
chmod 755 "$work"
cd "$work"

# ---- the cluster

leave() {
    local name
    for name in slurmd slurmctld slurmdbd munged mariadb; do
        [[ ! -e $name.pid ]] || kill "$(<"$name.pid")" || true
    done
    wait
    rm -rf "$work"
}
trap leave EXIT

# wait_for SECONDS COMMAND: until it succeeds
wait_for() {
    local end=$((SECONDS + $1))
    until "${@:2}" >/dev/null 2>&1; do
        ((SECONDS < end)) || { tail -n 5 ./*.log && echo "$1 s without success: ${*:2}" && return 1; } >&2
        sleep .2
    done
}

host=$(hostname -s)
database_port=16818
mkdir run spool accounts state
dd if=/dev/urandom of=munge.key bs=1k count=1 status=none
chmod 600 munge.key
cat >slurm.conf <<END
ClusterName=classroom
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16819
SlurmUser=slurm
AuthType=auth/munge
AuthInfo=socket=$work/run/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MinJobAge=3600
AccountingStorageType=accounting_storage/slurmdbd
AccountingStorageHost=127.0.0.1
AccountingStoragePort=$database_port
AccountingStoragePass=$work/run/munge
JobAcctGatherType=jobacct_gather/linux
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
cat >slurmdbd.conf <<END
DbdHost=localhost
DbdAddr=127.0.0.1
DbdPort=$database_port
SlurmUser=slurm
AuthType=auth/munge
AuthInfo=socket=$work/run/munge
PidFile=$work/slurmdbd.pid
StorageType=accounting_storage/mysql
StorageHost=127.0.0.1
StoragePort=16820
StorageUser=slurm
StoragePass=slurm
StorageLoc=accounts
END
chmod 600 slurmdbd.conf
chown slurm . state slurmdbd.conf
export SLURM_CONF=$work/slurm.conf

echo "== Debian's Slurm on this machine: $(slurmctld -V)"
mariadb-install-db --no-defaults --datadir="$work/accounts" --auth-root-authentication-method=normal --user=root >mariadb.log 2>&1
mariadbd --no-defaults --user=root --datadir="$work/accounts" --bind-address=127.0.0.1 --port=16820 --skip-name-resolve \
    --socket="$work/run/mariadb" --pid-file="$work/mariadb.pid" >>mariadb.log 2>&1 &
wait_for 60 mariadb --socket="$work/run/mariadb" -e "
    create user if not exists slurm@'%' identified by 'slurm';
    grant all on accounts.* to slurm@'%'"
munged --force --key-file="$work/munge.key" --socket="$work/run/munge" --pid-file="$work/munged.pid" --log-file="$work/munged.log" \
    --seed-file="$work/munge.seed"
slurmdbd -D -v >slurmdbd.log 2>&1 &
wait_for 60 sacctmgr --immediate add cluster classroom
slurmctld -D -f slurm.conf >slurmctld.log 2>&1 &
slurmd -D -f slurm.conf -N "$host" >slurmd.log 2>&1 &
wait_for 60 bash -c "sinfo -h -o %t | grep -x idle"
sinfo

# ---- the campaign

say() { printf '\n$ %s\n' "$*"; }
campaign=(stability --family edges slivers --kernel float double --method warnock zbuffer --count 2048)
say "vidno ${campaign[*]} --script slurm --tasks $tasks -o merged.jsonl > campaign.sh"
"$VIDNO" "${campaign[@]}" --script slurm --tasks $tasks -o merged.jsonl >campaign.sh
say "bash campaign.sh"
bash campaign.sh
array=$(squeue -h -o %A --name=vidno | sort -n | head -n 1)

# The numbers of the tasks that run and have finished a block, each behind its process.
at_work() {
    local process task
    pgrep -a -f -- "^$VIDNO stability .*--shard" | sed -nE 's|^([0-9]+) .* --shard ([0-9]+)/.*|\1 \2|p' |
        while read -r process task; do
            (($(wc -l <"merged.jsonl.parts/$task.jsonl") < 2)) || echo "$process $task"
        done
}
has_ended() { [[ -z $(squeue -h) ]]; }

touch killed
until (($(wc -l <killed) == killed_tasks)) || has_ended; do
    while read -r process task; do
        grep -qx "$task" killed || (($(wc -l <killed) == killed_tasks)) || { kill -9 "$process" && echo "$task" >>killed; }
    done < <(at_work 2>/dev/null)
    [[ ! -s killed || -e squeue.txt ]] || squeue >squeue.txt
    sleep .1
done
(($(wc -l <killed) == killed_tasks)) || { echo "too few tasks ran long enough to be killed" >&2 && exit 1; }
say squeue
cat squeue.txt
echo "killed by kill -9: tasks $(sort -n killed | tr '\n' ' ')"
wait_for 1800 has_ended

accounts=(--jobs "$array" --allocations --duplicates --noheader --parsable2)
say "sacct --jobs $array --allocations --duplicates"
sacct "${accounts[@]}" --format=State,ExitCode | sort | uniq -c
requeued=$(sacct "${accounts[@]}" --state=REQUEUED --format=JobID | sort -u | wc -l)
completed=$(sacct "${accounts[@]}" --format=JobID,State | grep -c '|COMPLETED$')
echo "requeued: $requeued tasks; completed: $completed"
((requeued == killed_tasks && completed == tasks))

"$VIDNO" "${campaign[@]}" -o whole.jsonl >/dev/null
say "cmp merged.jsonl whole.jsonl"
cmp merged.jsonl whole.jsonl
echo "equal: $(wc -c <merged.jsonl) bytes"
