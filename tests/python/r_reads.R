# R/matrigrate.R on the small runs: Rscript r_reads.R SOURCE_FOLDER SMALL_RUNS; runs the commands of docs/r.md as well.
arguments <- commandArgs(TRUE)
source_folder <- normalizePath(arguments[1])
runs <- normalizePath(arguments[2])
source(file.path(source_folder, "R", "matrigrate.R"))

refused <- function(words, expression) {
  message <- tryCatch({ expression; "no error" }, error = conditionMessage)
  if (!grepl(words, message, fixed = TRUE)) stop("expected '", words, "', got: ", message)
}

lines <- readLines(file.path(runs, "run", "tracks.csv"))
tracks <- read_tracks(file.path(runs, "run"))
last <- strsplit(lines[length(lines)], ",")[[1]]
stopifnot(
  nrow(tracks) == length(lines) - 1,
  identical(names(tracks)[1:4], c("id", "t_s", "x_um", "y_um")), tracks$id == "run",
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
  length(unique(together$id)) == 4, identical(names(together)[2:5], c("label", "ecm.youngs_modulus_Pa", "replicate", "seed")),
  nrow(together) == sum(sapply(unique(results$run), function(run) nrow(read_tracks(file.path(runs, "study", "runs", run)))))
)

exported <- utils::read.csv(file.path(runs, "exported", "tracks.csv"), check.names = FALSE)
stopifnot(
  identical(names(exported)[1:5], c("run", "label", "ecm.youngs_modulus_Pa", "replicate", "seed")),
  exported$run == together$id, exported$t_s == together$t_s, exported$x_um == together$x_um, exported$y_um == together$y_um
)

refused("no folder of a run or a study", read_tracks("nowhere"))
refused("no folder of a study", read_results(file.path(runs, "run")))
refused("no such file", read_results(file.path(runs, "study"), "none.csv"))

# The commands of docs/r.md, in a folder in which the runs have its names; those that need a package only with it.
work <- tempfile("r")
dir.create(work)
setwd(work)
invisible(file.symlink(file.path(runs, "run"), "cell-seed1"))
invisible(file.symlink(file.path(runs, "study"), "stiffness-study"))
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
