#pragma once

#include "observe/tracks.hpp"
#include "parameters/parameters.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The read-outs of Heck et al. 2020, section "Migration measures", Eq. (9) and Figs 5-11: one number each for a cell
/// of a run. Test: tests/unit/observe/readouts_test.cpp
namespace matrigrate {

// How the cell spreads and in which direction. Test: tests/unit/observe/motion_test.cpp

/// Mean square displacement at one lag.
struct MsdPoint {
  double lag = 0.0;        ///< [s]
  double msd = 0.0;        ///< mean over all start times, overlapping [um^2]
  std::size_t samples = 0; ///< start times
};

/// Mean square displacement of the centre of mass (Heck et al. 2020, section on the number of protrusions), at lags of
/// 1, 2, 3 ... intervals up to half of the time; empty where the rows do not fall on multiples of the interval.
/// @param interval  [s]
std::vector<MsdPoint> mean_square_displacement(std::span<const TrackRow> rows, double interval);

/// Slope of log MSD over log lag by least squares: 1 for a random walk, 2 for a straight path. NaN with fewer than
/// three lags [-].
double msd_slope(std::span<const MsdPoint> points);

/// How a path runs to a direction taken without sign, as that of fibres. Angles: 0 along, 90 across, 45 on average
/// where all directions in the plane are equally likely [degrees]; NaN without a path.
struct Guidance {
  double path_angle = undefined; ///< mean over the steps, each weighted by its length
  double step_angle = undefined; ///< mean over the steps, each counted alike
  double net_angle = undefined;  ///< of the displacement from start to end
  /// Mean square displacement along the direction over that across it, at lags of 1, 3 and 6 h, each over all start
  /// times, overlapping; 1 where the path has no direction; NaN of a shorter path, and where it never goes across [-].
  /// Of several runs, add up the squares first: the mean of ratios is ruled by the runs that hardly go across.
  std::array<double, 3> ratios{undefined, undefined, undefined};
};

/// @param direction  angle of the fibres [rad]   @param interval  of the steps [s]
Guidance guidance(std::span<const TrackRow> rows, double direction, double interval);

/// Mean over the entries whose value is defined.
struct Mean {
  double value = undefined; ///< NaN where there are none
  std::size_t n = 0;
};

/// Mature protrusions of one orientation among uniaxial fibres: along them within 45 degrees, or across (Fig 13).
struct OrientedProtrusions {
  Mean f_mat;    ///< at the end of maturation [-]
  Mean ruptured; ///< share of those whose adhesion ended by rupture or disassembly that ruptured [-]
};

/// NaN where a run does not define a value.
struct ReadOuts {
  double duration = undefined;          ///< from the first to the last row [s]
  double v_migr_abs = undefined;        ///< |x_cm(end) - x_cm(0)| / duration [um/h]
  double v_migr_path_60s = undefined;   ///< length of the path of x_cm sampled every 60 s / duration [um/h]
  double v_migr_path_600s = undefined;  ///< the same, sampled every 600 s [um/h]
  std::size_t n_protrusions = 0;        ///< initiated
  std::size_t n_unadhered = 0;          ///< of them, ended growth where no solid was in reach
  Mean tau_prot;                        ///< life of an adhesion, from the end of maturation to disassembly [min]
  std::size_t n_censored = 0;           ///< mature adhesions that the run outlived: not in tau_prot
  Mean l_prot;                          ///< length at the end of growth, of those that adhered [um]
  Mean f_mat;                           ///< at the end of maturation [-]
  Mean force;                           ///< of mature adhesions at disassembly [nN]
  Mean f_adh_rel;                       ///< Eq. (9): force / (2 f_mat F_am) at disassembly, of both strands [-]
  double mean_simultaneous = undefined; ///< protrusions alive, of all phases, mean over the rows
  std::size_t max_simultaneous = 0;     ///< the largest number of them in a row
  double msd_slope = undefined; ///< log-log slope of the mean square displacement, lags of 10 min to half the run [-]
  Guidance guidance;            ///< to uniaxial fibres, steps of 600 s
  OrientedProtrusions along;    ///< uniaxial fibres
  OrientedProtrusions across;   ///< uniaxial fibres

  // Needed by claims.
  double share_low_force = undefined; ///< of mature adhesions that ended, those with f_adh_rel < low_relative_force [-]
  double share_2_or_3 = undefined;    ///< of the rows, those with 2 or 3 protrusions alive [-]
  double migration_index = undefined; ///< way along x over the path sampled every 600 s, from -1 to 1 [-]

  // Of several cells; all but the first are those of the group, the same for each cell.
  double parting_index = undefined; ///< cosine between displacement and the way off the nearest cell at the start [-]
  double share_in_contact = undefined; ///< of the rows of the group, those with a contact between cells [-]
  double nearest = undefined;          ///< mean distance of a cell from the nearest other one, at the end [um]
  double order = undefined;            ///< mean of GroupRow::order over time [-]
};

/// An adhesion counts as ended "at a low force" below this f_adh_rel (Eq. 9): half of what its maturation stands for.
inline constexpr double low_relative_force = 0.5;

/// Of the values that are defined, the share below low_relative_force; NaN where there are none.
double share_of_low_forces(std::span<const double> relative_forces);

/// f_adh_rel of one protrusion, Eq. (9): its force over mature_pull(); NaN if its adhesion has not matured or not ended
/// [-].
double relative_force(const ProtrusionRecord& r, const Parameters& p);

/// Length of the path of the centre of mass, sampled at multiples of an interval and at the last row; NaN if the rows
/// lie further apart than the interval, or span less than it [um].
/// @param interval  [s]
double path_length(std::span<const TrackRow> rows, double interval);

/// @param rows     in the order of time
/// @param records  of all protrusions, ended or alive
ReadOuts readouts(std::span<const TrackRow> rows, std::span<const ProtrusionRecord> records, const Parameters& p);

/// Results of one cell of a run.
struct CellResult {
  std::uint32_t cell = 0;                  ///< its id
  std::vector<TrackRow> rows{};            ///< in the order of time
  std::vector<ProtrusionRecord> records{}; ///< of all protrusions, ended or alive, in the order of their initiation
  ReadOuts readouts{};
};

/// Adds to the read-outs of several cells what they do together. @param group  in the order of time
void add_group(std::span<CellResult> cells, std::span<const GroupRow> group);

/// Results of all cells, in their order.
/// @param rows   of all cells, in the order of time
/// @param group  of several cells, in the order of time
std::vector<CellResult> cell_results(const State& s, std::span<const TrackRow> rows, std::span<const GroupRow> group,
                                     const Parameters& p);

} // namespace matrigrate
