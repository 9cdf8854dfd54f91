read_measured_tracks <- function(file, pixel = NULL, frame_interval = NULL, time_unit = NULL, columns = NULL, layout = NULL, splits = NULL,
                                 jitter = NULL, recalibrate = FALSE, shortest = NULL, fewest = NULL, drift = FALSE) {
  if (!is.character(file) || length(file) != 1) stop("file: the path of a file of tracks is expected", call. = FALSE)
  if (length(columns) > 0 && (is.null(names(columns)) || any(names(columns) == ""))) {
    stop("columns: names are expected, as in c(track = \"Track ID\", x = \"east\", y = \"north\")", call. = FALSE)
  }
  folder <- tempfile("tracks")
  dir.create(folder)
  on.exit(unlink(folder, recursive = TRUE))
  out <- file.path(folder, "tracks.csv")
  printed <- call_matrigrate(
    "tracks", path.expand(file), "--json", "--resamples", 0, "--records", "-o", out, .option("--pixel", pixel),
    .option("--interval", frame_interval), .option("--time-unit", time_unit), .option("--layout", layout),
    .option("--splits", splits), .option("--jitter", jitter), .option("--shortest", shortest), .option("--fewest", fewest), if (drift) "--drift",
    unlist(lapply(seq_along(columns), function(i) c("--columns", paste0(names(columns)[i], "=", .word(columns[[i]])))))
  )
  rows <- .table(out, "track")
  names(rows)[names(rows) == "track"] <- "id"
  if (is.character(rows$id)) rows$id <- sub("^'([-=+@])", "\\1", rows$id) # the apostrophe guards it from spreadsheets
  text <- paste(printed, collapse = "\n")
  attr(rows, "interval_s") <- as.numeric(sub("(?s).*\"interval_s\": *([^,\\s]+).*", "\\1", text, perl = TRUE))
  attr(rows, "notes") <- .as_arguments(.notes(text))
  for (note in attr(rows, "notes")) message(note)
  rows
}

# A text in which the program names options as {interval S}, with the arguments of read_measured_tracks in their place.
.as_arguments <- function(text) {
  if (length(text) == 0) return(text)
  options <- "pixel|interval|time-unit|columns|layout|splits|jitter|shortest|fewest|drift"
  found <- gregexpr(paste0("\\{(", options, ")( [^{}]*)?\\}"), text, perl = TRUE)
  regmatches(text, found) <- lapply(regmatches(text, found), function(records) vapply(records, .argument, ""))
  text
}

.argument <- function(record) {
  words <- regmatches(record, regexec("^\\{([a-z-]+) ?(.*)\\}$", record))[[1]]
  name <- sub("^interval$", "frame_interval", gsub("-", "_", words[2]))
  value <- words[3]
  if (!nzchar(value)) return(name)
  if (name == "columns") {
    pairs <- strsplit(value, ",(?=(track|t|frame|x|y|z|group|made_up|measured)=)", perl = TRUE)[[1]]
    pairs <- ifelse(grepl("=[0-9]+$", pairs), sub("=", " = ", pairs), sub("=(.*)", " = \"\\1\"", pairs))
    value <- paste0("c(", paste(pairs, collapse = ", "), ")")
  }
  if (name %in% c("time_unit", "splits", "layout")) value <- paste0("\"", value, "\"")
  paste(name, "=", if (name == "drift") "TRUE" else value)
}

# The notes of a JSON document.
.notes <- function(text) {
  quoted <- "\"(?:[^\"\\\\]|\\\\.)*\""
  list <- regmatches(text, regexpr(paste0("\"notes\": *\\[(?:\\s|,|", quoted, ")*\\]"), text, perl = TRUE))
  notes <- unlist(regmatches(list, gregexpr(quoted, list, perl = TRUE)))[-1]
  gsub("\\\\(.)", "\\1", substring(notes, 2, nchar(notes) - 1)) # JSON guards quotes and backslashes
}
