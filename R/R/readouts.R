# Unit and meaning of each read-out, as in docs/readouts.json; a test compares them.
readouts <- function() {
  table <- matrix(ncol = 3, byrow = TRUE, data = c(
    "duration_s", "s", "duration",
    "v_migr_abs_um_per_h", "um/h", "speed, start to end",
    "v_migr_path_60s_um_per_h", "um/h", "speed along the path, sampled every 60 s",
    "v_migr_path_600s_um_per_h", "um/h", "speed along the path, sampled every 600 s",
    "n_protrusions", "", "protrusions initiated",
    "n_unadhered", "", "protrusions that never adhered",
    "tau_prot_min", "min", "lifetime of a mature adhesion, mean",
    "n_tau_prot", "", "mature adhesions that ended",
    "n_censored", "", "mature adhesions still alive at the end",
    "l_prot_um", "um", "length of a protrusion at the end of growth, mean",
    "f_mat", "-", "maturation of protrusions, mean",
    "force_nN", "nN", "force of an adhesion at disassembly, mean",
    "f_adh_rel", "-", "force of an adhesion at disassembly over 2 f_mat F_am (both strands), mean",
    "n_simultaneous_mean", "", "protrusions at a time, mean",
    "n_simultaneous_max", "", "protrusions at a time, most",
    "msd_slope", "", "log-log slope of the mean square displacement, lags of 10 min to half the run",
    "path_angle_deg", "degrees", "mean angle of the path to uniaxial fibres, each step of 600 s weighted by its length",
    "f_mat_along", "-", "maturation of protrusions along uniaxial fibres, mean",
    "f_mat_across", "-", "maturation of protrusions across uniaxial fibres, mean",
    "share_ruptured_along", "", "share of adhesions along uniaxial fibres that ended by rupture",
    "share_ruptured_across", "", "share of adhesions across uniaxial fibres that ended by rupture",
    "share_f_adh_rel_low", "", "share of mature adhesions that ended below half of 2 f_mat F_am (both strands)",
    "share_2_or_3_protrusions", "", "share of times with two or three protrusions",
    "migration_index_x", "", "displacement along x over the length of the path, sampled every 600 s",
    "step_angle_deg", "degrees", "mean angle of the path to uniaxial fibres, each step of 600 s counted alike",
    "net_angle_deg", "degrees", "angle of the displacement from start to end to uniaxial fibres",
    "along_over_across_1h", "", "mean square displacement along uniaxial fibres over that across them, in an hour",
    "along_over_across_3h", "", "mean square displacement along uniaxial fibres over that across them, in 3 h",
    "along_over_across_6h", "", "mean square displacement along uniaxial fibres over that across them, in 6 h",
    "parting_index", "", "cosine between displacement and the direction away from the nearest cell at the start",
    "share_in_contact", "", "share of times with a contact between cells",
    "nearest_um", "um", "distance of the nearest other cell at the end, mean over cells",
    "order", "", "length of the mean unit vector of displacements over 10 min, mean over time"
  ))
  data.frame(name = table[, 1], unit = table[, 2], meaning = table[, 3])
}
