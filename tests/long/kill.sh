#!/usr/bin/env bash
# Ends runs at random moments by a signal and resumes them: every file must be that of the run without a break. Takes
# scenarios with fibres, obstacles, fields, cues, several cells, nuclei and changes in turn; runs have one thread and are
# resumed with two, or the other way round. A run with changes is ended between its two changes.
#   tests/long/kill.sh PROGRAM [TIMES] [SIGNAL...]      (4 times each scenario by KILL and 4 by TERM by default)
# Times of the clock stand in run.json, report.html and checkpoints. Of run.json status, fingerprints and the like are
# compared, of checkpoints every array and text but for the time that the steps took, the number of threads and how
# often neighbour lists were made, of report.html and of checkpoint_prev.h5, which may be of another time, that they are
# there.
# SCENARIOS="cues all" in the environment: these alone. Needs Debian's python3-h5py.
set -euo pipefail
program=$(realpath "$1")
times=${2:-4}
signals=(KILL TERM)
[ $# -le 2 ] || signals=("${@:3}")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

cat >compare.py <<'END'
import json, pathlib, sys
import h5py

told = ("status", "exit_code", "reason", "seed", "steps", "t_s", "trajectory_hash", "configuration_hash", "frames_lost")

def without_threads(scenario):
    return [line for line in scenario.split(b"\n") if not line.startswith(b"threads")]

def content(file):
    if file.name == "run.json":
        return {key: json.loads(file.read_text())[key] for key in told}
    if file.name in ("report.html", "checkpoint_prev.h5"):
        return None
    if file.name == "scenario.resolved.toml":
        return without_threads(file.read_bytes())
    if not file.name.endswith(".h5") or file.name == "fields.h5":
        return file.read_bytes()
    arrays = {}
    h5py.File(file).visititems(lambda name, data: arrays.update({name: data[()].tobytes()}) if hasattr(data, "shape") else None)
    memory = json.loads(arrays.pop("memory.json"))
    del memory["march_wall_time_s"]
    memory["counts"].pop()  # updates of neighbour lists, which a resumed run makes anew
    return arrays, memory, without_threads(arrays.pop("scenario.toml"))

def files(folder):
    return {file.relative_to(folder): content(file) for file in pathlib.Path(folder).rglob("*") if file.is_file() and file.name != ".lock"}

a, b = files("whole"), files("here")
wrong = [str(name) for name in sorted(a.keys() | b.keys()) if name not in a or name not in b or a[name] != b[name]]
print(len(a), *wrong)
END
python3 - <<'END'
places = [(x, y) for y in range(-80, 81, 20) for x in range(-80, 81, 20)]
open("stiffness.csv", "w").write("x_um,y_um,E_Pa\n" + "".join(f"{x},{y},{200 + x}\n" for x, y in places))
END
common='[run]
duration = "0.1 h"
[protrusion]
initiation_rate = "4e-4 1/s"
[ecm]
radius = "60 um"
[output]
track_interval = "4 s"
field_interval = "11 s"
checkpoint_interval = "7 s"
kept_checkpoint_interval = "60 s"'
fibres='[fibres]
arrangement = "isotropic"'
obstacle='obstacle = "(x-2)^2+(y-42)^2 < 60 ? 1 : 0"'
stiffness='youngs_modulus = "stiffness.csv"'
attractant='attractant = "max(0, 1 + x/60)"'
cues='[cues]
diffusion = "5 um^2/s"
[laws]
initiation_bias = "exp(2*occupancy)"'
nucleus='[nucleus]
radius = "6 um"'
cells='[[cells]]
x = "-22 um"
y = "0 um"
[[cells]]
x = "22 um"
y = "0 um"'
changes='[[changes]]
at = "20 s"
actomyosin.force = "0.3 nN"
ecm.youngs_modulus = "400 Pa"
protrusion.initiation_rate = "2e-3 1/s"
[[changes]]
at = "340 s"
actomyosin.force = "0.6 nN"
laws.growth_force = "0.5"'
fields='[ecm.fields]'
scenario() { printf '%s\n' "$common" "${@:2}" >"$1.toml"; }
scenario plain
scenario fibres "$fibres"
scenario obstacle "$fields" "$obstacle"
scenario formula "$fields" 'youngs_modulus = "max(50, 200 + 2*x)"' 'ligand = "max(0.2, 1 + x/60)"'
scenario file "$fields" "$stiffness"
scenario cues "$fields" "$attractant" "$cues"
scenario cells "$cells"
scenario nucleus "$nucleus"
scenario changes "$changes"
scenario all "$fields" "$stiffness" "$obstacle" "$attractant" "$fibres" "$cues" "$nucleus" "$cells"
sed -i 's/^radius = "60 um"/radius = "75 um"/' cells.toml all.toml # else one of the cells reaches the rim

failed=0 runs=0 broken_off=0 compared=0
for scenario in ${SCENARIOS:-plain fibres obstacle formula file cues cells nucleus changes all}; do
  begin=$(date +%s%N)
  "$program" run $scenario.toml -o whole --quiet >/dev/null
  wall=$((($(date +%s%N) - begin) / 1000000)) # [ms]
  for signal in "${signals[@]}"; do
    for _ in $(seq "$times"); do
      after=$((RANDOM * 32768 + RANDOM))
      after=$((after % wall))
      threads=$((1 + runs % 2))
      "$program" run $scenario.toml -o here --quiet --threads $threads >/dev/null 2>&1 &
      process=$!
      if [ $scenario = changes ]; then
        when="$((24 + after % 290)) s of the run"
        until awk -F, -v "t=${when%% *}" 'END { exit !($2 + 0 >= t) }' here/tracks.csv 2>/dev/null; do
          kill -0 $process 2>/dev/null && sleep 0.02 || break
        done
      else
        when="$after ms"
        sleep "$(printf '%d.%03d' $((after / 1000)) $((after % 1000)))"
      fi
      kill -s "$signal" $process 2>/dev/null && broken_off=$((broken_off + 1))
      wait $process 2>/dev/null || true
      "$program" run $scenario.toml -o here --quiet --threads $((3 - threads)) >/dev/null
      read -r count wrong <<<"$(/usr/bin/python3 compare.py)"
      runs=$((runs + 1)) compared=$((compared + count))
      [ -z "$wrong" ] || { echo "$scenario, $signal after $when: differs or is not there: $wrong" && failed=$((failed + 1)); }
      rm -rf here
    done
  done
  rm -rf whole
  echo "$scenario: $((times * ${#signals[@]})) runs of $wall ms"
done
echo "$runs runs, $broken_off of them broken off; $compared files compared; $failed runs differ"
[ $failed = 0 ]
