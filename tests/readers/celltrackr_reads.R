# Exported tracks in celltrackR: the commands of the documentation, then its speeds and displacements beside our read-outs.
# celltrackr_reads.R FOLDER
if (!suppressWarnings(requireNamespace("celltrackR", quietly = TRUE))) quit(status = 77)
suppressMessages(library(celltrackR))
folder <- commandArgs(trailingOnly = TRUE)[1]
same <- function(a, b) stopifnot(length(a) == length(b), all(is.finite(a)), all(abs(unname(a) - unname(b)) <= 1e-9 * abs(b)))
per_hour <- function(tracks) 3600 * sapply(tracks, displacement) / sapply(tracks, duration)

ours <- read.csv(file.path(folder, "tracks.csv"))
summary <- read.csv(file.path(folder, "summary.csv"))
tracks <- read.tracks.csv(file.path(folder, "export/tracks_celltrackr.csv"), sep = ",", pos.columns = 3:4)
stopifnot(is.tracks(tracks), length(tracks) == 1, identical(colnames(tracks[[1]]), c("t", "x", "y")))
stopifnot(nrow(ours) == 16, all(tracks[[1]] == as.matrix(ours[, c("t_s", "x_um", "y_um")])))
same(per_hour(tracks), summary$v_migr_abs_um_per_h)
same(squareDisplacement(tracks[[1]]), (summary$v_migr_abs_um_per_h * summary$duration_s / 3600)^2)
stopifnot(timeStep(tracks) == 12)
same(3600 * speed(subsample(tracks, k = 5)[[1]]), summary$v_migr_path_60s_um_per_h) # every 60 s
direct <- read.tracks.csv(file.path(folder, "tracks.csv"), id.column = "track", time.column = "t_s",
  pos.columns = c("x_um", "y_um"), sep = ",")
stopifnot(all(direct[[1]] == tracks[[1]]))

results <- read.csv(file.path(paste0(folder, "-study"), "results.csv"), check.names = FALSE)
many <- read.tracks.csv(file.path(paste0(folder, "-study"), "export/tracks_spots.csv"), id.column = "Unique_ID",
  time.column = "POSITION_T", pos.columns = c("POSITION_X", "POSITION_Y"), sep = ",", quote = "\"", comment.char = "")
stopifnot(length(many) == 4, all(sapply(many, nrow) == 4), all(sapply(many, duration) == 36))
runs <- sub("_[0-9]+$", "", names(many))
stopifnot(setequal(runs, results$run))
same(per_hour(many), results$v_migr_abs_um_per_h[match(runs, results$run)])
stopifnot(nrow(aggregate(many, squareDisplacement)) == 3) # mean square displacement over 1 to 3 steps
cat("celltrackR", as.character(packageVersion("celltrackR")), ":", length(tracks), "and", length(many), "tracks\n")
