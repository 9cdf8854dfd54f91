#!/usr/bin/env bash
# Builds the documentation site, and installs what that needs: mkdocs, its theme and KaTeX, from Debian.
#   tools/site.sh FOLDER [PROGRAM]    with the program, the gallery holds report pages of short runs (half a minute)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
[ $# -ge 1 ] || {
  sed -n '2,4s/^# *//p' "$0" >&2
  exit 2
}
. "$here/setup.sh"
install_packages "$packages_for_site"
live=$here/../build/web/live/index.html
[ -e "$live" ] || live=$here/../live/index.html
exec /usr/bin/python3 -B "$here/site/build.py" "$1" ${2:+--program "$2"} --live "$live"
