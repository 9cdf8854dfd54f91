# Results of Matrigrate in R (base R alone). In R: source("R/matrigrate.R"); see docs/r.md.
# Units stand in the names of columns: t_s, x_um, v_migr_abs_um_per_h.

# A table of the program: numbers to the last bit, texts as they are, empty fields as NA.
# texts: columns that hold no numbers; NULL if there are none, and then anything else is damage
# unfinished: whether its last row may be cut short, because it is being written
.matrigrate_table <- function(file, texts, unfinished = FALSE) {
  if (!file.exists(file)) stop(file, ": there is no such file", call. = FALSE)
  damaged <- function(line, ...) stop(file, ":", line, ": is damaged: ", ..., call. = FALSE)
  content <- readBin(file, "raw", file.size(file))
  ends <- which(content == as.raw(10))
  if (length(content) == 0) damaged(1, "it is empty")
  if (content[length(content)] != as.raw(10)) {
    if (!unfinished || length(ends) == 0) damaged(length(ends) + 1, "it is cut short")
    content <- content[seq_len(ends[length(ends)])]
  }
  if (any(content == as.raw(0))) damaged(1, "it is no text")
  lines <- textConnection(strsplit(rawToChar(content), "\n", fixed = TRUE)[[1]], encoding = "bytes")
  on.exit(close(lines))
  fields <- utils::count.fields(lines, sep = ",", quote = "\"", blank.lines.skip = FALSE, comment.char = "")
  if (is.na(fields[1]) || fields[1] < 2) damaged(1, "commas are expected between its columns")
  wrong <- which(!is.na(fields) & fields != fields[1]) # NA: a text goes on in the next line
  if (length(wrong) > 0) damaged(wrong[1], "has ", fields[wrong[1]], " fields, its header ", fields[1])
  table <- tryCatch(
    utils::read.csv(file, nrows = length(ends) - 1, colClasses = "character", na.strings = character(), check.names = FALSE, encoding = "UTF-8"),
    error = function(e) damaged(1, conditionMessage(e))
  )
  for (name in names(table)) {
    column <- table[[name]]
    guarded <- grepl("^'[=+@\t\r\n-]", column) # against spreadsheets
    column[guarded] <- substring(column[guarded], 2)
    if (!name %in% texts) {
      number <- suppressWarnings(as.numeric(column))
      bad <- which(column != "" & is.na(number))
      if (length(bad) == 0) column <- number else if (is.null(texts)) damaged(bad[1] + 1, name, " is no number")
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
    "run", "label", "status", "reason", "cause", "trajectory_hash", "point", "point_a", "point_b", "readout", "set", "condition"
  ))
}

# The tracks of a run, or of all runs of a study, in one data.frame, a row for each cell at each time: id, run (the folder
# of the run), cell (its number in that run, from 1); of a study label, swept parameters, replicate and seed; then t_s [s],
# x_um, y_um [um] and the other columns of tracks.csv. cell = 2, or cell = c(1, 3), takes the tracks of these cells alone.
# The id is that of one cell in one run: the folder, and with several
# cells the folder, a slash and the number of the cell. For celltrackR:
#   celltrackR::as.tracks(d, id.column = "id", time.column = "t_s", pos.columns = c("x_um", "y_um"))
read_tracks <- function(folder, cell = NULL) {
  tracks <- .matrigrate_all_tracks(folder)
  if (is.null(cell)) tracks else .matrigrate_of_cells(tracks, cell, folder)
}

# A table of a run: "summary.csv" has a row of read-outs for each cell, "group.csv", of several cells, a row each minute for all of them
# together; also "protrusions.csv", "msd.csv", "health.csv". cell = 2 takes the rows of cell 2; a table of one cell has
# no column `cell`, and is that of cell 1.
read_run <- function(run, table = "summary.csv", cell = NULL) {
  if (!file.exists(file.path(run, "run.json"))) stop(run, ": is no folder of a run", call. = FALSE)
  rows <- .matrigrate_table(file.path(run, table), "cause", unfinished = .matrigrate_is_running(run))
  if (is.null(cell)) return(rows)
  if (table %in% c("group.csv", "health.csv")) stop(table, ": its rows are of all cells together", call. = FALSE)
  column <- intersect(c("cell", "track"), names(rows))
  if (length(column) > 0) return(.matrigrate_of_cells(rows, cell, run, column[1]))
  if (any(cell != 1)) stop(run, ": has one cell, number 1", call. = FALSE)
  rows
}

.matrigrate_of_cells <- function(table, cell, folder, column = "cell") {
  missing <- setdiff(cell, table[[column]])
  if (length(missing) > 0) {
    stop(folder, ": has no cell ", missing[1], "; its cells are ", paste(sort(unique(table[[column]])), collapse = ", "), call. = FALSE)
  }
  rows <- table[table[[column]] %in% cell, , drop = FALSE]
  rownames(rows) <- NULL
  rows
}

.matrigrate_all_tracks <- function(folder) {
  if (file.exists(file.path(folder, "run.json"))) return(.matrigrate_tracks(folder))
  if (!.matrigrate_is_study(folder)) stop(folder, ": is no folder of a run or a study", call. = FALSE)
  results <- read_results(folder)
  names <- colnames(results)
  keys <- c(names[match("label", names):match("replicate", names)], "seed")
  begun <- file.exists(file.path(folder, "runs", results$run, "tracks.csv"))
  if (!any(begun)) stop(folder, ": none of its runs has begun", call. = FALSE)
  tracks <- lapply(which(begun), function(i) {
    .matrigrate_tracks(file.path(folder, "runs", results$run[i]), results[i, keys])
  })
  do.call(rbind, tracks)
}

.matrigrate_is_running <- function(folder) {
  record <- file.path(folder, "run.json")
  file.exists(record) && any(grepl("\"status\": *\"running\"", readLines(record, warn = FALSE)))
}

.matrigrate_tracks <- function(folder, keys = NULL) {
  tracks <- .matrigrate_table(file.path(folder, "tracks.csv"), NULL, unfinished = .matrigrate_is_running(folder))
  run <- rep(basename(normalizePath(folder)), nrow(tracks))
  cell <- tracks$track
  id <- if (length(unique(cell)) > 1) paste(run, cell, sep = "/") else run
  front <- data.frame(id, run, cell)
  if (!is.null(keys)) front <- cbind(front, keys[rep(1, nrow(tracks)), , drop = FALSE], row.names = NULL)
  cbind(front, tracks[names(tracks) != "track"], row.names = NULL)
}
