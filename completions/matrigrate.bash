# bash completion of matrigrate. Made from matrigrate --help by tools/from_help.py; do not edit.
# Put it into ~/.local/share/bash-completion/completions/matrigrate, or: source completions/matrigrate.bash

_matrigrate_files() { # -f or -d: names that may hold blanks
  local IFS=$'\n'
  COMPREPLY=($(compgen "$1" -- "$cur"))
  compopt -o filenames 2>/dev/null
}

_matrigrate() {
  local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} verb=matrigrate word
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case ${verb}_$word in
    matrigrate_new|matrigrate_check|matrigrate_explain|matrigrate_run|matrigrate_resume|matrigrate_report|matrigrate_open|matrigrate_export|matrigrate_diff|matrigrate_study|matrigrate_study_plan|matrigrate_study_run|matrigrate_study_status|matrigrate_study_collect|matrigrate_study_submit|matrigrate_study_task|matrigrate_tracks|matrigrate_list|matrigrate_live|matrigrate_info|matrigrate_demo|matrigrate_sample|matrigrate_reproduce|matrigrate_validate|matrigrate_selftest) verb=${verb}_$word ;;
    esac
  done
  case $verb:$previous in
  matrigrate_new:--preset) COMPREPLY=($(compgen -W "baseline second-closures soft stiff weak-contraction strong-contraction frequent-protrusions brief-adhesions long-protrusions sensitive-adhesions insensitive-adhesions fibrillar one-protrusion two-protrusions three-protrusions four-protrusions one-protrusion-fibres two-protrusions-fibres three-protrusions-fibres four-protrusions-fibres stiffness-gradient stiffness-step channel microtrack pillars walled-channel interface chemotaxis attractant-source openvt-migration openvt-chemotaxis-linear openvt-chemotaxis-half-normal openvt-chemotaxis-exponential haptotaxis contact-guidance curved-fibres two-cells fibroblast-fibrin ht1080-collagen mda-mb-231-collagen" -- "$cur")); return ;;
  matrigrate_new:--law) COMPREPLY=(); return ;;
  matrigrate_new:--schema) _matrigrate_files -f; return ;;
  matrigrate_check:--set) COMPREPLY=(); return ;;
  matrigrate_explain:--set) COMPREPLY=(); return ;;
  matrigrate_explain:--pictures) COMPREPLY=(); return ;;
  matrigrate_run:-o|matrigrate_run:--output) _matrigrate_files -d; return ;;
  matrigrate_run:--seed) COMPREPLY=(); return ;;
  matrigrate_run:--hours) COMPREPLY=(); return ;;
  matrigrate_run:--threads) COMPREPLY=(); return ;;
  matrigrate_run:--set) COMPREPLY=(); return ;;
  matrigrate_run:--wall-time) COMPREPLY=(); return ;;
  matrigrate_resume:-o|matrigrate_resume:--output) _matrigrate_files -d; return ;;
  matrigrate_resume:--at) COMPREPLY=(); return ;;
  matrigrate_resume:--set) COMPREPLY=(); return ;;
  matrigrate_resume:--seed) COMPREPLY=(); return ;;
  matrigrate_resume:--hours) COMPREPLY=(); return ;;
  matrigrate_resume:--threads) COMPREPLY=(); return ;;
  matrigrate_resume:--wall-time) COMPREPLY=(); return ;;
  matrigrate_report:--play) COMPREPLY=(); return ;;
  matrigrate_report:--tracks) COMPREPLY=(); return ;;
  matrigrate_report:--pixel) COMPREPLY=(); return ;;
  matrigrate_report:--interval) COMPREPLY=(); return ;;
  matrigrate_report:--time-unit) COMPREPLY=($(compgen -W "ms s min h d" -- "$cur")); return ;;
  matrigrate_report:--columns) COMPREPLY=(); return ;;
  matrigrate_report:--layout) COMPREPLY=($(compgen -W "celltrackscolab trackmate plain btrack trackpy mosaic manual-tracking mtrackj imaris cellprofiler napari celltrackr" -- "$cur")); return ;;
  matrigrate_report:--splits) COMPREPLY=($(compgen -W "refuse cut drop" -- "$cur")); return ;;
  matrigrate_report:--jitter) COMPREPLY=(); return ;;
  matrigrate_export:--times) COMPREPLY=(); return ;;
  matrigrate_export:--pixel) COMPREPLY=(); return ;;
  matrigrate_export:--panel) COMPREPLY=(); return ;;
  matrigrate_export:--fps) COMPREPLY=(); return ;;
  matrigrate_export:--seconds) COMPREPLY=(); return ;;
  matrigrate_export:--size) COMPREPLY=(); return ;;
  matrigrate_export:--layer) COMPREPLY=($(compgen -W "degradation displacement von_mises pressure fibre_von_mises" -- "$cur")); return ;;
  matrigrate_export:-o|matrigrate_export:--output) _matrigrate_files -d; return ;;
  matrigrate_study_plan:-o|matrigrate_study_plan:--output) _matrigrate_files -d; return ;;
  matrigrate_study_plan:--jobs) COMPREPLY=(); return ;;
  matrigrate_study_run:-o|matrigrate_study_run:--output) _matrigrate_files -d; return ;;
  matrigrate_study_run:--jobs) COMPREPLY=(); return ;;
  matrigrate_study_submit:-o|matrigrate_study_submit:--output) _matrigrate_files -d; return ;;
  matrigrate_study_submit:--account) COMPREPLY=(); return ;;
  matrigrate_study_submit:--partition) COMPREPLY=(); return ;;
  matrigrate_study_submit:--qos) COMPREPLY=(); return ;;
  matrigrate_study_submit:--time) COMPREPLY=(); return ;;
  matrigrate_study_submit:--mem) COMPREPLY=(); return ;;
  matrigrate_study_submit:--mail-user) COMPREPLY=(); return ;;
  matrigrate_study_submit:--throttle) COMPREPLY=(); return ;;
  matrigrate_study_submit:--cpus) COMPREPLY=(); return ;;
  matrigrate_study_submit:--chunk) COMPREPLY=(); return ;;
  matrigrate_study_submit:--launcher) COMPREPLY=(); return ;;
  matrigrate_study_task:--list) COMPREPLY=(); return ;;
  matrigrate_tracks:--beside) COMPREPLY=(); return ;;
  matrigrate_tracks:--pixel) COMPREPLY=(); return ;;
  matrigrate_tracks:--interval) COMPREPLY=(); return ;;
  matrigrate_tracks:--time-unit) COMPREPLY=($(compgen -W "ms s min h d" -- "$cur")); return ;;
  matrigrate_tracks:--columns) COMPREPLY=(); return ;;
  matrigrate_tracks:--layout) COMPREPLY=($(compgen -W "celltrackscolab trackmate plain btrack trackpy mosaic manual-tracking mtrackj imaris cellprofiler napari celltrackr" -- "$cur")); return ;;
  matrigrate_tracks:--splits) COMPREPLY=($(compgen -W "refuse cut drop" -- "$cur")); return ;;
  matrigrate_tracks:--jitter) COMPREPLY=(); return ;;
  matrigrate_tracks:--shortest) COMPREPLY=(); return ;;
  matrigrate_tracks:--fewest) COMPREPLY=(); return ;;
  matrigrate_tracks:--every) COMPREPLY=(); return ;;
  matrigrate_tracks:--error) COMPREPLY=(); return ;;
  matrigrate_tracks:--resamples) COMPREPLY=(); return ;;
  matrigrate_tracks:-o|matrigrate_tracks:--output) _matrigrate_files -d; return ;;
  matrigrate_live:-o|matrigrate_live:--output) _matrigrate_files -d; return ;;
  matrigrate_demo:-o|matrigrate_demo:--output) _matrigrate_files -d; return ;;
  matrigrate_demo:--preset) COMPREPLY=($(compgen -W "baseline second-closures soft stiff weak-contraction strong-contraction frequent-protrusions brief-adhesions long-protrusions sensitive-adhesions insensitive-adhesions fibrillar one-protrusion two-protrusions three-protrusions four-protrusions one-protrusion-fibres two-protrusions-fibres three-protrusions-fibres four-protrusions-fibres stiffness-gradient stiffness-step channel microtrack pillars walled-channel interface chemotaxis attractant-source openvt-migration openvt-chemotaxis-linear openvt-chemotaxis-half-normal openvt-chemotaxis-exponential haptotaxis contact-guidance curved-fibres two-cells fibroblast-fibrin ht1080-collagen mda-mb-231-collagen" -- "$cur")); return ;;
  matrigrate_demo:--hours) COMPREPLY=(); return ;;
  matrigrate_sample:--preset) COMPREPLY=($(compgen -W "baseline second-closures soft stiff weak-contraction strong-contraction frequent-protrusions brief-adhesions long-protrusions sensitive-adhesions insensitive-adhesions fibrillar one-protrusion two-protrusions three-protrusions four-protrusions one-protrusion-fibres two-protrusions-fibres three-protrusions-fibres four-protrusions-fibres stiffness-gradient stiffness-step channel microtrack pillars walled-channel interface chemotaxis attractant-source openvt-migration openvt-chemotaxis-linear openvt-chemotaxis-half-normal openvt-chemotaxis-exponential haptotaxis contact-guidance curved-fibres two-cells fibroblast-fibrin ht1080-collagen mda-mb-231-collagen" -- "$cur")); return ;;
  matrigrate_sample:--scenario) _matrigrate_files -f; return ;;
  matrigrate_sample:--targets) COMPREPLY=(); return ;;
  matrigrate_sample:--seed) COMPREPLY=(); return ;;
  matrigrate_sample:--hours) COMPREPLY=(); return ;;
  matrigrate_sample:--threads) COMPREPLY=(); return ;;
  matrigrate_reproduce:-o|matrigrate_reproduce:--output) _matrigrate_files -d; return ;;
  matrigrate_reproduce:--replicates) COMPREPLY=(); return ;;
  matrigrate_reproduce:--jobs) COMPREPLY=(); return ;;
  matrigrate_reproduce:--integrator) COMPREPLY=($(compgen -W "adaptive reference" -- "$cur")); return ;;
  matrigrate_reproduce:--set) COMPREPLY=(); return ;;
  matrigrate_reproduce:--from) _matrigrate_files -d; return ;;
  matrigrate_reproduce:--kept) COMPREPLY=(); return ;;
  matrigrate_validate:-o|matrigrate_validate:--output) _matrigrate_files -d; return ;;
  matrigrate_validate:--scenario) _matrigrate_files -f; return ;;
  matrigrate_validate:--set) COMPREPLY=(); return ;;
  matrigrate_selftest:--with) _matrigrate_files -f; return ;;
  esac
  case $verb in
  matrigrate)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --version" -- "$cur")); else COMPREPLY=($(compgen -W "new check explain run resume report open export diff study tracks list live info demo sample reproduce validate selftest" -- "$cur")); fi ;;
  matrigrate_new)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --preset --law --schema" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_check)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --set --json" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_explain)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --set --json --pictures" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_run)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --seed --hours --threads --set --wall-time --force --json --quiet" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_resume)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --at --set --seed --hours --threads --wall-time --previous --json --quiet" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_report)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --play --tracks --pixel --interval --time-unit --columns --layout --splits --jitter" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_open)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --print" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_export)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --fields --tracks --openvt --times --simularium --ome-tiff --pixel --png --panel --movie --fps --seconds --size --follow --whole --layer --output --force" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_diff)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --json" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_study)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help" -- "$cur")); else COMPREPLY=($(compgen -W "plan run status collect submit task" -- "$cur")); fi ;;
  matrigrate_study_plan)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --jobs --json" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_study_run)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --jobs --retry-failed --json --quiet" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_study_status)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --json" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_study_collect)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --json --quiet" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_study_submit)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --account --partition --qos --time --mem --mail-user --throttle --cpus --chunk --launcher --retry-failed --json" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_study_task)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --list" -- "$cur")); else _matrigrate_files -d; fi ;;
  matrigrate_tracks)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --beside --pixel --interval --time-unit --columns --layout --splits --jitter --shortest --fewest --drift --every --error --resamples --output --force --json --records" -- "$cur")); else _matrigrate_files -f; fi ;;
  matrigrate_list)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --parameters --schema-json --readouts-json" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_live)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --print --output" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_info)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --json" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_demo)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --preset --hours --no-open" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_sample)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --preset --scenario --targets --seed --hours --threads" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_reproduce)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --replicates --jobs --integrator --set --from --kept --json --quiet" -- "$cur")); else COMPREPLY=(); fi ;;
  matrigrate_validate)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --output --scenario --set --force --json --quiet" -- "$cur")); else COMPREPLY=($(compgen -W "patch rigid stretch creep relaxation point-force load poiseuille tearing convergence step-limit fibres fibres-uniaxial protrusion maturation time-step disassembly follow initiation all" -- "$cur")); fi ;;
  matrigrate_selftest)
    if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W "--help --with --json" -- "$cur")); else COMPREPLY=(); fi ;;
  esac
}

complete -F _matrigrate matrigrate
