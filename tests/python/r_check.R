# R CMD build and R CMD check --as-cran of the package: Rscript r_check.R SOURCE_FOLDER. Errors and warnings fail; notes are printed.
# What the check asks CRAN for is in a folder here, so that it needs no network; without one it warns of indexes that it cannot reach.
source_folder <- normalizePath(commandArgs(TRUE)[1])
work <- tempfile("check")
dir.create(work)
setwd(work)
dir.create("web/packages", recursive = TRUE)
dir.create("src/contrib", recursive = TRUE)
saveRDS(data.frame(Package = "none", Maintainer = "none"), "web/packages/packages.rds")
invisible(file.create("src/contrib/PACKAGES"))
cran <- paste0("file://", work)
Sys.setenv(
  R_CRAN_WEB = cran, R_CRAN_SRC = cran, R_DEFAULT_INTERNET_TIMEOUT = "5", "_R_CHECK_XREFS_REPOSITORIES_" = cran, "_R_CHECK_CRAN_INCOMING_REMOTE_" = "false",
  "_R_CHECK_SYSTEM_CLOCK_" = "0", "_R_CHECK_FORCE_SUGGESTS_" = "false" # ggplot2 and celltrackR may be missing
)
r <- function(...) {
  said <- suppressWarnings(system2(file.path(R.home("bin"), "R"), c("CMD", ...), stdout = TRUE, stderr = TRUE))
  list(code = max(0, attr(said, "status")), said = said)
}
built <- r("build", shQuote(file.path(source_folder, "R")))
archive <- list.files(pattern = "^matrigrate_.*[.]tar[.]gz$")
if (built$code != 0 || length(archive) != 1) stop("R CMD build failed:\n", paste(built$said, collapse = "\n"))
checked <- r("check", "--as-cran", "--no-manual", archive)
writeLines(checked$said)
tests <- list.files("matrigrate.Rcheck/tests", "[.]fail$", full.names = TRUE)
for (file in tests) writeLines(readLines(file))
if (checked$code != 0 || any(grepl("^Status:.*(WARNING|ERROR)", checked$said)) || !any(grepl("^Status:", checked$said))) {
  stop("R CMD check of ", archive, " has errors or warnings")
}
