# A table of the program: numbers to the last bit, texts as they are, empty fields as NA.
# texts: columns that hold no numbers; NULL if there are none, and then anything else is damage
# unfinished: whether its last row may be cut short, because it is being written
.table <- function(file, texts, unfinished = FALSE) {
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
  fields <- count.fields(lines, sep = ",", quote = "\"", blank.lines.skip = FALSE, comment.char = "")
  if (is.na(fields[1]) || fields[1] < 2) damaged(1, "commas are expected between its columns")
  wrong <- which(!is.na(fields) & fields != fields[1]) # NA: a text goes on in the next line
  if (length(wrong) > 0) damaged(wrong[1], "has ", fields[wrong[1]], " fields, its header ", fields[1])
  table <- tryCatch(
    read.csv(file, nrows = length(ends) - 1, colClasses = "character", na.strings = character(), check.names = FALSE, encoding = "UTF-8"),
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
