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
