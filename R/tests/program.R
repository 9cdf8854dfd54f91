# Calls of the program, which a script stands in for: its words, its exit codes as errors.
library(matrigrate)

caught <- function(expression) tryCatch({ expression; NULL }, matrigrate_error = identity)
stand_in <- function(...) {
  file <- tempfile("a program ")
  writeLines(c("#!/bin/sh", ...), file)
  Sys.chmod(file, "755")
  Sys.setenv(MATRIGRATE = file)
}

words <- tempfile("words")
stand_in(paste0("printf '%s\\n' \"$@\" >'", words, "'"), "echo '{'", "echo '  \"folder\": \"a \\\"b\\\"\",'", "echo '}'")
folder <- run_matrigrate("my cell.toml",
  seed = 1e15, out = "a \"b\"", hours = 0.1,
  set = list(ecm.youngs_modulus = "50 Pa", protrusion.initiation_rate = 5e-4, output.report = FALSE), force = TRUE
)
stopifnot(
  identical(folder, "a \"b\""),
  identical(readLines(words), c(
    "run", "my cell.toml", "--json", "--quiet", "--seed", "1000000000000000", "-o", "a \"b\"", "--hours", "0.1", "--force",
    "--set", "ecm.youngs_modulus=50 Pa", "--set", "protrusion.initiation_rate=0.0005", "--set", "output.report=false"
  ))
)

stand_in("echo 'matrigrate: cell.toml:3: is wrong' >&2", "echo 'and more' >&2", "exit 3")
wrong <- caught(run_matrigrate("cell.toml"))
stopifnot(identical(conditionMessage(wrong), "cell.toml:3: is wrong\nand more"), wrong$exit_code == 3)

stand_in("exit 75")
stopped <- caught(call_matrigrate("resume", "cell-seed1"))
stopifnot(stopped$exit_code == 75, grepl("ended with the exit code 75", conditionMessage(stopped)))

stand_in("echo one", "echo two", "echo 'matrigrate: a warning' >&2")
told <- character()
lines <- withCallingHandlers(call_matrigrate("list"), message = function(m) {
  told <<- conditionMessage(m)
  invokeRestart("muffleMessage")
})
stopifnot(identical(lines, c("one", "two")), identical(told, "a warning\n"))

Sys.setenv(MATRIGRATE = "/no/such/program")
none <- caught(call_matrigrate("list"))
stopifnot(is.na(none$exit_code), grepl("names /no/such/program, which is no program", conditionMessage(none)))

unnamed <- tryCatch(run_matrigrate("cell.toml", set = "50 Pa"), error = conditionMessage)
stopifnot(grepl("names of parameters are expected", unnamed))

# Measured tracks: the words, the table and the notes of `matrigrate tracks`.
stand_in(
  paste0("printf '%s\\n' \"$@\" >'", words, "'"), "while [ \"$1\" != -o ]; do shift; done",
  "printf 'track,t_s,x_um,y_um\\n01,0,1,2\\n01,60,1.5,2\\n' >\"$2\"",
  "echo '{\"interval_s\": 60.0,'", "echo ' \"notes\": [\"of \\\"a\\\", b]\",'", "echo '  \"two\"], \"rows\": [\"x\"]}'"
)
notes <- character()
measured <- withCallingHandlers(
  read_measured_tracks("my spots.csv",
    pixel = 0.65, frame_interval = 60, time_unit = "s", columns = list(track = "Track n", x = 3), layout = "imaris", splits = "cut",
    jitter = 0.2, recalibrate = TRUE, shortest = 3, fewest = 1, drift = TRUE
  ),
  message = function(m) {
    notes <<- c(notes, conditionMessage(m))
    invokeRestart("muffleMessage")
  }
)
given <- readLines(words)
stopifnot(
  identical(measured$id, c("01", "01")), identical(measured$t_s, c(0, 60)), identical(measured$x_um, c(1, 1.5)),
  identical(attr(measured, "notes"), c("of \"a\", b]", "two")), identical(notes, c("of \"a\", b]\n", "two\n")), attr(measured, "interval_s") == 60,
  identical(given[-8], c(
    "tracks", "my spots.csv", "--json", "--resamples", "0", "--records", "-o", "--pixel", "0.65", "--interval", "60", "--time-unit", "s", "--layout", "imaris", "--splits", "cut",
    "--jitter", "0.2", "--shortest", "3", "--fewest", "1", "--drift", "--columns", "track=Track n", "--columns", "x=3"
  ))
)
worded <- matrigrate:::.as_arguments(c(
  "give {interval S} or {columns track=Track n, of all,t=2}",
  "{splits cut}, {drift true}; {fewest} {none}"
))
stopifnot(identical(worded, c(
  "give frame_interval = S or columns = c(track = \"Track n, of all\", t = 2)",
  "splits = \"cut\", drift = TRUE; fewest {none}"
)))
stopifnot(grepl("names are expected", tryCatch(read_measured_tracks("spots.csv", columns = "x"), error = conditionMessage)))

# Which parameter a treatment changed: a script stands in for Python.
stand_in(
  "[ \"$3\" = -c ] && exit 0", paste0("printf '%s\\n' \"$@\" >'", words, "'"),
  "while [ \"$1\" != -o ]; do [ \"$1\" = --besides ] && cat \"$2\" >&2; shift; done",
  "mkdir \"$2\"", "echo 'treated: it is a'",
  "printf 'group,differs,ratio_5,candidate\\ntreated,nothing,,False\\ntreated,a,0.5,True\\n' >\"$2/comparison.csv\""
)
Sys.setenv(PYTHON = Sys.getenv("MATRIGRATE"))
out <- tempfile("a comparison ")
numbers <- data.frame(group = "control", readout = "f_mat", mean = 0.3, error = 0.1)
told <- character()
printed <- utils::capture.output(found <- withCallingHandlers(
  compare_treatment("my design.csv", "control.csv", c(drug = "d=1.csv", "t.csv", "two words" = "w.csv"), c("x", "y"),
    out, force = TRUE, prior = list(a = c(50, 400, "log"), b = 1:2), pixel = 0.65, frame_interval = 60, error = 0.2,
    besides = numbers, known = list(b = c(1, 1.5)), parameters = c("a", "b"), pairs = FALSE, scores = FALSE
  ),
  message = function(m) {
    told <<- conditionMessage(m)
    invokeRestart("muffleMessage")
  }
))
given <- readLines(words)
stopifnot(
  identical(printed, "treated: it is a"), identical(attr(found, "words"), printed),
  identical(found$differs, c("nothing", "a")), identical(found$candidate, c(FALSE, TRUE)),
  identical(found$ratio_5, c(NA, 0.5)),
  identical(told, "\"group\",\"readout\",\"mean\",\"error\"\n\"control\",\"f_mat\",0.3,0.1\n"),
  identical(given[-match("--besides", given) - 1], c(
    "-P", "-B", "-m", "matrigrate.compare", "--readouts", "x,y", "--prior", "a=50:400:log", "--prior", "b=1:2",
    "--pixel", "0.65", "--frame-interval", "60", "--error", "0.2", "--besides", "--known", "b=1:1.5",
    "--parameters", "a,b", "--no-pairs", "--no-scores", "-o", out, "--force", "--", "my design.csv", "control.csv",
    "drug=d=1.csv", "t.csv", "two words=w.csv"
  ))
)
tracks <- data.frame(id = "1", t_s = 0, x_um = 0, y_um = 0)
invisible(utils::capture.output(compare_treatment("design", tracks, tracks, "straightness", tempfile())))
stopifnot(grepl("/control[.]csv$", readLines(words)[11]), grepl("^/.*/treated1[.]csv$", readLines(words)[12]))
stopifnot(grepl("^known: names of parameters are expected", tryCatch(
  compare_treatment("design", "c.csv", "t.csv", "straightness", out, known = 1), error = conditionMessage
)))
Sys.setenv(PYTHON = "/no/such/python")
none <- caught(compare_treatment("design", "c.csv", "t.csv", "straightness", out))
stopifnot(is.na(none$exit_code))
stopifnot(grepl("^/no/such/python .* has not the Python package matrigrate", conditionMessage(none)))
