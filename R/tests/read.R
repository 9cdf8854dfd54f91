# The examples of the package, read: run and study, several cells, damage.
library(matrigrate)

refused <- function(words, expression) {
  message <- tryCatch({ expression; "no error" }, error = conditionMessage)
  if (!grepl(words, message, fixed = TRUE)) stop("expected '", words, "', got: ", message)
}
pair <- example_folder("pair")
study <- example_folder("stiffness-study")

lines <- readLines(file.path(pair, "tracks.csv"))
tracks <- read_tracks(pair)
summary <- read_summary(pair)
protrusions <- read_protrusions(pair)
stopifnot(
  nrow(tracks) == length(lines) - 1, identical(unique(tracks$id), c("pair/1", "pair/2")),
  identical(read_tracks(pair, cell = 2)$x_um, tracks$x_um[tracks$cell == 2]),
  identical(summary$id, c("pair/1", "pair/2")), identical(summary$v_migr_abs_um_per_h, read_run(pair)$v_migr_abs_um_per_h),
  identical(names(protrusions)[1:4], c("id", "run", "cell", "protrusion")), !anyDuplicated(protrusions[c("id", "protrusion")]),
  identical(unique(read_msd(pair)$id), c("pair/1", "pair/2"))
)

# The displacement of each cell is the program's, which it is not where two cells are joined.
ends <- sapply(split(tracks, tracks$id), function(track) {
  last <- nrow(track)
  sqrt(diff(track$x_um[c(1, last)])^2 + diff(track$y_um[c(1, last)])^2) / diff(track$t_s[c(1, last)]) * 3600
})
stopifnot(all.equal(unname(ends), summary$v_migr_abs_um_per_h, tolerance = 1e-9))

results <- read_results(study)
each <- read_summary(study)
stopifnot(
  nrow(results) == 8, nrow(each) == 8, identical(each$id, results$run), identical(each$v_migr_abs_um_per_h, results$v_migr_abs_um_per_h),
  length(unique(read_tracks(study)$id)) == 8, identical(names(each)[4:7], c("label", "ecm.youngs_modulus_Pa", "replicate", "seed")),
  names(results)[-seq_len(match("trajectory_hash", names(results)))] %in% readouts()$name
)

refused("nowhere: there is no such folder", read_tracks("nowhere"))
refused("is no folder of a run or a study", read_tracks(tempdir()))
refused("is expected, as one text", read_tracks(c(pair, pair)))
refused("has no cell 3; its cells are 1, 2", read_tracks(pair, cell = 3))
refused("none.csv: there is no such file", read_run(pair, "none.csv"))

# Copies with one damage each. A run that goes on may have a row that is not finished, and has no summary.
damaged <- tempfile("damaged")
dir.create(damaged)
with_tracks <- function(text, status = "done") {
  writeLines(paste0("{\"status\": \"", status, "\"}"), file.path(damaged, "run.json"))
  cat(text, file = file.path(damaged, "tracks.csv"))
  damaged
}
refused("tracks.csv:5: is damaged: has 3 fields", read_tracks(with_tracks(paste0(c(lines[1:4], "1,2,3", ""), collapse = "\n"))))
refused("tracks.csv:3: is damaged: it is cut short", read_tracks(with_tracks(paste0(c(lines[1:2], "1,2"), collapse = "\n"))))
stopifnot(nrow(read_tracks(with_tracks(paste0(c(lines[1:3], "1,2"), collapse = "\n"), "running"))) == 2)
refused("summary.csv: there is no such file", read_summary(damaged))

# Runs of a study that have different columns stand below each other.
mixed <- tempfile("mixed")
dir.create(mixed)
invisible(file.copy(study, mixed, recursive = TRUE))
mixed <- file.path(mixed, "stiffness-study")
of_one <- file.path(mixed, "runs", results$run[1], "tracks.csv")
write.csv(cbind(read.csv(of_one), nucleus_x_um = 1), of_one, row.names = FALSE, na = "")
nucleus <- read_tracks(mixed)
stopifnot(nucleus$nucleus_x_um[nucleus$id == results$run[1]] == 1, is.na(nucleus$nucleus_x_um[nucleus$id != results$run[1]]))
