#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a command with real SocketCAN, inside User-Mode Linux (Debian package user-mode-linux). This kernel runs as an
# ordinary process without root, and boots in 2 s. The root of the guest is the file tree of this machine, read-write.
# So programs that were built here run there in the same folder and environment (plus BORESIGHT_UML=1).
#
#   uml_can_run.sh [-m MEMORY] [-t SECONDS] [-n INTERFACES] [-l KERNEL_LOG] [-p LIBRARY] [--] COMMAND [ARGUMENT…]
#     -m 512M   guest memory          -t 120  time limit
#     -n 2      vcan0 … vcan(n-1), CAN-FD, up          -l FILE keeps the kernel's log
#     -p FILE   a library that is loaded into the kernel before its own
#
# Status: that of the command. 77 (ctest: skipped) if UML or its CAN is missing, with the reason on stderr. 124 after
# the time limit, or if three guests do not boot. 125 if UML died while the command ran. stdout and stderr stay
# separate.
set -u

memory=512M limit=120 interfaces=2 keep_log='' preload=''
while [ $# -gt 0 ]; do
  case $1 in
    -m) memory=$2; shift 2 ;;
    -t) limit=$2; shift 2 ;;
    -n) interfaces=$2; shift 2 ;;
    -l) keep_log=$2; shift 2 ;;
    -p) preload=$2; shift 2 ;;
    --) shift; break ;;
    -*) echo "uml_can_run: unknown option $1" >&2; exit 2 ;;
    *) break ;;
  esac
done
if [ $# -eq 0 ]; then
  echo "usage: uml_can_run.sh [-m MEMORY] [-t SECONDS] [-n INTERFACES] [-l KERNEL_LOG] [-p LIBRARY] [--]" \
    "COMMAND [ARGUMENT…]" >&2
  exit 2
fi

if [ -n "$preload" ] && { [ ! -r "$preload" ] || [[ $preload == *[\ :]* ]]; }; then
  echo "uml_can_run: $preload cannot be read, or has a space or a colon in its name" >&2
  exit 2
fi

skip() { echo "uml_can_run: skipped: $1" >&2; exit 77; }

PATH=$PATH:/usr/sbin:/sbin
for need in linux.uml:user-mode-linux modprobe:kmod ip:iproute2; do
  command -v "${need%:*}" >/dev/null || skip "no ${need%:*} (apt install ${need#*:})"
done

dir=$(mktemp -d "${TMPDIR:-/tmp}/uml_can.XXXXXX")
trap 'rm -rf "$dir"' EXIT

# Command and environment travel as shell text on the shared file tree: nothing has to be quoted for the kernel line.
{
  export -p | grep -vE '^declare -[a-z]*r?x[a-z]* (BASHOPTS|SHELLOPTS|EUID|PPID|UID)='
  printf 'cd %q\n' "$PWD"
} >"$dir/environment"
printf '%q ' "$@" >"$dir/command"

# The guest's first process. It ends by writing the status and switching the machine off.
{
  printf '#!/bin/bash\ndir=%q interfaces=%q\n' "$dir" "$interfaces"
  cat <<'INIT'
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
power_off() { sync; echo o >/proc/sysrq-trigger; exec sleep 10; }  # the kernel ends while we wait
no_can() { echo "$1" >"$dir/no_can"; power_off; }

mount -t proc proc /proc
mount -t sysfs sys /sys
grep -q ' /dev devtmpfs' /proc/mounts || mount -t devtmpfs dev /dev
mkdir -p /dev/pts /dev/shm
mount -t devpts pts /dev/pts
mount -t tmpfs -o mode=1777 shm /dev/shm
mount -t tmpfs -o mode=755 run /run
stty -F /dev/tty1 raw -echo
stty -F /dev/tty2 raw -echo

# Debian keeps UML's modules outside /lib/modules, where modprobe would look.
version=$(uname -r)
mkdir -p "/run/uml/lib/modules/$version"
mount --bind "/usr/lib/uml/modules/$version" "/run/uml/lib/modules/$version"
for module in can can-raw vcan; do
  modprobe -d /run/uml "$module" || no_can "the guest kernel $version has no module $module"
done
ip link set lo up
for ((i = 0; i < interfaces; i++)); do
  ip link add "vcan$i" type vcan && ip link set "vcan$i" mtu 72 up || no_can "vcan$i could not be made"
done
: >"$dir/ready"
(
  . "$dir/environment"
  export BORESIGHT_UML=1 TMPDIR=/dev/shm
  eval "exec $(cat "$dir/command")"
) </dev/null >/dev/tty1 2>/dev/tty2
echo $? >"$dir/status"
stty -F /dev/tty1 sane
power_off
INIT
} >"$dir/init"
chmod +x "$dir/init"

# Console 1 is our stdout, console 2 our stderr; console 0 and the kernel's messages go to the log.
exec 3>&1 4>&2
# A guest keeps real time, and each of its system calls waits for a turn of this machine. So it gets a higher priority,
# if the user has the right.
first=()
! chrt --rr 1 true 2>/dev/null || first=(chrt --rr 1)
run_guest() {
  timeout -k 5 "$limit" "${first[@]}" env LD_PRELOAD="$preload" linux.uml mem="$memory" \
    root=/dev/root rootfstype=hostfs rootflags=/ rw init="$dir/init" con=null ssl=null con0=null,fd:1 \
    con1=null,fd:3 con2=null,fd:4 uml_dir="$dir/" umid=guest quiet random.trust_cpu=on </dev/null >"$dir/log" 2>&1 &
  guest=$!
}
is_running() { kill -0 "$guest" 2>/dev/null; }
has_begun() { [ -e "$dir/ready" ] || [ -e "$dir/no_can" ]; }

# A guest boots in 2 s, with a slow clock on a busy machine in 20 s. Very rarely a guest stops while it boots. Then
# another one is tried.
boot_limit=150
boots() {
  for ((waited = 0; waited < boot_limit; waited++)); do
    if has_begun || ! is_running; then return 0; fi
    sleep 1
  done
  return 1
}
for number in 1 2 3; do
  run_guest
  boots && break
  kill -TERM "$guest"
  wait "$guest"
  tail -n 20 "$dir/log" >&2
  echo "uml_can_run: guest $number of 3 did not boot in $boot_limit s, its log is above" >&2
  [ "$number" = 3 ] && exit 124
done
wait "$guest"
uml_status=$?
[ -z "$keep_log" ] || cp "$dir/log" "$keep_log"

[ -s "$dir/status" ] && exit "$(cat "$dir/status")"
[ -s "$dir/no_can" ] && skip "$(cat "$dir/no_can")"
tail -n 20 "$dir/log" >&2
if [ $uml_status = 124 ] || [ $uml_status = 137 ]; then
  echo "uml_can_run: stopped after $limit s, the log of the guest is above" >&2
  exit 124
fi
[ -e "$dir/ready" ] || skip "User-Mode Linux does not boot here (status $uml_status, its log is above)"
echo "uml_can_run: User-Mode Linux died under the command (status $uml_status, its log is above)" >&2
exit 125
