# The functions of the package without installing it: source("R/matrigrate.R") in a clone. The package is this folder: R CMD INSTALL R.
local({
  sourced <- Filter(Negate(is.null), lapply(sys.frames(), function(frame) frame$ofile))
  inside <- new.env(parent = globalenv())
  here <- dirname(sourced[[length(sourced)]])
  for (file in list.files(file.path(here, "R"), "[.]R$", full.names = TRUE)) sys.source(file, inside)
  list2env(mget(ls(inside), inside), parent.env(environment())) # names that begin with a dot stay inside
})
