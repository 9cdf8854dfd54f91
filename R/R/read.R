read_results <- function(study, table = "results.csv") {
  if (!.is_study(study)) .is_none(study, "a study")
  .table(file.path(study, table), c(
    "run", "label", "status", "reason", "cause", "trajectory_hash", "point", "point_a", "point_b", "readout", "set", "condition"
  ))
}

read_run <- function(run, table = "summary.csv", cell = NULL) {
  if (!.is_run(run)) .is_none(run, "a run")
  rows <- .table_of_run(run, table)
  if (is.null(cell)) return(rows)
  if (table %in% c("group.csv", "health.csv")) stop(table, ": its rows are of all cells together", call. = FALSE)
  column <- intersect(c("cell", "track"), names(rows))
  if (length(column) > 0) return(.of_cells(rows, cell, run, column[1]))
  if (any(cell != 1)) stop(run, ": has one cell, number 1", call. = FALSE)
  rows
}

read_tracks <- function(folder, cell = NULL) .cells_of(folder, "tracks.csv", cell)

read_summary <- function(folder, cell = NULL) .cells_of(folder, "summary.csv", cell)

read_protrusions <- function(folder, cell = NULL) .cells_of(folder, "protrusions.csv", cell)

read_msd <- function(folder, cell = NULL) .cells_of(folder, "msd.csv", cell)

example_folder <- function(name = c("pair", "stiffness-study")) {
  to <- file.path(tempdir(), "matrigrate-examples", match.arg(name))
  if (!dir.exists(to)) utils::untar(system.file("extdata", "examples.tar.gz", package = "matrigrate"), exdir = dirname(to))
  to
}

.is_folder <- function(folder) is.character(folder) && length(folder) == 1 && !is.na(folder) && dir.exists(folder)

.is_run <- function(folder) .is_folder(folder) && file.exists(file.path(folder, "run.json"))

.is_study <- function(folder) .is_folder(folder) && file.exists(file.path(folder, "study.resolved.toml"))

.is_running <- function(run) any(grepl("\"status\": *\"running\"", readLines(file.path(run, "run.json"), warn = FALSE)))

.is_none <- function(folder, what) {
  if (!is.character(folder) || length(folder) != 1) stop("the folder of ", what, " is expected, as one text", call. = FALSE)
  stop(folder, if (dir.exists(folder)) paste(": is no folder of", what) else ": there is no such folder", call. = FALSE)
}

.table_of_run <- function(run, table) {
  .table(file.path(run, table), if (table == "protrusions.csv") "cause", unfinished = .is_running(run))
}

# A table of a run, or of all runs of a study, with the names of its cells in front.
.cells_of <- function(folder, table, cell) {
  if (.is_run(folder)) {
    rows <- .with_cells(folder, table)
  } else if (.is_study(folder)) {
    results <- read_results(folder)
    columns <- names(results)
    keys <- c(columns[match("label", columns):match("replicate", columns)], "seed")
    runs <- file.path(folder, "runs", results$run)
    there <- which(file.exists(file.path(runs, table)))
    if (length(there) == 0) stop(folder, ": none of its runs has a ", table, " yet", call. = FALSE)
    rows <- .bound(lapply(there, function(i) .with_cells(runs[i], table, results[i, keys])))
  } else {
    .is_none(folder, "a run or a study")
  }
  if (is.null(cell)) rows else .of_cells(rows, cell, folder)
}

.with_cells <- function(run, table, keys = NULL) {
  rows <- .table_of_run(run, table)
  names(rows)[names(rows) == "id"] <- "protrusion" # id names the cell
  column <- intersect(c("cell", "track"), names(rows))
  cell <- if (length(column) > 0) rows[[column]] else rep(1, nrow(rows))
  several <- if (table == "tracks.csv") length(unique(cell)) > 1 else length(column) > 0
  name <- rep(basename(normalizePath(run)), nrow(rows))
  front <- data.frame(id = if (several) paste(name, cell, sep = "/", recycle0 = TRUE) else name, run = name, cell)
  if (!is.null(keys)) front <- cbind(front, keys[rep(1, nrow(rows)), , drop = FALSE], row.names = NULL)
  cbind(front, rows[setdiff(names(rows), column)], row.names = NULL)
}

# Tables below each other; a column that one of them lacks, such as the place of a nucleus, is NA there.
.bound <- function(tables) {
  columns <- unique(unlist(lapply(tables, names)))
  do.call(rbind, lapply(tables, function(table) {
    table[setdiff(columns, names(table))] <- rep(NA_real_, nrow(table))
    table[columns]
  }))
}

.of_cells <- function(table, cell, folder, column = "cell") {
  missing <- setdiff(cell, table[[column]])
  if (length(missing) > 0) {
    stop(folder, ": has no cell ", missing[1], "; its cells are ", paste(sort(unique(table[[column]])), collapse = ", "), call. = FALSE)
  }
  rows <- table[table[[column]] %in% cell, , drop = FALSE]
  rownames(rows) <- NULL
  rows
}
