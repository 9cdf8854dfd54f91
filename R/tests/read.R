# The examples of the package, read: run and study, several cells. Damage: tests/python/r_reads.R, in the project.
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

results <- read_results(study)
each <- read_summary(study)
stopifnot(
  nrow(results) == 8, nrow(each) == 8, identical(each$id, results$run), identical(each$v_migr_abs_um_per_h, results$v_migr_abs_um_per_h),
  length(unique(read_tracks(study)$id)) == 8, identical(names(each)[4:7], c("label", "ecm.youngs_modulus_Pa", "replicate", "seed")),
  names(results)[-seq_len(match("trajectory_hash", names(results)))] %in% readouts()$name
)

refused("is expected, as one text", read_tracks(c(pair, pair)))
refused("none.csv: there is no such file", read_run(pair, "none.csv"))

# Runs of a study that have different columns stand below each other.
mixed <- tempfile("mixed")
dir.create(mixed)
invisible(file.copy(study, mixed, recursive = TRUE))
mixed <- file.path(mixed, "stiffness-study")
of_one <- file.path(mixed, "runs", results$run[1], "tracks.csv")
write.csv(cbind(read.csv(of_one), nucleus_x_um = 1), of_one, row.names = FALSE, na = "")
nucleus <- read_tracks(mixed)
stopifnot(nucleus$nucleus_x_um[nucleus$id == results$run[1]] == 1, is.na(nucleus$nucleus_x_um[nucleus$id != results$run[1]]))
