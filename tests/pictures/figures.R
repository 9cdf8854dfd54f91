# Draws the figures of the R package for viewer/tests/all_pictures.test.ts: figures.R SOURCE RUN STUDY FOLDER
given <- commandArgs(trailingOnly = TRUE)
source(file.path(given[1], "R", "matrigrate.R"))
drawn <- function(name, draw) {
  png(file.path(given[4], paste0("r-", name, ".png")), width = 640, height = 560, res = 96, type = "cairo")
  draw()
  dev.off()
}
drawn("path", function() plot_path(given[2]))
drawn("msd", function() plot_msd(given[2]))
drawn("boxes", function() plot_boxes(given[3], "v_migr_path_60s_um_per_h"))
drawn("paths-of-a-study", function() plot_path(given[3], from_start = TRUE))
