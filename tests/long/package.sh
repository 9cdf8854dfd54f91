#!/usr/bin/env bash
# Installs the Debian package in a bare Debian 12 and uses it there: a run, the run in Python, a study, and the steps of
# docs/tutorial.md and docs/python.md as they are written (those in R are left out). Needs root, apt and some 1.5 GB.
#   tests/long/package.sh PACKAGE.deb
set -euo pipefail
package=$(realpath "$1")
source=$(realpath "$(dirname "$0")/../..")
. "$source/tests/long/bare_debian.sh"
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
