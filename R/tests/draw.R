# The figures are drawn on the examples, each cell as a path of its own, with equal axes.
library(matrigrate)

refused <- function(words, expression) {
  message <- tryCatch({ expression; "no error" }, error = conditionMessage)
  if (!grepl(words, message, fixed = TRUE)) stop("expected '", words, "', got: ", message)
}
pair <- system.file("extdata", "pair", package = "matrigrate")
study <- system.file("extdata", "stiffness-study", package = "matrigrate")
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
