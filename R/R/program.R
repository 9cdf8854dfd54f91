run_matrigrate <- function(scenario, seed = NULL, out = NULL, hours = NULL, set = NULL, threads = NULL, force = FALSE) {
  if (!is.character(scenario) || length(scenario) != 1) stop("scenario: the path of a scenario file is expected", call. = FALSE)
  printed <- call_matrigrate(
    "run", path.expand(scenario), "--json", "--quiet", .option("--seed", seed), .option("-o", out),
    .option("--hours", hours), .option("--threads", threads), if (force) "--force", .named("--set", set)
  )
  folder <- sub("^ *\"folder\": \"(.*)\",?$", "\\1", grep("^ *\"folder\": ", printed, value = TRUE)[1])
  invisible(gsub("\\\\(.)", "\\1", folder)) # JSON guards quotes and backslashes
}

call_matrigrate <- function(...) {
  words <- unlist(lapply(list(...), .word))
  .call(.program(), words)
}

# The lines that a program prints; its words on stderr as a message, its exit code as an error.
.call <- function(program, words) {
  files <- tempfile(c("out", "err"))
  on.exit(unlink(files))
  code <- system2(program, shQuote(words), stdout = files[1], stderr = files[2])
  printed <- lapply(files, readLines, warn = FALSE, encoding = "UTF-8")
  said <- .as_arguments(paste(sub("^matrigrate: ", "", printed[[2]]), collapse = "\n"))
  if (code != 0) .stop_with(code, if (nzchar(said)) said else paste0(program, ": ended with the exit code ", code))
  if (nzchar(said)) message(said)
  invisible(printed[[1]])
}

.option <- function(name, value) if (!is.null(value)) c(name, .word(value))

# An option for each parameter, with its values.
.named <- function(option, values) {
  if (length(values) > 0 && (is.null(names(values)) || any(names(values) == ""))) {
    example <- if (option == "--set") "c(ecm.youngs_modulus = \"50 Pa\")" else "list(ecm.youngs_modulus_Pa = c(50, 400))"
    stop(sub("--", "", option), ": names of parameters are expected, as in ", example, call. = FALSE)
  }
  texts <- vapply(values, function(value) paste(.word(value), collapse = ":"), "")
  unlist(lapply(names(values), function(name) c(option, paste0(name, "=", texts[[name]]))))
}

.stop_with <- function(code, ...) {
  stop(structure(class = c("matrigrate_error", "error", "condition"), list(message = paste0(...), call = NULL, exit_code = code)))
}

# The program: what the environment variable MATRIGRATE names, else the first on PATH.
.program <- function() {
  named <- Sys.getenv("MATRIGRATE")
  found <- Sys.which(if (nzchar(named)) path.expand(named) else "matrigrate")
  if (!nzchar(found)) {
    where <- if (nzchar(named)) {
      c("the environment variable MATRIGRATE names ", named, ", which is no program")
    } else {
      "the program matrigrate is not on PATH, and the environment variable MATRIGRATE does not name it"
    }
    .stop_with(NA, paste(where, collapse = ""), ". Reading results needs no program; running does")
  }
  found[[1]]
}

# Words as the program takes them: numbers to the last bit, TRUE as true.
.word <- function(value) {
  if (is.logical(value)) return(tolower(value))
  if (!is.numeric(value)) return(path.expand(as.character(value)))
  vapply(value, function(x) {
    texts <- sprintf(c("%.0f", "%.15g", "%.16g", "%.17g"), x)
    c(texts[as.numeric(texts) == x], texts[4])[1]
  }, "")
}
