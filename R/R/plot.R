plot_path <- function(x, cell = NULL, from_start = FALSE, ...) {
  tracks <- .rows_of(x, cell, read_tracks, c("id", if (!is.null(cell)) "cell", "t_s", "x_um", "y_um"))
  paths <- .by_cell(tracks, "t_s")
  if (length(paths) == 0) stop("there is no track to draw", call. = FALSE)
  if (from_start) paths <- lapply(paths, .from_start)
  groups <- vapply(paths, .group, "")
  names <- unique(groups)
  colours <- .colours(length(names))[match(groups, names)]
  range_of <- function(column) range(unlist(lapply(paths, `[[`, column)), na.rm = TRUE)
  x_seen <- range_of("x_um")
  y_seen <- range_of("y_um")
  below <- 0.12 * max(diff(x_seen), diff(y_seen), 1) # where the scale bar is
  .frame(x_seen, c(y_seen[1] - below, y_seen[2]), asp = 1, xlab = .micro("x (um)"), ylab = .micro("y (um)"), ...)
  .legend(.shown(names, tracks), .colours(length(names)))
  for (k in seq_along(paths)) lines(paths[[k]]$x_um, paths[[k]]$y_um, col = colours[k], lwd = 1.4)
  for (k in seq_along(paths)) {
    path <- paths[[k]]
    points(path$x_um[c(1, nrow(path))], path$y_um[c(1, nrow(path))], pch = 21, col = colours[k], bg = c("white", colours[k]), cex = 0.9)
  }
  .scale_bar()
  invisible(tracks)
}

plot_msd <- function(x, cell = NULL, ...) {
  of_study <- !is.data.frame(x) && .is_study(x)
  if (of_study && !is.null(cell)) stop("cell: the table of a study is of all its cells; plot_msd(read_msd(study, cell)) draws some", call. = FALSE)
  rows <- if (of_study) read_results(x, "msd.csv") else .rows_of(x, cell, read_msd, c("id", "cell", "lag_s", "msd_um2"))
  rows <- rows[rows$msd_um2 > 0 & !is.na(rows$msd_um2), ]
  if (nrow(rows) == 0) {
    stop("there is no mean square displacement: its lags are 10 min to half a run, so a run of 20 min has the first", call. = FALSE)
  }
  if (length(unique(rows$lag_s)) < 2) return(.only_one_lag(rows))
  curves <- if (of_study) split(rows, factor(rows$point, unique(rows$point))) else .by_cell(rows, "lag_s")
  groups <- if (of_study) names(curves) else vapply(curves, .group, "")
  names <- unique(groups)
  colours <- .colours(length(names))[match(groups, names)]
  band <- function(curve, sign) pmax(curve$msd_um2 + sign * curve$sem_um2, curve$msd_um2 / 10)
  lags <- range(rows$lag_s) / 60
  slopes <- min(rows$msd_um2[rows$lag_s == min(rows$lag_s)]) * rbind(1, lags[2] / lags[1], (lags[2] / lags[1])^2)
  bands <- if (of_study) c(band(rows, 1), band(rows, -1))
  .frame(lags, range(rows$msd_um2, slopes, bands, na.rm = TRUE),
    log = "xy", xlab = "lag (min)", ylab = .micro("mean square displacement (um2)"), ...
  )
  .legend(.shown(names, if (of_study) read_results(x) else rows), .colours(length(names)))
  for (k in 1:2) lines(lags, c(slopes[1], slopes[k + 1]), lty = 2, col = "grey60")
  if (lags[2] > lags[1]) text(lags[2], slopes[2:3], c("slope 1", "slope 2"), adj = c(1, -0.4), cex = 0.8, col = "grey40", xpd = NA)
  for (k in seq_along(curves)) {
    curve <- curves[[k]]
    lag <- curve$lag_s / 60
    if (of_study) {
      known <- !is.na(curve$sem_um2)
      outline <- c(band(curve, 1)[known], rev(band(curve, -1)[known]))
      polygon(c(lag[known], rev(lag[known])), outline, col = adjustcolor(colours[k], 0.15), border = NA)
    }
    lines(lag, curve$msd_um2, type = "o", pch = 16, cex = 0.6, col = colours[k], lwd = 1.4)
  }
  invisible(rows)
}

plot_boxes <- function(study, readout = "v_migr_abs_um_per_h", ...) {
  results <- read_results(study)
  results <- results[results$status == "done", ]
  columns <- names(results)
  known <- columns[-seq_len(match("trajectory_hash", columns))]
  if (!is.character(readout) || length(readout) != 1 || !readout %in% known) {
    stop(readout[1], ": is no read-out of ", study, "; there are ", paste(known, collapse = ", "), call. = FALSE)
  }
  samples <- split(results[[readout]], factor(results$label, unique(results$label)))
  if (all(is.na(results[[readout]]))) stop(study, ": ", readout, " has no value in any of its runs", call. = FALSE)
  named <- .points_of(results, names(samples))
  whole <- all(results[[readout]] == round(results[[readout]]), na.rm = TRUE) && !grepl("(", .label_of(readout), fixed = TRUE)
  .frame(c(0.5, length(samples) + 0.5), range(results[[readout]], na.rm = TRUE),
    xlab = named$title, ylab = .label_of(readout), xaxt = "n", yaxt = if (whole) "n" else "s", ...
  )
  if (whole) axis(2, unique(round(pretty(results[[readout]]))), las = 1)
  boxed <- vapply(samples, function(sample) sum(!is.na(sample)), 1) >= .least_for_box
  boxes <- boxplot(samples, plot = FALSE)
  if (any(boxed)) {
    boxplot(samples[boxed], at = which(boxed), add = TRUE, axes = FALSE, outline = FALSE, boxwex = 0.5, col = "grey95", medcol = .colours(1), whisklty = 1)
  }
  for (k in seq_along(samples)) {
    sample <- samples[[k]]
    points(k + .beside(length(sample)), sample, pch = 19, col = adjustcolor(.colours(1), 0.6))
  }
  .labels_below(named$labels)
  invisible(boxes)
}

.least_for_box <- 5 # runs that a box is drawn of; of fewer the runs alone

# Where dots of n runs are beside the middle of their point: few stay near it, so that none seems to have another value.
.beside <- function(n) 0.03 * (seq_len(n) - (n + 1) / 2) * min(1, 8 / n)

# The parameters by which a study names its points, as columns of its tables; none where labels are the author's own.
.naming <- function(table, labels) {
  columns <- names(table)
  last <- match("replicate", columns) - 1
  if (!"label" %in% columns || is.na(last)) return(character())
  found <- columns[seq_len(last)][-seq_len(match("label", columns))]
  named <- vapply(.last_word(found), function(word) all(grepl(paste0("(^|[ .])", word, " "), labels)), TRUE)
  if (all(named)) found else character()
}

.last_word <- function(column) sub(".*[.]", "", sub("_[^_.]*$", "", column)) # "youngs_modulus" of "ecm.youngs_modulus_Pa"

# Labels of points as figures show them: labels of the author as they are.
.shown <- function(labels, table) if (length(.naming(table, labels)) > 0) .in_words(labels) else labels

# What the points of a study are called: the values alone, below the title of an axis, where a single parameter of numbers names them; else their labels.
.points_of <- function(results, labels) {
  column <- .naming(results, labels)
  if (length(column) != 1 || !is.numeric(results[[column[1]]])) return(list(labels = .shown(labels, results), title = ""))
  made <- .last_word(column)
  unit <- sub(".*_", "", column)
  section <- if (made %in% .shared_words) paste0(gsub("[._]", " ", sub("[.][^.]*$", "", sub("_[^_.]*$", "", column))), ": ") else ""
  list(labels = format(results[[column]][match(labels, results$label)], trim = TRUE), title = .micro(paste0(section, .in_words(made), " (", unit, ")")))
}

# Last words of parameters that several sections have: their titles name the section.
.shared_words <- c("bending_stiffness", "force", "initiation_rate", "particles", "radius", "repulsion", "repulsion_range", "spring_stiffness", "stiffness")

# Labels of points with the names of parameters as words; symbols such as F_am stay.
.in_words <- function(labels) {
  words <- gsub("([a-z]{2})_([a-z]{2})", "\\1 \\2", gsub("\\bum\\b", .micro("um"), labels))
  gsub("\\byoungs\\b", "Young's", gsub("\\bpoissons\\b", "Poisson's", words))
}

.only_one_lag <- function(rows) {
  plot(0, 0, type = "n", axes = FALSE, xlab = "", ylab = "")
  text(0, 0, paste0("a single lag, ", rows$lag_s[1] / 60, " min: two are needed for a curve,\nof a run of 40 min"))
  invisible(rows)
}

# What a folder or a data frame has of some cells.
.rows_of <- function(x, cell, read, columns) {
  if (!is.data.frame(x)) return(read(x, cell))
  missing <- setdiff(columns, names(x))
  if (length(missing) > 0) stop("x: has no column ", missing[1], call. = FALSE)
  if (is.null(cell)) x else .of_cells(x, cell, "x")
}

# A table for each cell of each run: two cells are never one track, and neither are the same cell under two labels.
.by_cell <- function(table, column) {
  key <- if (is.null(table$label)) table$id else paste(table$id, table$label)
  twice <- anyDuplicated(data.frame(key, table[[column]]))
  if (twice > 0) {
    stop("x: has two rows of ", table$id[twice], " at ", column, " = ", table[[column]][twice], "; give runs of one name an id of their own", call. = FALSE)
  }
  unname(split(table, factor(key, unique(key))))
}

.from_start <- function(path) {
  path$x_um <- path$x_um - path$x_um[1]
  path$y_um <- path$y_um - path$y_um[1]
  path
}

# What shares a colour: the point of a study, else the cell.
.group <- function(table) as.character(if (is.null(table$label)) table$id[1] else table$label[1])

.colours <- function(n) { # which all eyes can separate
  known <- c("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#f0e442")
  if (n <= length(known)) known[seq_len(n)] else hcl.colors(n, "viridis")
}

# Units as they are printed, where the locale has the letters.
.micro <- function(text) {
  if (l10n_info()$`UTF-8`) gsub("um", "\u00b5m", gsub("um2", "\u00b5m\u00b2", text)) else text
}

.label_of <- function(readout) {
  known <- readouts()
  row <- match(readout, known$name)
  if (is.na(row)) return(readout)
  paste0(known$meaning[row], if (!known$unit[row] %in% c("", "-")) .micro(paste0(" (", known$unit[row], ")")))
}

.frame <- function(x, y, ...) {
  own <- list(x = x, y = y, type = "n", las = 1, bty = "l")
  given <- list(...)
  do.call(plot, c(own[setdiff(names(own), names(given))], given))
}

# Above the figure if one line is enough, else in it; none for more names than the eye can separate.
.legend <- function(names, colours) {
  if (length(names) < 2 || length(names) > 8) return(invisible())
  above <- length(names) * (0.8 * max(strwidth(names, "inches")) + 0.5) < par("pin")[1]
  if (above) return(legend("bottomleft", inset = c(0, 1), xpd = NA, horiz = TRUE, legend = names, col = colours, lwd = 2, cex = 0.8, bty = "n"))
  room <- par("pin")[1] - 0.6
  broken <- .broken(names, max(20, floor(30 * room / (0.8 * strwidth(strrep("n", 30), "inches")))))
  cex <- min(0.8, room / max(strwidth(broken, "inches")))
  legend("topleft", legend = broken, col = colours, lwd = 2, cex = cex, bty = "n")
}

# Labels in lines of at most some letters, broken at blanks where there are any.
.broken <- function(labels, letters) {
  words <- function(label) gsub(paste0("(\\S{", letters, "})(?=\\S)"), "\\1 ", label, perl = TRUE)
  vapply(labels, function(label) paste(strwrap(words(label), letters + 1), collapse = "\n"), "", USE.NAMES = FALSE)
}

# A bar of a round length, at most a quarter of the width, in the lower right corner.
.scale_bar <- function() {
  box <- par("usr")
  quarter <- (box[2] - box[1]) / 4
  steps <- c(1, 2, 5) * 10^floor(log10(quarter))
  length <- max(steps[steps <= quarter])
  right <- box[2] - 0.04 * (box[2] - box[1])
  low <- box[3] + 0.04 * (box[4] - box[3])
  segments(right - length, low, right, low, lwd = 3, lend = "butt")
  text(right - length / 2, low, .micro(paste(format(length), "um")), pos = 3, cex = 0.8)
}

# Labels of boxes: in a line; aslant where they would touch, and whole: in as many lines and as small as the margins ask.
.labels_below <- function(labels) {
  at <- seq_along(labels)
  if (max(strwidth(labels)) < 0.95) return(axis(1, at, labels, tick = FALSE))
  step <- par("pin")[1] / (length(labels) + 0.2) # between two labels [inch]
  below <- par("mai")[1] - 0.05 * par("pin")[2]
  left <- par("mai")[2] + 0.5 * step
  for (cex in c(0.8, 0.65, 0.5, 0.4)) for (lines in 1:8) {
    shown <- .broken(labels, max(8, ceiling(1.15 * max(nchar(labels)) / lines)))
    width <- max(strwidth(shown, "inches", cex = cex))
    height <- max(strheight(shown, "inches", cex = cex))
    fits <- width * sin(pi / 6) + height * cos(pi / 6) < below && width * cos(pi / 6) < left && height / sin(pi / 6) < step
    if (fits) return(text(at, grconvertY(-0.03, "npc"), shown, srt = 30, adj = c(1, 1), xpd = NA, cex = cex))
  }
  text(at, grconvertY(-0.03, "npc"), shown, srt = 30, adj = c(1, 1), xpd = NA, cex = cex)
}
