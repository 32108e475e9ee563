# A clean Debian 12 in a folder, for scripts/packages-check.sh, which sets `root`, the folder, and reads this file.
# shellcheck shell=bash

# Debian's required packages and apt, nothing else.
make_root() {
  rm -rf --one-file-system "$root"
  mmdebstrap --mode=root --variant=minbase --quiet bookworm "$root"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
}

# in_root COMMAND...: runs it there. It has its own processes and mounts, which end with it. A compiler cache of this machine
# is seen there.
in_root() {
  # shellcheck disable=SC2016
  root=$root unshare --mount --pid --fork --kill-child bash -c '
    set -e
    mount -t proc proc "$root/proc"
    for device in null zero full random urandom; do
      touch "$root/dev/$device"
      mount --bind "/dev/$device" "$root/dev/$device"
    done
    mkdir -p "$root/dev/shm"
    mount -t tmpfs tmpfs "$root/dev/shm"
    if [ -n "${CCACHE_DIR:-}" ] && [ -d "$CCACHE_DIR" ]; then
      mkdir -p "$root/ccache"
      mount --bind "$CCACHE_DIR" "$root/ccache"
    fi
    exec chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb LC_ALL=C.UTF-8 \
      DEBIAN_FRONTEND=noninteractive CCACHE_DIR=/ccache CCACHE_COMPILERCHECK=content "$@"' in_root "$@"
}

# A script of bash there; what follows are its arguments.
shell_in_root() {
  local script=$1
  shift
  in_root bash -euo pipefail -c "$script" shell_in_root "$@"
}

install_in_root() { in_root apt-get install -y -qq --no-install-recommends "$@"; }

# The packages of the root, and its files but for those of apt, dpkg and logs.
installed_in_root() { in_root dpkg-query -W -f '${binary:Package}\n' | sort; }
files_in_root() {
  (cd "$root" && find . \( -path ./proc -o -path ./dev -o -path ./ccache -o -path ./packages -o -path ./source -o -path ./tmp \
    -o -path ./root -o -path ./var/cache -o -path ./var/log -o -path ./var/lib/apt -o -path ./var/lib/dpkg -o -path ./etc/ld.so.cache \) \
    -prune -o -print | sort)
}
