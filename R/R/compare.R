compare_treatment <- function(design, control, treated, readouts, folder, prior = NULL, pixel = NULL,
                              frame_interval = NULL, error = NULL, besides = NULL, known = NULL, parameters = NULL,
                              pairs = TRUE, scores = TRUE, force = FALSE) {
  if (is.data.frame(treated)) treated <- list(treated)
  scratch <- tempfile("groups")
  dir.create(scratch)
  on.exit(unlink(scratch, recursive = TRUE))
  file_of <- function(x, name) {
    if (!is.data.frame(x)) return(.word(x))
    names(x)[names(x) == "id"] <- "track"
    file <- file.path(scratch, paste0(name, ".csv"))
    write.csv(x, file, row.names = FALSE)
    file
  }
  words <- c(
    "-P", "-B", "-m", "matrigrate.compare", "--readouts", paste(readouts, collapse = ","), .named("--prior", prior),
    .option("--pixel", pixel), .option("--frame-interval", frame_interval), .option("--error", error),
    if (!is.null(besides)) c("--besides", file_of(besides, "besides")), .named("--known", known),
    if (!is.null(parameters)) c("--parameters", paste(parameters, collapse = ",")), if (!pairs) "--no-pairs",
    if (!scores) "--no-scores", "-o", .word(folder), if (force) "--force", "--",
    file_of(design, "design"), file_of(control, "control"),
    paste0(sub("(.)$", "\\1=", names(treated)), mapply(file_of, treated, paste0("treated", seq_along(treated))))
  )
  said <- .call(.python(), words)
  writeLines(said)
  table <- .table(file.path(path.expand(folder), "comparison.csv"), c("group", "differs", "candidate"))
  table$candidate <- table$candidate == "True"
  invisible(structure(table, words = said))
}

# A Python with the package: what the environment variable PYTHON names, else the first of python3 and /usr/bin/python3.
.python <- function() {
  named <- Sys.getenv("PYTHON")
  for (python in Sys.which(if (nzchar(named)) path.expand(named) else c("python3", "/usr/bin/python3"))) {
    needed <- c("-P", "-B", "-c", shQuote("import matrigrate.compare, scipy"))
    if (nzchar(python) && system2(python, needed, stdout = FALSE, stderr = FALSE) == 0) return(python)
  }
  .stop_with(
    NA, if (nzchar(named)) paste(named, "(the environment variable PYTHON) has not") else "no python3 has",
    " the Python package matrigrate and SciPy, which compare. Install both (docs/python.md), and name their Python: ",
    "Sys.setenv(PYTHON = \"~/matrigrate-python/bin/python\")"
  )
}
