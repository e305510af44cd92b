#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# Starts a Slurm of this one machine, with two processors, below a folder: no systemd, nothing in /etc, loopback only.
# Usage: slurm_up.sh FOLDER; then SLURM_CONF=FOLDER/slurm.conf. slurm_down.sh ends it.
set -eu
D=$1
H=$(hostname -s)
U=$(id -un)
port=$((20000 + RANDOM % 20000))
mkdir -p "$D"/{ctld,spool,log,munge}
chmod 711 "$D/munge" # munged refuses a folder that others cannot enter
head -c 1024 /dev/urandom >"$D/munge/key"
chmod 400 "$D/munge/key"
cat >"$D/slurm.conf" <<CONF
ClusterName=proxima
SlurmctldHost=$H(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=$U
SlurmdUser=$U
AuthType=auth/munge
AuthInfo=socket=$D/munge/sock
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$D/ctld
SlurmdSpoolDir=$D/spool
SlurmctldPidFile=$D/ctld.pid
SlurmdPidFile=$D/slurmd.pid
SlurmctldLogFile=$D/log/ctld.log
SlurmdLogFile=$D/log/slurmd.log
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1
InactiveLimit=0
KillWait=2
MinJobAge=600
JobCompType=jobcomp/filetxt
JobCompLoc=$D/jobcomp.txt
NodeName=$H NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$H Default=YES MaxTime=INFINITE State=UP
CONF
force=
[ "$U" = root ] && force=--force
/usr/sbin/munged $force --key-file="$D/munge/key" --socket="$D/munge/sock" --pid-file="$D/munge/pid" \
    --log-file="$D/munge/log" --seed-file="$D/munge/seed"
export SLURM_CONF="$D/slurm.conf"
/usr/sbin/slurmctld -i -f "$SLURM_CONF"
/usr/sbin/slurmd -f "$SLURM_CONF" -N "$H"
for _ in $(seq 120); do
    [ "$(sinfo -h -o %T 2>/dev/null || true)" = idle ] && exit 0
    sleep 0.5
done
echo "Slurm did not start; its logs are in $D/log" >&2
exit 1
