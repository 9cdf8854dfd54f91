# The R package, installed into an empty library, on the small runs: Rscript r_reads.R SOURCE_FOLDER SMALL_RUNS; runs the package's own
# tests and the commands of docs/r.md as well. MATRIGRATE is the program.
arguments <- commandArgs(TRUE)
source_folder <- normalizePath(arguments[1])
runs <- normalizePath(arguments[2])
library_folder <- tempfile("library")
dir.create(library_folder)
Sys.setenv(R_LIBS = library_folder)
.libPaths(c(library_folder, .libPaths()))
installed <- tempfile("installed")
r <- file.path(R.home("bin"), "R")
if (system2(r, c("CMD", "INSTALL", "-l", library_folder, shQuote(file.path(source_folder, "R"))), stdout = installed, stderr = installed) != 0) {
  stop("R CMD INSTALL failed:\n", paste(readLines(installed), collapse = "\n"))
}
library(matrigrate)

refused <- function(words, expression) {
  message <- tryCatch({ expression; "no error" }, error = conditionMessage)
  if (!grepl(words, message, fixed = TRUE)) stop("expected '", words, "', got: ", message)
}

lines <- readLines(file.path(runs, "run", "tracks.csv"))
tracks <- read_tracks(file.path(runs, "run"))
last <- strsplit(lines[length(lines)], ",")[[1]]
stopifnot(
  nrow(tracks) == length(lines) - 1,
  identical(names(tracks)[1:4], c("id", "run", "cell", "t_s")), tracks$id == "run", tracks$cell == 1,
  tracks$x_um[nrow(tracks)] == as.numeric(last[3]), is.na(tracks$polarization_rad[1])
)

results <- read_results(file.path(runs, "study"))
stopifnot(
  identical(results$label, c("=soft", "=soft", "NA", "NA")), # as in the study; "NA" is a text
  is.character(results$run), is.character(results$trajectory_hash), is.numeric(results$v_migr_abs_um_per_h),
  identical(results[["ecm.youngs_modulus_Pa"]], c(50, 50, 200, 200)), all(is.na(results$tau_prot_min))
)
statistics <- read_results(file.path(runs, "study"), "statistics.csv")
stopifnot(statistics$point_a == "=soft", is.numeric(statistics$p_holm))

together <- read_tracks(file.path(runs, "study"))
stopifnot(
  length(unique(together$id)) == 4, identical(names(together)[2:7], c("run", "cell", "label", "ecm.youngs_modulus_Pa", "replicate", "seed")),
  nrow(together) == sum(sapply(unique(results$run), function(run) nrow(read_tracks(file.path(runs, "study", "runs", run)))))
)

exported <- utils::read.csv(file.path(runs, "exported", "tracks.csv"), check.names = FALSE)
stopifnot(
  identical(names(exported)[1:5], c("run", "label", "ecm.youngs_modulus_Pa", "replicate", "seed")),
  exported$run == together$run, exported$track == together$cell, exported$t_s == together$t_s, exported$x_um == together$x_um, exported$y_um == together$y_um
)

# Several cells: a track for each of them, whose speeds are those of the program.
speed_of <- function(track) {
  n <- nrow(track)
  sqrt((track$x_um[n] - track$x_um[1])^2 + (track$y_um[n] - track$y_um[1])^2) / (track$t_s[n] - track$t_s[1]) * 3600
}
pair <- read_tracks(file.path(runs, "pair"))
expected <- utils::read.csv(file.path(runs, "pair", "summary.csv"))
stopifnot(
  identical(unique(pair$id), c("pair/1", "pair/2")), pair$run == "pair",
  all.equal(unname(sapply(split(pair, pair$id), speed_of)), expected$v_migr_abs_um_per_h, tolerance = 1e-9)
)

each <- read_summary(file.path(runs, "pair"))
stopifnot(identical(each$id, c("pair/1", "pair/2")), identical(each$v_migr_abs_um_per_h, read_run(file.path(runs, "pair"))$v_migr_abs_um_per_h))

# One of the cells, and the tables of a run.
second <- read_tracks(file.path(runs, "pair"), cell = 2)
stopifnot(second$cell == 2, identical(second$x_um, pair$x_um[pair$cell == 2]), rownames(second)[1] == "1")
summary_of_pair <- read_run(file.path(runs, "pair"))
protrusions <- read_run(file.path(runs, "pair"), "protrusions.csv")
of_second <- read_run(file.path(runs, "pair"), "protrusions.csv", cell = 2)
group <- read_run(file.path(runs, "pair"), "group.csv")
stopifnot(
  summary_of_pair$cell == 1:2, all.equal(summary_of_pair$v_migr_abs_um_per_h, expected$v_migr_abs_um_per_h),
  is.character(protrusions$cause), nrow(of_second) > 0, nrow(of_second) == sum(protrusions$cell == 2), of_second$cell == 2,
  identical(group$t_s, second$t_s), is.numeric(group$order),
  identical(read_run(file.path(runs, "run"), "msd.csv", cell = 1), read_run(file.path(runs, "run"), "msd.csv"))
)
refused("has no cell 3; its cells are 1, 2", read_tracks(file.path(runs, "pair"), cell = c(1, 3)))
refused("has one cell, number 1", read_run(file.path(runs, "run"), cell = 2))
refused("its rows are of all cells together", read_run(file.path(runs, "pair"), "group.csv", cell = 1))
refused("is no folder of a run", read_run(file.path(runs, "study")))

pairs <- read_tracks(file.path(runs, "pairs"))
stopifnot(identical(read_tracks(file.path(runs, "pairs"), cell = 1)$x_um, pairs$x_um[pairs$cell == 1]))
results_of_pairs <- read_results(file.path(runs, "pairs"))
mean_speeds <- tapply(sapply(split(pairs, pairs$id), speed_of), sapply(split(pairs$run, pairs$id), unique), mean)
stopifnot(
  length(unique(pairs$id)) == 4,
  all.equal(as.vector(mean_speeds[results_of_pairs$run]), results_of_pairs$v_migr_abs_um_per_h, tolerance = 1e-9)
)

# Tables that are cut or ragged are refused with file and line; of a run that goes on the row that is being written is left out.
damaged <- tempfile("damaged")
dir.create(damaged)
broken <- function(text, words, status = "done") {
  writeLines(paste0("{\"status\": \"", status, "\"}"), file.path(damaged, "run.json"))
  cat(text, file = file.path(damaged, "tracks.csv"))
  refused(words, read_tracks(damaged))
}
whole <- paste0(paste(lines, collapse = "\n"), "\n")
with_line <- function(k, line) paste0(paste(replace(lines, k, line), collapse = "\n"), "\n")
broken(with_line(5, paste0(lines[5], ",1,2,3")), "tracks.csv:5: is damaged: has")
broken(with_line(5, sub(",[^,]*$", "", lines[5])), "tracks.csv:5: is damaged: has")
broken(with_line(5, ""), "tracks.csv:5: is damaged: has 0 fields")
broken(with_line(5, sub(",", ",x", lines[5])), "tracks.csv:5: is damaged: t_s is no number")
broken(substr(whole, 1, nchar(whole) - 3), paste0("tracks.csv:", length(lines), ": is damaged: it is cut short"))
broken(gsub(",", ";", whole), "tracks.csv:1: is damaged: commas are expected")
broken("", "tracks.csv:1: is damaged: it is empty")
broken(whole, "no error")
broken(substr(whole, 1, nchar(whole) - 3), "no error", "running")
stopifnot(nrow(read_tracks(damaged)) == length(lines) - 2)

each <- read_summary(file.path(runs, "pairs"))
stopifnot(
  identical(unique(each$id), unique(pairs$id)), identical(each$label, rep("pair", 4)),
  all.equal(as.vector(tapply(each$v_migr_abs_um_per_h, each$run, mean)[results_of_pairs$run]), results_of_pairs$v_migr_abs_um_per_h)
)

refused("nowhere: there is no such folder", read_tracks("nowhere"))
refused("is no folder of a run or a study", read_tracks(runs))
refused("no folder of a study", read_results(file.path(runs, "run")))
refused("no such file", read_results(file.path(runs, "study"), "none.csv"))

# The program: a run, which the same call leaves as it is; its words where something is wrong.
work <- tempfile("r")
dir.create(work)
setwd(work)
scenario <- file.path(runs, "cell.toml")
for (k in 1:2) run <- run_matrigrate(scenario, seed = 3, out = "a run", hours = 0.01, set = list(ecm.radius = "50 um", output.report = FALSE))
stopifnot(identical(run, "a run"), abs(max(read_tracks(run)$t_s) - 36) < 2.5, grepl("\"seed\": 3,", paste(readLines("a run/run.json"), collapse = "")))
failed <- function(expression) tryCatch({ expression; NULL }, matrigrate_error = identity)
unknown <- failed(run_matrigrate(scenario, set = c(ecm.youngs_modulu = "50 Pa")))
stopifnot(unknown$exit_code == 3, grepl("^--set: ecm.youngs_modulu: .*did you mean ecm.youngs_modulus", conditionMessage(unknown)))
other <- failed(run_matrigrate(scenario, out = "a run"))
stopifnot(other$exit_code == 5, grepl("holds another run", conditionMessage(other)))
stopifnot(failed(call_matrigrate("rnu"))$exit_code == 2, any(grepl("soft", call_matrigrate("list"))))

# Measured tracks of another program, with its units told; a message of the program in the words of R.
spots <- c("Cell no.;frame;x;y", sprintf("%d;%d;%d,5;%d", rep(1:2, each = 5), 0:4, 3 * (0:4), 4 * (0:4)))
writeLines(spots, "spots.csv")
measured <- suppressMessages(read_measured_tracks("spots.csv", pixel = 0.5, frame_interval = 60, columns = c(track = "Cell no.")))
stopifnot(
  identical(names(measured), c("id", "t_s", "x_um", "y_um")), nrow(measured) == 10, measured$t_s == 60 * (0:4), attr(measured, "interval_s") == 60,
  all.equal(sqrt(diff(measured$x_um[1:5])^2 + diff(measured$y_um[1:5])^2), rep(2.5, 4))
)
stopifnot(identical(plot_path(measured, from_start = TRUE)$id, measured$id))
refused("has no column cell", plot_path(measured, cell = 1))
refused("frame_interval", read_measured_tracks("spots.csv", pixel = 0.5, columns = c(track = "Cell no.")))

# What the package has of its own agrees with the project: version, read-outs, columns of its examples, functions when sourced.
stopifnot(identical(
  as.character(utils::packageVersion("matrigrate")),
  sub("^project\\(matrigrate VERSION ([0-9.]+) .*", "\\1", grep("^project", readLines(file.path(source_folder, "CMakeLists.txt")), value = TRUE))
))
json <- readLines(file.path(source_folder, "docs", "readouts.json"))
for (key in c("name", "unit", "meaning")) {
  values <- sub("^ *\"[a-z]+\": \"(.*)\",$", "\\1", grep(paste0("^ *\"", key, "\": "), json, value = TRUE))
  if (!identical(readouts()[[key]], values)) stop("R/R/readouts.R differs from docs/readouts.json: ", setdiff(values, readouts()[[key]])[1])
}
without_nucleus <- function(names) names[!grepl("^nucleus_", names)]
for (table in c("tracks.csv", "summary.csv", "protrusions.csv", "msd.csv", "group.csv")) {
  stopifnot(identical(names(read_run(example_folder("pair"), table)), without_nucleus(names(read_run(file.path(runs, "pair"), table)))))
}
for (table in c("results.csv", "groups.csv", "statistics.csv", "msd.csv")) {
  stopifnot(identical(names(read_results(example_folder("stiffness-study"), table)), names(read_results(file.path(runs, "study"), table))))
}
sourced <- new.env()
source(file.path(source_folder, "R", "matrigrate.R"), local = sourced)
stopifnot(identical(ls(sourced), sort(getNamespaceExports("matrigrate"))), identical(sourced$read_tracks(example_folder("pair")), read_tracks(example_folder("pair"))))

for (test in list.files(file.path(source_folder, "R", "tests"), full.names = TRUE)) {
  said <- tempfile("said")
  code <- system2(file.path(R.home("bin"), "Rscript"), c("--vanilla", shQuote(test)), stdout = said, stderr = said)
  if (code != 0) stop(test, " failed:\n", paste(readLines(said), collapse = "\n"))
}

# The commands of docs/r.md, in a folder in which the runs have its names; those that need a package only with it.
invisible(file.copy(scenario, "cell.toml"))
invisible(file.symlink(file.path(runs, "run"), "cell-seed1"))
invisible(file.symlink(file.path(runs, "study"), "stiffness-study"))
invisible(file.symlink(file.path(runs, "pair"), "pair"))
invisible(file.symlink(file.path(source_folder, "R"), "R"))
page <- readLines(file.path(source_folder, "docs", "r.md"))
fences <- grep("^```", page)
grDevices::pdf("figures.pdf")
for (k in seq(1, length(fences), 2)) {
  if (page[fences[k]] != "```r") next
  block <- page[(fences[k] + 1):(fences[k + 1] - 1)]
  needed <- sub("^library\\((.*)\\)$", "\\1", grep("^library\\(", block, value = TRUE))
  if (all(needed %in% rownames(utils::installed.packages()))) {
    eval(parse(text = block), globalenv())
  } else {
    invisible(parse(text = block))
    cat("parsed only, without", needed, "\n")
  }
}
invisible(grDevices::dev.off())
cat("R", as.character(getRversion()), "read", nrow(together), "rows of", length(unique(together$id)), "runs\n")
