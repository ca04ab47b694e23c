#!/usr/bin/env bash
# other_releases.sh [SUITE...]: builds and tests as scripts/test.sh --thorough does in a fresh
# installation of each release of Debian: trixie by default, for its PCL 1.15. Takes an hour, and
# 8 GB where temporary files go. Exit 1 where a test fails; 77 where it cannot be tried: not root,
# or no debootstrap.
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
if [ "$(id -u)" -ne 0 ] || ! command -v debootstrap >/dev/null; then
  echo "Skipped: needs root and debootstrap to install other releases of Debian."
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
data=${PCL_RGBD_PLANES_DATA:-$source/../shared/data}

for suite in "${@:-trixie}"; do
  echo "== Installing $suite"
  root=$work/$suite
  debootstrap --variant=minbase "$suite" "$root" >"$work/log" 2>&1 ||
    { tail "$work/log"; exit 1; }
  cp /etc/resolv.conf "$root/etc"
  mkdir -p "$root/pcl_rgbd_planes" "$root/shared/data"
  git -C "$source" ls-files -z | tar -C "$source" --create --null --files-from - |
    tar -C "$root/pcl_rgbd_planes" --extract
  # What is mounted and what runs ends with the namespaces.
  unshare --mount --pid --fork --kill-child bash -euc '
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    [ ! -d "$2" ] || mount --bind "$2" "$1/shared/data"
    exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
      chroot "$1" bash /pcl_rgbd_planes/scripts/test.sh --thorough' bash "$root" "$data"
  rm -rf --one-file-system "$root"
done
