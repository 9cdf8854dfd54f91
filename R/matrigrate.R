# Results of Matrigrate in R (base R alone). In R: source("R/matrigrate.R"); see docs/r.md.
# Units stand in the names of columns: t_s, x_um, v_migr_abs_um_per_h.

# A table of the program: numbers to the last bit, texts as they are, empty fields as NA.
.matrigrate_table <- function(file, texts) {
  if (!file.exists(file)) stop(file, ": there is no such file", call. = FALSE)
  table <- tryCatch(
    utils::read.csv(file, colClasses = "character", na.strings = character(), check.names = FALSE, encoding = "UTF-8"),
    error = function(e) stop(file, ": is damaged: ", conditionMessage(e), call. = FALSE)
  )
  for (name in names(table)) {
    column <- table[[name]]
    guarded <- grepl("^'[=+@\t\r\n-]", column) # against spreadsheets
    column[guarded] <- substring(column[guarded], 2)
    if (!name %in% texts) {
      number <- suppressWarnings(as.numeric(column))
      if (all(column == "" | !is.na(number))) column <- number
    }
    table[[name]] <- column
  }
  table
}

.matrigrate_is_study <- function(folder) file.exists(file.path(folder, "study.resolved.toml"))

# The results of a study, a row a run: folder `run`, label of the point, swept parameters, replicate, seed, status and
# read-outs. Another table of the study by its name: read_results("stiffness-study", "statistics.csv").
read_results <- function(study, table = "results.csv") {
  if (!.matrigrate_is_study(study)) stop(study, ": is no folder of a study", call. = FALSE)
  .matrigrate_table(file.path(study, table), c(
    "run", "label", "status", "reason", "trajectory_hash", "point", "point_a", "point_b", "readout", "set", "condition"
  ))
}

# The tracks of a run, or of all runs of a study, in one data.frame: id (the folder of the run), label, swept parameters
# and replicate (of a study), then t_s [s], x_um, y_um [um] and the other columns of tracks.csv. For celltrackR:
#   celltrackR::as.tracks(d, id.column = "id", time.column = "t_s", pos.columns = c("x_um", "y_um"))
read_tracks <- function(folder) {
  if (file.exists(file.path(folder, "run.json"))) return(.matrigrate_tracks(folder, data.frame(id = basename(folder))))
  if (!.matrigrate_is_study(folder)) stop(folder, ": is no folder of a run or a study", call. = FALSE)
  results <- read_results(folder)
  names <- colnames(results)
  keys <- c(names[match("label", names):match("replicate", names)], "seed")
  begun <- file.exists(file.path(folder, "runs", results$run, "tracks.csv"))
  if (!any(begun)) stop(folder, ": none of its runs has begun", call. = FALSE)
  tracks <- lapply(which(begun), function(i) {
    front <- data.frame(id = results$run[i], results[i, keys], check.names = FALSE)
    .matrigrate_tracks(file.path(folder, "runs", results$run[i]), front)
  })
  do.call(rbind, tracks)
}

.matrigrate_tracks <- function(folder, front) {
  tracks <- .matrigrate_table(file.path(folder, "tracks.csv"), character())
  rownames(front) <- NULL
  cbind(front[rep(1, nrow(tracks)), , drop = FALSE], tracks[names(tracks) != "track"], row.names = NULL)
}
