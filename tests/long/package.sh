#!/usr/bin/env bash
# Installs the Debian package in a bare Debian 12 and uses it there: a run, the run in Python, a study. Needs root, apt and
# some 700 MB.
#   tests/long/package.sh PACKAGE.deb
set -euo pipefail
package=$(realpath "$1")
[ "$(id -u)" -eq 0 ] || { echo "needs root, for chroot" >&2; exit 1; }
command -v debootstrap >/dev/null || apt-get install -y --no-install-recommends debootstrap
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | head -1)
debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}"
[ ! -d /etc/apt/apt.conf.d ] || cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/" # proxies
cp "$package" "$root/matrigrate.deb"
in_root() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/srv LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -euc "$1"; }
in_root "apt-get update -q && apt-get install -y -q /matrigrate.deb"
in_root "matrigrate selftest"
in_root "cd /srv && matrigrate new cell.toml && matrigrate run cell.toml --hours 0.1 --quiet && test -s cell-seed1/report.html"
in_root "cd /srv && python3 -c 'import matrigrate; print(matrigrate.load(\"cell-seed1\").readouts.v_migr_abs_um_per_h)'"
in_root "cd /srv && matrigrate check /usr/share/matrigrate/studies/stiffness.toml"
in_root "man -w matrigrate 2>/dev/null || test -e /usr/share/man/man1/matrigrate.1 -o -e /usr/share/man/man1/matrigrate.1.gz || echo 'manual pages are left out of this root'"
echo "the package works in a bare Debian 12"
