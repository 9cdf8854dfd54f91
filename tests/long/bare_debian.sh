#!/usr/bin/env bash
# Installs from nothing in a bare Debian 12 and uses what is installed:
#   tests/long/bare_debian.sh package FILE.deb   the Debian package: a run, the run in Python, a study, and the steps of docs/tutorial.md
#                                                and docs/python.md as they are written (those in R are left out); some 1.5 GB
#   tests/long/bare_debian.sh python             python/install.sh in a copy of the last commit, and a step of matrigrate.Simulation there;
#                                                builds everything: takes a while and some 4 GB
# Needs root, apt, the network and debootstrap, which it gets. What this system needs to reach the network holds there as well: apt's
# settings, variables of proxies and of npm's registry, certificates of its own.
set -euo pipefail
source=$(realpath "$(dirname "$0")/../..")
what=${1:-}
case $what in
package) package=$(realpath "${2:?which .deb?}") ;;
python) ;;
*) sed -n '2,8s/^# //p' "$0" >&2; exit 2 ;;
esac
[ "$(id -u)" -eq 0 ] || { echo "needs root, for chroot" >&2; exit 1; }
command -v debootstrap >/dev/null || apt-get install -y --no-install-recommends debootstrap
root=$(mktemp -d)
trap 'umount "$root/proc" 2>/dev/null || true; rm -rf --one-file-system "$root"' EXIT
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Codename: bookworm' | head -1)
debootstrap --variant=minbase bookworm "$root" "${mirror:-http://deb.debian.org/debian}"
[ ! -d /etc/apt/apt.conf.d ] || cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/" # proxies
mkdir -p "$root/usr/local/share/ca-certificates" # which the package ca-certificates takes in
[ ! -d /usr/local/share/ca-certificates ] || cp -rL /usr/local/share/ca-certificates/. "$root/usr/local/share/ca-certificates/"
forwarded=(NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt)
for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY npm_config_registry NPM_CONFIG_REGISTRY; do
  [ -z "${!name:-}" ] || forwarded+=("$name=${!name}")
done
mountpoint -q "$root/proc" || mount -t proc proc "$root/proc"
in_root() { chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/srv LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive "${forwarded[@]}" bash -euc "$1"; }

if [ "$what" = package ]; then
  cp "$package" "$root/matrigrate.deb"
  recommended=$(dpkg-deb --field "$package" Recommends | tr -d ,) # those of the package, and not all that these recommend
  in_root "apt-get update -q && apt-get install -y -q --no-install-recommends /matrigrate.deb $recommended"
  in_root "matrigrate selftest"
  in_root "cd /srv && matrigrate new cell.toml && matrigrate run cell.toml --hours 0.1 --quiet && test -s cell-seed1/report.html"
  in_root "cd /srv && python3 -c 'import matrigrate; print(matrigrate.load(\"cell-seed1\").readouts.v_migr_abs_um_per_h)'"
  in_root "cd /srv && matrigrate check /usr/share/matrigrate/studies/stiffness.toml"
  pages=$root/srv/pages # a clone as far as the pages need it, with what the package installed in place of python/ and R/
  mkdir -p "$pages/tests"
  cp -r "$source/docs" "$pages/docs"
  cp -r "$source/tests/docs" "$source/tests/python" "$pages/tests/"
  ln -s /usr/lib/python3/dist-packages "$pages/python"
  ln -s /usr/share/matrigrate/R "$pages/R"
  in_root "cd /srv && MATRIGRATE=/usr/bin/matrigrate python3 -B pages/tests/docs/test_page.py docs/tutorial.md"
  in_root "cd /srv && MATRIGRATE=/usr/bin/matrigrate MATRIGRATE_SMALL_RUNS=none python3 -B pages/tests/python/test_tutorial.py"
  in_root "cd /srv && python3 -c 'import matrigrate; simulation = matrigrate.Simulation(); simulation.step(); print(simulation)'"
  in_root "cd /usr/share/doc/matrigrate && test -s CITATION.cff -a -s MODEL.md -a -s docs/tutorial.md -a -s examples/04_my_force.cpp"
  in_root "cd /srv && matrigrate study submit /usr/share/matrigrate/studies/stiffness.toml -o s --launcher 'apptainer exec x.sif matrigrate' 2>/dev/null || test \$? -eq 5 && grep -q '^program=(apptainer exec x.sif matrigrate)$' s/submit.sh"
  in_root "man -w matrigrate 2>/dev/null || test -e /usr/share/man/man1/matrigrate.1 -o -e /usr/share/man/man1/matrigrate.1.gz || echo 'manual pages are left out of this root'"
  echo "the package works in a bare Debian 12"
else
  mkdir "$root/srv/clone"
  git -C "$source" archive HEAD | tar -x -C "$root/srv/clone"
  in_root "cd /srv/clone && python/install.sh /srv/python"
  in_root "cd /srv && MATRIGRATE=/srv/clone/build/release/bin/matrigrate python/bin/python -c 'import matrigrate
simulation = matrigrate.Simulation()
simulation.step()
print(simulation, matrigrate.run(matrigrate.Scenario(), out=\"run\", hours=0.02))'"
  in_root "cd /srv/clone && cmake --install build/release --prefix /srv/prefix && /srv/prefix/bin/matrigrate selftest"
  echo "the Python package installs in a bare Debian 12"
fi
