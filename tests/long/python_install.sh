#!/usr/bin/env bash
# The Python package from nothing: python/install.sh in a bare Debian 12, in a copy of the last commit, and a step of
# matrigrate.Simulation there. Builds everything: takes a while. Needs root, apt, the network and some 4 GB.
#   tests/long/python_install.sh
set -euo pipefail
source=$(realpath "$(dirname "$0")/../..")
. "$source/tests/long/bare_debian.sh"
mkdir "$root/srv/clone"
git -C "$source" archive HEAD | tar -x -C "$root/srv/clone"
in_root "cd /srv/clone && python/install.sh /srv/python"
in_root "cd /srv && MATRIGRATE=/srv/clone/build/release/bin/matrigrate python/bin/python -c 'import matrigrate
simulation = matrigrate.Simulation()
simulation.step()
print(simulation, matrigrate.run(matrigrate.Scenario(), out=\"run\", hours=0.02))'"
in_root "cd /srv/clone && cmake --install build/release --prefix /srv/prefix && /srv/prefix/bin/matrigrate selftest"
echo "the Python package installs in a bare Debian 12"
