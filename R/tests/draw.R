# The figures are drawn on the examples, each cell as a path of its own, with equal axes.
library(matrigrate)

refused <- function(words, expression) {
  message <- tryCatch({ expression; "no error" }, error = conditionMessage)
  if (!grepl(words, message, fixed = TRUE)) stop("expected '", words, "', got: ", message)
}
pair <- example_folder("pair")
study <- example_folder("stiffness-study")
file <- tempfile(fileext = ".pdf")
grDevices::pdf(file, compress = FALSE, width = 7, height = 5)

drawn <- plot_path(pair)
micrometre <- par("pin") / c(diff(par("usr")[1:2]), diff(par("usr")[3:4])) # inches
stopifnot(identical(drawn, read_tracks(pair)), all.equal(micrometre[1], micrometre[2]))
tracks <- plot_path(read_tracks(pair), cell = 2, main = "cell 2")
stopifnot(tracks$cell == 2)
plot_path(study, from_start = TRUE)
usr <- par("usr")
stopifnot(usr[1] < 0, usr[2] > 0)

stopifnot(identical(plot_msd(pair)$id, read_msd(pair)$id), plot_msd(pair, cell = 1)$cell == 1, par("xlog"), par("ylog"))
stopifnot(nrow(plot_msd(study)) > 0, nrow(plot_msd(read_msd(study))) > 0)

boxes <- plot_boxes(study)
results <- read_results(study)
stopifnot(
  identical(boxes$names, unique(results$label)),
  all.equal(boxes$stats[3, ], as.vector(tapply(results$v_migr_abs_um_per_h, results$label, median)[boxes$names]))
)
invisible(grDevices::dev.off())

# Words on axes and in legends, a title with the unit and values alone below; no box of four runs, and no curve of one lag.
grDevices::pdf(file)
stopifnot(
  identical(matrigrate:::.points_of(results, unique(results$label)), list(labels = c("50", "200"), title = "Young's modulus (Pa)")),
  identical(matrigrate:::.in_words("protrusion_force 0.2, F_am 1"), "protrusion force 0.2, F_am 1"),
  !grepl("[[]| um|um2", matrigrate:::.label_of("v_migr_abs_um_per_h")), matrigrate:::.least_for_box == 5
)
one <- read_msd(study)
plot_msd(one[one$lag_s == min(one$lag_s), ])
stopifnot(!par("xlog"))
invisible(grDevices::dev.off())

# As many lines of a path as there are cells: in the file a line begins with "m" and goes on with "l" for each row.
grDevices::pdf(file, compress = FALSE)
plot_path(pair, axes = FALSE, ann = FALSE)
invisible(grDevices::dev.off())
parts <- grep(" [ml]$", readLines(file, warn = FALSE), value = TRUE)
steps <- rle(grepl(" l$", parts))
rows <- as.vector(table(read_tracks(pair)$id))
stopifnot(sum(steps$lengths[steps$values] == rows[1] - 1) == 2, rows[1] == rows[2])

refused("is no read-out of", plot_boxes(study, "speed"))
refused("there is no such folder", plot_path("nowhere"))
refused("has no cell 7", plot_path(pair, cell = 7))
refused("x: has two rows of pair/1 at t_s = 0", plot_path(rbind(read_tracks(pair), read_tracks(pair))))
refused("x: has no column id", plot_path(data.frame(x_um = 1, y_um = 1)))
refused("a run of 20 min has the first", plot_msd(read_msd(pair)[0, ]))

# Labels of an author stand as they are, and whole: each line of them begins within the figure.
own <- file.path(tempfile("study"))
dir.create(own)
labels <- c("soft_gel at $5, _weak_ contraction of 0.3 um", "one_word_that_is_longer_than_any_margin_of_this_figure_has_room_for")
invisible(file.copy(file.path(study, "study.resolved.toml"), own))
for (name in c("results.csv", "msd.csv")) {
  lines <- readLines(file.path(study, name))
  for (k in 1:2) lines <- gsub(c("youngs_modulus 50 Pa", "youngs_modulus 200 Pa")[k], paste0('"', labels[k], '"'), lines, fixed = TRUE)
  writeLines(lines, file.path(own, name))
}
grDevices::pdf(file, compress = FALSE, width = 5, height = 4)
plot_boxes(own)
plot_msd(own)
invisible(grDevices::dev.off())
texts <- grep(" Tm ", readLines(file, warn = FALSE, encoding = "latin1"), value = TRUE)
said <- gsub("^.*Tm \\[?\\(|\\)\\]? TJ?j?$", "", gsub("\\) -?[0-9]+ \\(", "", texts)) # without kerning
whole <- function(label) grepl(gsub(" ", "", label), gsub(" ", "", paste(said, collapse = "")), fixed = TRUE)
matrix <- lapply(strsplit(sub(" Tm .*", "", texts), " "), function(words) as.numeric(tail(words, 6)))
places <- vapply(Filter(function(m) m[1] > 0 && m[2] > 0, matrix), function(m) m[5:6], c(0, 0)) # of lines that are aslant
stopifnot(ncol(places) > 1, places >= 0, whole(labels[1]), whole(labels[2]))
invisible(file.remove(file))
