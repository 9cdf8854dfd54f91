# fish completion of matrigrate. Made from matrigrate --help by tools/from_help.py; do not edit.
# Put it into ~/.config/fish/completions/.

# Whether the verbs typed so far are those given, and no more.
function __matrigrate_at
  set -l verbs
  for word in (commandline -opc)[2..]
    switch (string join -- _ matrigrate $verbs $word)
      case matrigrate_new matrigrate_check matrigrate_explain matrigrate_run matrigrate_resume matrigrate_report matrigrate_open matrigrate_export matrigrate_diff matrigrate_study matrigrate_study_plan matrigrate_study_run matrigrate_study_status matrigrate_study_collect matrigrate_study_submit matrigrate_study_task matrigrate_tracks matrigrate_list matrigrate_live matrigrate_info matrigrate_demo matrigrate_sample matrigrate_reproduce matrigrate_validate matrigrate_selftest
        set -a verbs $word
    end
  end
  test "$verbs" = "$argv"
end

complete -c matrigrate -f

complete -c matrigrate -n '__matrigrate_at' -a new -d 'Write a commented scenario file; never overwrites one'
complete -c matrigrate -n '__matrigrate_at' -a check -d 'Validate scenarios and studies; print every fault at once'
complete -c matrigrate -n '__matrigrate_at' -a explain -d 'What a scenario means and needs, before anything is computed'
complete -c matrigrate -n '__matrigrate_at' -a run -d 'Simulate a cell, or several; write tracks, protrusions, read-outs and a page'
complete -c matrigrate -n '__matrigrate_at' -a resume -d 'Resume a run from its last checkpoint, or branch off from it'
complete -c matrigrate -n '__matrigrate_at' -a report -d 'Make report.html of a run or a study anew, from its files'
complete -c matrigrate -n '__matrigrate_at' -a open -d 'Open the page of a run, a study or `reproduce` in the browser'
complete -c matrigrate -n '__matrigrate_at' -a export -d 'Write a run in other formats: tracks, fields, figures, a movie; of a study, its tracks'
complete -c matrigrate -n '__matrigrate_at' -a diff -d 'Compare two runs or two scenarios: parameters, read-outs, first difference'
complete -c matrigrate -n '__matrigrate_at' -a study -d 'Many runs: plan, compute, collect and compare them'
complete -c matrigrate -n '__matrigrate_at' -a tracks -d 'Read measured tracks of cells, and print their read-outs'
complete -c matrigrate -n '__matrigrate_at' -a list -d 'The presets, published laws, verification cases and studies that ship with the program'
complete -c matrigrate -n '__matrigrate_at' -a live -d 'Open the live page: a cell computed in the browser while you watch'
complete -c matrigrate -n '__matrigrate_at' -a info -d 'Version, commit, compiler, libraries and CPU'
complete -c matrigrate -n '__matrigrate_at' -a demo -d 'Simulate a cell for three hours, in about 20 s, and open its page'
complete -c matrigrate -n '__matrigrate_at' -a sample -d 'Simulate once with given parameters; print the read-outs as JSON'
complete -c matrigrate -n '__matrigrate_at' -a reproduce -d 'Run the paper\'s ensembles and judge its claims by them'
complete -c matrigrate -n '__matrigrate_at' -a validate -d 'Verify parts of the model against closed forms and measured limits'
complete -c matrigrate -n '__matrigrate_at' -a selftest -d 'Prove on this machine that runs are reproducible to the last bit'
complete -c matrigrate -n '__matrigrate_at' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at' -l version -d 'Display program version information and exit'

complete -c matrigrate -n '__matrigrate_at new' -F
complete -c matrigrate -n '__matrigrate_at new' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at new' -l preset -x -a 'baseline second-closures soft stiff weak-contraction strong-contraction frequent-protrusions brief-adhesions long-protrusions sensitive-adhesions insensitive-adhesions fibrillar one-protrusion two-protrusions three-protrusions four-protrusions one-protrusion-fibres two-protrusions-fibres three-protrusions-fibres four-protrusions-fibres stiffness-gradient stiffness-step channel microtrack pillars walled-channel interface chemotaxis attractant-source openvt-migration openvt-chemotaxis-linear openvt-chemotaxis-half-normal openvt-chemotaxis-exponential haptotaxis contact-guidance curved-fibres two-cells fibroblast-fibrin ht1080-collagen mda-mb-231-collagen' -d 'What to start from: a preset of `matrigrate list` (default: baseline)'
complete -c matrigrate -n '__matrigrate_at new' -l law -x -d 'Instead: a published law of `matrigrate list`, with its reference'
complete -c matrigrate -n '__matrigrate_at new' -l schema -r -F -d 'The JSON schema that the first line names for editors, seen from FILE (default: scenario.schema.json, which is then written beside FILE)'

complete -c matrigrate -n '__matrigrate_at check' -F
complete -c matrigrate -n '__matrigrate_at check' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at check' -l set -x -d 'key=value, over the files; may be repeated'
complete -c matrigrate -n '__matrigrate_at check' -l json -d 'Print the findings as JSON'

complete -c matrigrate -n '__matrigrate_at explain' -F
complete -c matrigrate -n '__matrigrate_at explain' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at explain' -l set -x -d 'key=value, over the file; may be repeated'
complete -c matrigrate -n '__matrigrate_at explain' -l json -d 'Print the numbers as JSON'
complete -c matrigrate -n '__matrigrate_at explain' -l pictures -x -d 'Draw the fields of the scenario into this new folder instead'

complete -c matrigrate -n '__matrigrate_at run' -F
complete -c matrigrate -n '__matrigrate_at run' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at run' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder for the results (default: <scenario>-seed<N>, and what --set changes)'
complete -c matrigrate -n '__matrigrate_at run' -l seed -x -d 'Seed of the random numbers: run.seed'
complete -c matrigrate -n '__matrigrate_at run' -l hours -x -d 'Simulated time in hours, or as "30 min": run.duration'
complete -c matrigrate -n '__matrigrate_at run' -l threads -x -d 'Threads, 0 for as many as pay: run.threads; never changes a result'
complete -c matrigrate -n '__matrigrate_at run' -l set -x -d 'key=value, over the file; may be repeated'
complete -c matrigrate -n '__matrigrate_at run' -l wall-time -x -d 'Stop with a checkpoint after this time of the clock: "2 h"'
complete -c matrigrate -n '__matrigrate_at run' -l force -d 'Start again in a folder that is not empty: files of an older run are removed, others are kept'
complete -c matrigrate -n '__matrigrate_at run' -l json -d 'Print the outcome as one JSON object'
complete -c matrigrate -n '__matrigrate_at run' -l quiet -d 'Show no progress; print only where the report is'

complete -c matrigrate -n '__matrigrate_at resume' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at resume' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at resume' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder for a branch (default: <FOLDER>-branch)'
complete -c matrigrate -n '__matrigrate_at resume' -l at -x -d 'Branch at this simulated time: "3 h"'
complete -c matrigrate -n '__matrigrate_at resume' -l set -x -d 'Branch with key=value; may be repeated'
complete -c matrigrate -n '__matrigrate_at resume' -l seed -x -d 'Branch with another seed: run.seed'
complete -c matrigrate -n '__matrigrate_at resume' -l hours -x -d 'Branch with another end: run.duration'
complete -c matrigrate -n '__matrigrate_at resume' -l threads -x -d 'Threads, 0 for as many as pay; never changes a result'
complete -c matrigrate -n '__matrigrate_at resume' -l wall-time -x -d 'Stop with a checkpoint after this time of the clock: "2 h"'
complete -c matrigrate -n '__matrigrate_at resume' -l previous -d 'Go on, or branch, from checkpoint_prev.h5'
complete -c matrigrate -n '__matrigrate_at resume' -l json -d 'Print the outcome as one JSON object'
complete -c matrigrate -n '__matrigrate_at resume' -l quiet -d 'Show no progress; print only where the report is'

complete -c matrigrate -n '__matrigrate_at report' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at report' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at report' -l play -x -d 'A run that the page of a study is to play, by the name of its folder; may be repeated'
complete -c matrigrate -n '__matrigrate_at report' -l tracks -x -d 'Measured tracks to draw over the simulated paths, each moved to their start: a file that matrigrate tracks reads, with the options of that verb'
complete -c matrigrate -n '__matrigrate_at report' -l pixel -x -d 'um per unit of length of the file of tracks, where it does not state um'
complete -c matrigrate -n '__matrigrate_at report' -l interval -x -d 'Time from frame to frame [s]'
complete -c matrigrate -n '__matrigrate_at report' -l time-unit -x -a 'ms s min h d' -d 'Unit of the column of time, where the file does not state it: ms, s, min, h or d'
complete -c matrigrate -n '__matrigrate_at report' -l columns -x -d 'Which columns hold what, where the names are not known: KEY=NAME,... of track, t, frame, x, y, z, group (separates movies), made_up, measured; of a table without header their numbers from 1; may be repeated'
complete -c matrigrate -n '__matrigrate_at report' -l layout -x -a 'celltrackscolab trackmate plain btrack trackpy mosaic manual-tracking mtrackj imaris cellprofiler napari celltrackr' -d 'Take the names of columns of one program alone: celltrackscolab, trackmate, plain, btrack, trackpy, mosaic, manual-tracking, mtrackj, ilastik, imaris, cellprofiler, napari, celltrackr'
complete -c matrigrate -n '__matrigrate_at report' -l splits -x -a 'refuse cut drop' -d 'Tracks with two positions at one time: refuse, cut (they end before) or drop (they are left out)'
complete -c matrigrate -n '__matrigrate_at report' -l jitter -x -d 'By which a step of time may differ from the interval, as a share of it'

complete -c matrigrate -n '__matrigrate_at open' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at open' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at open' -l print -d 'Only print where the page is'

complete -c matrigrate -n '__matrigrate_at export' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at export' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at export' -l fields -d 'fields.h5 and fields.xdmf for ParaView, also of a run that is not done yet'
complete -c matrigrate -n '__matrigrate_at export' -l tracks -d 'The path for celltrackR (CSV) and TrackMate (CSV, XML); of a study, all paths in one CSV'
complete -c matrigrate -n '__matrigrate_at export' -l openvt -d 'The positions of cells as OpenVT\'s table, with its records of simulation and simulator (JSON)'
complete -c matrigrate -n '__matrigrate_at export' -l times -x -d 'Of --openvt and --png: "every 10 min", or "0 h, 1 h, 3 h" (default: all times)'
complete -c matrigrate -n '__matrigrate_at export' -l simularium -d 'run.simularium for the viewer at simularium.allencell.org: cells, adhesions and matrix over time'
complete -c matrigrate -n '__matrigrate_at export' -l ome-tiff -d 'fields.ome.tif for Fiji and napari: the fields of all frames as a stack with times and scale'
complete -c matrigrate -n '__matrigrate_at export' -l pixel -x -d 'Of --ome-tiff: width of a pixel (default: the spacing of the particles, 2 um)'
complete -c matrigrate -n '__matrigrate_at export' -l png -d 'A picture of each frame, as PNG and SVG: frame_0036.png'
complete -c matrigrate -n '__matrigrate_at export' -l panel -x -d 'panel.svg for a publication: frames at these times side by side, "0 h, 1 h, 3 h, 6 h"'
complete -c matrigrate -n '__matrigrate_at export' -l movie -d 'movie.mp4 of the player\'s view'
complete -c matrigrate -n '__matrigrate_at export' -l fps -x -d 'Of --movie: pictures a second (default: 30)'
complete -c matrigrate -n '__matrigrate_at export' -l seconds -x -d 'Of --movie: how long it takes (default: a second for 15 min of the run)'
complete -c matrigrate -n '__matrigrate_at export' -l size -x -d 'Of --movie and --png: width and height in pixels (default: 1280x720)'
complete -c matrigrate -n '__matrigrate_at export' -l follow -d 'Of --movie: the view stays on the cell, as with --png'
complete -c matrigrate -n '__matrigrate_at export' -l whole -d 'Of --png: the whole matrix, not the cell'
complete -c matrigrate -n '__matrigrate_at export' -l layer -x -a 'degradation displacement von_mises pressure fibre_von_mises' -d 'What the matrix is coloured by (default: displacement; of --movie degradation)'
complete -c matrigrate -n '__matrigrate_at export' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder to write into (default: DIR/export)'
complete -c matrigrate -n '__matrigrate_at export' -l force -d 'Replace an earlier export of the same kind'

complete -c matrigrate -n '__matrigrate_at diff' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at diff' -l json -d 'Print the comparison as JSON'

complete -c matrigrate -n '__matrigrate_at study' -a plan -d 'Points, runs, expected time and disk; writes nothing'
complete -c matrigrate -n '__matrigrate_at study' -a run -d 'Compute what is missing, several runs at a time; then collect'
complete -c matrigrate -n '__matrigrate_at study' -a status -d 'How many runs are done, how far others are, and why some are not done'
complete -c matrigrate -n '__matrigrate_at study' -a collect -d 'Gather results and statistics of the runs that are done, at any time'
complete -c matrigrate -n '__matrigrate_at study' -a submit -d 'Hand what is missing to Slurm, as a job array'
complete -c matrigrate -n '__matrigrate_at study' -a task -d 'One task of a job array; called by submit.sh'
complete -c matrigrate -n '__matrigrate_at study' -s h -l help -d 'Print this help message and exit'

complete -c matrigrate -n '__matrigrate_at study plan' -F
complete -c matrigrate -n '__matrigrate_at study plan' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at study plan' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder of the study (default: <file>-study)'
complete -c matrigrate -n '__matrigrate_at study plan' -l jobs -x -d 'Runs at a time, one thread each, or more where they are fewer (default: the number of cores)'
complete -c matrigrate -n '__matrigrate_at study plan' -l json -d 'Print the plan as JSON: points with their settings, runs with their seeds'

complete -c matrigrate -n '__matrigrate_at study run' -F
complete -c matrigrate -n '__matrigrate_at study run' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at study run' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder of the study (default: <file>-study)'
complete -c matrigrate -n '__matrigrate_at study run' -l jobs -x -d 'Runs at a time, one thread each, or more where they are fewer (default: the number of cores)'
complete -c matrigrate -n '__matrigrate_at study run' -l retry-failed -d 'Compute again also what failed numerically; it will fail again unless the program has changed'
complete -c matrigrate -n '__matrigrate_at study run' -l json -d 'Print the outcome as one JSON object'
complete -c matrigrate -n '__matrigrate_at study run' -l quiet -d 'Show no progress'

complete -c matrigrate -n '__matrigrate_at study status' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at study status' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at study status' -l json -d 'Print it as one JSON object'

complete -c matrigrate -n '__matrigrate_at study collect' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at study collect' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at study collect' -l json -d 'Print the outcome as one JSON object'
complete -c matrigrate -n '__matrigrate_at study collect' -l quiet -d 'Print no tables'

complete -c matrigrate -n '__matrigrate_at study submit' -F
complete -c matrigrate -n '__matrigrate_at study submit' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at study submit' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder of the study (default: <file>-study)'
complete -c matrigrate -n '__matrigrate_at study submit' -l account -x -d 'Slurm\'s account that the time is charged to'
complete -c matrigrate -n '__matrigrate_at study submit' -l partition -x -d 'Slurm\'s partition, or several with commas between'
complete -c matrigrate -n '__matrigrate_at study submit' -l qos -x -d 'Slurm\'s quality of service'
complete -c matrigrate -n '__matrigrate_at study submit' -l time -x -d 'Time limit of a task, as in 12:00:00'
complete -c matrigrate -n '__matrigrate_at study submit' -l mem -x -d 'Memory of a task, as in 500M'
complete -c matrigrate -n '__matrigrate_at study submit' -l mail-user -x -d 'Address that Slurm mails to when the job ends or fails'
complete -c matrigrate -n '__matrigrate_at study submit' -l throttle -x -d 'Largest number of tasks at a time (default: as Slurm decides)'
complete -c matrigrate -n '__matrigrate_at study submit' -l cpus -x -d 'Threads per task; never changes a result (default: 1)'
complete -c matrigrate -n '__matrigrate_at study submit' -l chunk -x -d 'Runs per task, one after the other (default: as few as fit into 1000 tasks)'
complete -c matrigrate -n '__matrigrate_at study submit' -l launcher -x -d 'What a task calls in place of this program, as in "apptainer exec /lab/x.sif matrigrate"'
complete -c matrigrate -n '__matrigrate_at study submit' -l retry-failed -d 'Compute again also what failed numerically; it will fail again unless the program has changed'
complete -c matrigrate -n '__matrigrate_at study submit' -l json -d 'Print {folder, job, runs, tasks}'

complete -c matrigrate -n '__matrigrate_at study task' -a '(__fish_complete_directories)'
complete -c matrigrate -n '__matrigrate_at study task' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at study task' -l list -x -d 'Which run belongs to which task, a file in the folder'

complete -c matrigrate -n '__matrigrate_at tracks' -F
complete -c matrigrate -n '__matrigrate_at tracks' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at tracks' -l beside -x -d 'Folder of a run or a study: writes a page (-o, default beside.html) with paths, mean square displacements and distributions of all files and of the model, at the interval, duration and --error of the files'
complete -c matrigrate -n '__matrigrate_at tracks' -l pixel -x -d 'um per unit of length of the file of tracks, where it does not state um'
complete -c matrigrate -n '__matrigrate_at tracks' -l interval -x -d 'Time from frame to frame [s]'
complete -c matrigrate -n '__matrigrate_at tracks' -l time-unit -x -a 'ms s min h d' -d 'Unit of the column of time, where the file does not state it: ms, s, min, h or d'
complete -c matrigrate -n '__matrigrate_at tracks' -l columns -x -d 'Which columns hold what, where the names are not known: KEY=NAME,... of track, t, frame, x, y, z, group (separates movies), made_up, measured; of a table without header their numbers from 1; may be repeated'
complete -c matrigrate -n '__matrigrate_at tracks' -l layout -x -a 'celltrackscolab trackmate plain btrack trackpy mosaic manual-tracking mtrackj imaris cellprofiler napari celltrackr' -d 'Take the names of columns of one program alone: celltrackscolab, trackmate, plain, btrack, trackpy, mosaic, manual-tracking, mtrackj, ilastik, imaris, cellprofiler, napari, celltrackr'
complete -c matrigrate -n '__matrigrate_at tracks' -l splits -x -a 'refuse cut drop' -d 'Tracks with two positions at one time: refuse, cut (they end before) or drop (they are left out)'
complete -c matrigrate -n '__matrigrate_at tracks' -l jitter -x -d 'By which a step of time may differ from the interval, as a share of it'
complete -c matrigrate -n '__matrigrate_at tracks' -l shortest -x -d 'Leave tracks of fewer positions out (default 4)'
complete -c matrigrate -n '__matrigrate_at tracks' -l fewest -x -d 'Refuse fewer tracks (default 2)'
complete -c matrigrate -n '__matrigrate_at tracks' -l drift -d 'Take the mean motion of all tracks away, where five go on together'
complete -c matrigrate -n '__matrigrate_at tracks' -l every -x -d 'Take positions at a longer interval [s], a whole multiple'
complete -c matrigrate -n '__matrigrate_at tracks' -l error -x -d 'Localisation error of a coordinate [um], taken off the mean square displacement; with --beside added to simulated coordinates'
complete -c matrigrate -n '__matrigrate_at tracks' -l resamples -x -d 'Draws of the bootstrap (default 200)'
complete -c matrigrate -n '__matrigrate_at tracks' -s o -l output -x -a '(__fish_complete_directories)' -d 'Write the tracks into this CSV file; with --beside the page'
complete -c matrigrate -n '__matrigrate_at tracks' -l force -d 'Replace that file'
complete -c matrigrate -n '__matrigrate_at tracks' -l json -d 'Print JSON'
complete -c matrigrate -n '__matrigrate_at tracks' -l records -d 'Name options in notes and faults as {interval S}, for who words them'

complete -c matrigrate -n '__matrigrate_at list' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at list' -l parameters -d 'Instead: all parameters, as a Markdown table a section'
complete -c matrigrate -n '__matrigrate_at list' -l schema-json -d 'Instead: the JSON schema of a scenario file, for editors'
complete -c matrigrate -n '__matrigrate_at list' -l readouts-json -d 'Instead: all read-outs with label, unit and meaning, as JSON'

complete -c matrigrate -n '__matrigrate_at live' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at live' -l print -d 'Only print where the page is'
complete -c matrigrate -n '__matrigrate_at live' -s o -l output -x -a '(__fish_complete_directories)' -d 'Copy the page to this file instead; never overwrites one'

complete -c matrigrate -n '__matrigrate_at info' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at info' -l json -d 'Print it as JSON'

complete -c matrigrate -n '__matrigrate_at demo' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at demo' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder for the results (default: matrigrate-demo, or -2, -3, ...)'
complete -c matrigrate -n '__matrigrate_at demo' -l preset -x -a 'baseline second-closures soft stiff weak-contraction strong-contraction frequent-protrusions brief-adhesions long-protrusions sensitive-adhesions insensitive-adhesions fibrillar one-protrusion two-protrusions three-protrusions four-protrusions one-protrusion-fibres two-protrusions-fibres three-protrusions-fibres four-protrusions-fibres stiffness-gradient stiffness-step channel microtrack pillars walled-channel interface chemotaxis attractant-source openvt-migration openvt-chemotaxis-linear openvt-chemotaxis-half-normal openvt-chemotaxis-exponential haptotaxis contact-guidance curved-fibres two-cells fibroblast-fibrin ht1080-collagen mda-mb-231-collagen' -d 'What is simulated: see `matrigrate list` (default: baseline)'
complete -c matrigrate -n '__matrigrate_at demo' -l hours -x -d 'Simulated time in hours (default: 3)'
complete -c matrigrate -n '__matrigrate_at demo' -l no-open -d 'Do not open the page'

complete -c matrigrate -n '__matrigrate_at sample' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at sample' -l preset -x -a 'baseline second-closures soft stiff weak-contraction strong-contraction frequent-protrusions brief-adhesions long-protrusions sensitive-adhesions insensitive-adhesions fibrillar one-protrusion two-protrusions three-protrusions four-protrusions one-protrusion-fibres two-protrusions-fibres three-protrusions-fibres four-protrusions-fibres stiffness-gradient stiffness-step channel microtrack pillars walled-channel interface chemotaxis attractant-source openvt-migration openvt-chemotaxis-linear openvt-chemotaxis-half-normal openvt-chemotaxis-exponential haptotaxis contact-guidance curved-fibres two-cells fibroblast-fibrin ht1080-collagen mda-mb-231-collagen' -d 'What they change: see `matrigrate list` (default: baseline)'
complete -c matrigrate -n '__matrigrate_at sample' -l scenario -r -F -d 'Change this scenario file instead'
complete -c matrigrate -n '__matrigrate_at sample' -l targets -x -d 'Measured read-outs, from which the distance is computed'
complete -c matrigrate -n '__matrigrate_at sample' -l seed -x -d 'Seed of the random numbers: run.seed'
complete -c matrigrate -n '__matrigrate_at sample' -l hours -x -d 'Simulated time in hours, or as "30 min": run.duration'
complete -c matrigrate -n '__matrigrate_at sample' -l threads -x -d 'Threads, 0 for as many as pay: run.threads; never changes a result'

complete -c matrigrate -n '__matrigrate_at reproduce' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at reproduce' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder for studies and verdicts (default: reproduce)'
complete -c matrigrate -n '__matrigrate_at reproduce' -l replicates -x -d 'Runs at each point (default: as many as the paper)'
complete -c matrigrate -n '__matrigrate_at reproduce' -l jobs -x -d 'Runs at a time, one thread each (default: the number of cores)'
complete -c matrigrate -n '__matrigrate_at reproduce' -l integrator -x -a 'adaptive reference' -d 'adaptive (default) or reference'
complete -c matrigrate -n '__matrigrate_at reproduce' -l set -x -d 'key=value, over all studies; may be repeated'
complete -c matrigrate -n '__matrigrate_at reproduce' -l from -x -a '(__fish_complete_directories)' -d 'Folder with kept tables (<study>-results.csv) to judge by; nothing is run'
complete -c matrigrate -n '__matrigrate_at reproduce' -l kept -x -d 'Folder with kept tables (<study>-results.csv): their runs are not made again'
complete -c matrigrate -n '__matrigrate_at reproduce' -l json -d 'Print the table as JSON'
complete -c matrigrate -n '__matrigrate_at reproduce' -l quiet -d 'Show no progress'

complete -c matrigrate -n '__matrigrate_at validate' -a 'patch rigid stretch creep relaxation point-force load poiseuille tearing convergence step-limit fibres fibres-uniaxial protrusion maturation time-step disassembly follow initiation all'
complete -c matrigrate -n '__matrigrate_at validate' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at validate' -s o -l output -x -a '(__fish_complete_directories)' -d 'Folder for the results (default: validate-NAME)'
complete -c matrigrate -n '__matrigrate_at validate' -l scenario -r -F -d 'Take material and numerics from this scenario file'
complete -c matrigrate -n '__matrigrate_at validate' -l set -x -d 'key=value, over the scenario; may be repeated'
complete -c matrigrate -n '__matrigrate_at validate' -l force -d 'Write into a folder that is not empty: files of the same name are replaced, others are kept'
complete -c matrigrate -n '__matrigrate_at validate' -l json -d 'Print the results as JSON'
complete -c matrigrate -n '__matrigrate_at validate' -l quiet -d 'Print only the verdict'

complete -c matrigrate -n '__matrigrate_at selftest' -s h -l help -d 'Print this help message and exit'
complete -c matrigrate -n '__matrigrate_at selftest' -l with -r -F -d 'Compare with another build of the program, which must give the same bits'
complete -c matrigrate -n '__matrigrate_at selftest' -l json -d 'Print one JSON object'
