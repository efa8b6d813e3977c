# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# For scripts of bash, to be read by `source` in a folder of their own: starts a Slurm of one node, this machine, and
# appends its processes to the array `pids`.
# shellcheck shell=bash

name=$(hostname --short)
mkdir -p slurm_state slurm_spool
chmod 755 .
dd if=/dev/urandom of=munge.key bs=1 count=1024 status=none
chmod 600 munge.key
munged --foreground --force --key-file "$PWD/munge.key" --socket "$PWD/munge.socket" --pid-file "$PWD/munged.pid" \
  --log-file "$PWD/munged.log" --seed-file "$PWD/munged.seed" >/dev/null 2>&1 &
pids+=($!)
cat >slurm.conf <<END
ClusterName=test
SlurmctldHost=$name(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$PWD/munge.socket
CredType=cred/munge
StateSaveLocation=$PWD/slurm_state
SlurmdSpoolDir=$PWD/slurm_spool
SlurmctldPidFile=$PWD/slurmctld.pid
SlurmdPidFile=$PWD/slurmd.pid
SlurmctldLogFile=$PWD/slurmctld.log
SlurmdLogFile=$PWD/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,requeue_delay=0
NodeName=$name NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=test Nodes=$name Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$PWD/slurm.conf
for _ in $(seq 50); do
  [[ ! -S munge.socket ]] || break
  sleep 0.1
done
slurmctld -D >/dev/null 2>&1 &
pids+=($!)
slurmd -D >/dev/null 2>&1 &
pids+=($!)
for _ in $(seq 300); do
  [[ $(sinfo --noheader --format %t 2>/dev/null) != idle ]] || break
  sleep 0.1
done
[[ $(sinfo --noheader --format %t) == idle ]]
