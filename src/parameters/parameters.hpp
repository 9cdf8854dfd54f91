#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace matrigrate::fields {
class Grids;
}

/// Every parameter of a simulation, in internal units: um, s, nN; stress in kPa, viscosity in nN s/um^2 = 1000 Pa s.
/// Defaults are Table 1 of Heck et al. 2020 and the interpretations of MODEL.md. Their names, units, ranges and sources
/// are in schema.cpp alone; presets.cpp, version.cpp and study_plan/settings.cpp name some of them.
namespace matrigrate {

/// Arrangement of the matrix particles at the start.
enum class Lattice { square, hexagonal };

/// How a step is taken: as it is, or halved where something moves far, with an elasticity that bears longer steps.
enum class Integrator { reference, adaptive };

/// The time step of a scenario that names none: the paper's, or the longest one of the adaptive integrator, which
/// divides a minute (MODEL.md, I29) [s].
constexpr double usual_time_step(Integrator integrator) { return integrator == Integrator::reference ? 0.4 : 5.0; }

struct RunParameters {
  double duration = 6.0 * 3600.0; ///< [s]
  Integrator integrator = Integrator::reference;
  double time_step = usual_time_step(Integrator::reference); ///< of the adaptive integrator the longest one [s]
  std::uint64_t seed = 1;
  int threads = 0; ///< 0: as many as pay; never changes a result
};

/// Fields of the matrix over the plane, as texts of formulas or files (fields/field.hpp); empty: the same everywhere.
struct EcmFieldParameters {
  std::string youngs_modulus;    ///< in place of ecm.youngs_modulus [Pa]
  std::string f_degr;            ///< f_degr at the start [-]
  std::string ligand;            ///< what adhesions need, over the usual [-]
  std::string attractant;        ///< concentration of chemoattractant, at the start and at the rim [-]
  std::string attractant_source; ///< release of chemoattractant [1/s]
  std::string obstacle;          ///< from 1/2 on part of a rigid obstacle [-]
};

struct EcmParameters {
  double radius = 150.0;         ///< radius of the disc [um]
  double particle_spacing = 2.0; ///< dp [um]
  double smoothing_length = 2.6; ///< h [um]; the kernel's support is 2h
  Lattice lattice = Lattice::square;
  double thickness = 1.0;        ///< t_z [um]
  double youngs_modulus = 0.2;   ///< E [kPa]
  double poissons_ratio = 0.45;  ///< nu [-]
  double viscosity = 1.0;        ///< mu [nN s/um^2]
  bool cell_hole = true;         ///< the cell's disc and margin start as fluid
  double hourglass_weight = 0.5; ///< a_hg [-]
  double support_floor = 0.3;    ///< smallest eigenvalue of the support tensor that is inverted as it is [-]
  double orphan_support = 0.2;   ///< a solid particle with less of its intact support becomes fluid [-]
  double density_min = 0.6;      ///< lower bound of rho/rho_0 [-]
  double density_max = 1.8;      ///< upper bound of rho/rho_0 [-]
  double verlet_skin = 0.5;      ///< neighbours are listed up to 2h + skin [um]
  double drag_lag = 0.001;       ///< drag is taken at positions up to so far behind [um]
  EcmFieldParameters fields;
};

/// Which reference neighbours are joined by fibres.
enum class FibreArrangement { none, isotropic, uniaxial };

/// Fields of the fibres over the plane, as EcmFieldParameters.
struct FibreFieldParameters {
  std::string direction_deg; ///< in place of fibres.direction_deg [degrees]
  std::string stiffness;     ///< in place of fibres.stiffness [Pa]
};

struct FibreParameters {
  FibreArrangement arrangement = FibreArrangement::none;
  double direction_deg = 0.0;       ///< of the fibres of a uniaxial matrix, from the x axis [degrees]
  double half_angle_deg = 30.0;     ///< pairs up to this far off the direction are joined [degrees]
  double stiffness = 1.0;           ///< k_0 [kPa]
  double onset = 0.075;             ///< eps_s, strain at which stiffening begins [-]
  double stiffening_strain = 0.033; ///< d_s, strain in which the stiffness grows by e [-]
  FibreFieldParameters field;
};

/// How the drag system of a step is solved: by conjugate gradients, preconditioned by multigrid or by the diagonal.
enum class SolverMethod { multigrid, conjugate_gradient };

struct CellParameters {
  double radius = 15.0;             ///< R [um]
  double start_x = 0.0;             ///< centre at the start [um]
  double start_y = 0.0;             ///< centre at the start [um]
  int particles = 235;              ///< particles of the cortex
  double spring_stiffness = 2.8;    ///< k_s [nN/um]
  double crowding = 0.5;            ///< share of its initial length below which a segment resists compression [-]
  double dashpot = 2.5;             ///< eta_c [nN s/um]
  double bending_stiffness = 0.36;  ///< k_bend [nN um]
  double area_stiffness = 0.71e-3;  ///< k_A [nN/um^2]
  double repulsion_stiffness = 1.4; ///< k_rep [nN/um^1.5]
  double repulsion_distance = 0.2;  ///< d_rep [um]
  double liquid_drag = 0.04;        ///< gamma_liquid [nN s/um^2]; times t_z a particle's drag
};

/// Contact of cells with each other (MODEL.md, I38, I39).
struct CellContactParameters {
  double repulsion = 0.5;       ///< pressure at which two cortices touch [kPa]
  double repulsion_range = 1.0; ///< gap below which they repel each other [um]
  double adhesion = 0.0;        ///< largest pull per area [kPa]
  double adhesion_range = 1.0;  ///< width of the gaps, beyond `repulsion_range`, over which they pull [um]
};

struct ContactParameters {
  double range = 1.4;             ///< d_c [um]
  double sample_spacing = 0.8;    ///< points of the viscous coupling on a segment are no further apart [um]
  double fluid_share = 0.2;       ///< of the viscous coupling to solid, with the fluid outside growing and maturing
                                  ///< protrusions [-]
  double body_fluid_share = 0.08; ///< the same of the rest of the cortex [-]
  double deepest_solid = 0.3;     ///< a solid particle deeper inside the cell becomes fluid at once [um]
  CellContactParameters cells;
};

/// The nucleus of each cell (MODEL.md, I40); the paper has none.
struct NucleusParameters {
  double radius = 0.0;              ///< at the start; 0: no nucleus [um]
  double shear_modulus = 0.1;       ///< G of the chromatin [kPa]
  double stretch_stiffness = 0.5;   ///< Y, tension of the lamina over its strain [nN]
  double bending_stiffness = 0.05;  ///< B of the lamina, moment over curvature [nN um^2]
  double bulk_modulus = 5.0;        ///< K, pressure over the lost share of the area [kPa]
  double retardation_time = 10.0;   ///< of the springs of lamina and chromatin, dashpot over stiffness [s]
  double centring_stiffness = 0.02; ///< k_c, of the filaments that hold it in the middle of the cell [nN/um]
  double drag = 1.0;                ///< of the nucleus in the cytoplasm, which moves with the cortex [nN s/um]
  double repulsion = 2.0;           ///< q, pressure at which it touches the cortex [kPa]
  double repulsion_range = 0.5;     ///< r, gap to the cortex below which it is repelled [um]
  int particles = 72;
};

struct ActomyosinParameters {
  double force = 0.6;               ///< F_am [nN]
  double f_mat_body = 0.05;         ///< f_mat of the cell's body [-]
  double curvature_optimum = -0.15; ///< kappa_0 [1/um], convex positive
  double curvature_width = 0.25;    ///< kappa_w [1/um]
};

struct ProtrusionParameters {
  double initiation_rate = 6e-5;               ///< r_prot, a front particle [1/s]
  int half_width = 20;                         ///< w_prot, particles to each side of the centre
  int tip_half_width = 3;                      ///< w_f, particles to each side of the centre that push
  double force = 0.32;                         ///< F_prot, shared by the pushing particles [nN]
  double growth_time = 400.0;                  ///< T_prot [s]
  double spring_stiffness = 2.8e-3;            ///< k_s,prot [nN/um]
  double deflection_rate = 0.1;                ///< r_defl [1/s]
  double deflection_cone = 1.0471975511965976; ///< half opening of the cone that is looked at [rad]
  double spreading_rate = 0.5;                 ///< speed at which growing particles slide towards equal spacing [1/s]
  double finishing_time = 400.0;               ///< T_finish [s]
  int number = 0; ///< n_prot, target number of simultaneous protrusions; 0: initiated at initiation_rate
  double candidate_interval = 0.4; ///< with a kept number: one candidate is drawn in so much time [s]
  double rear_share = 0.01; ///< with a kept number: chance of a particle of the rear over that of one of the front [-]
  double least_facing = 0.87; ///< least mean of max(0, n . d_prot) of the pushing particles at initiation [-]
  double area_limit = 2.0;    ///< with a kept number: none is initiated beyond this area over A_0 [-]
};

struct AdhesionParameters {
  double stiffness = 2.0;          ///< k_ad [nN/um]
  double rest_length = 5.0;        ///< l_0,adh [um]
  double spread = 1.0;             ///< smoothing length of its kernel over that of the matrix [-]
  double least_support = 0.02;     ///< share of solid around the anchor below which the adhesion is lost [-]
  double maturation_time = 600.0;  ///< T_mat [s]
  double step_threshold = 0.98;    ///< share of a step's force at which the next one begins [-]
  double rest_speed = 0.0027;      ///< of the tip, below which the first step may be done [um/s]; 0: at any speed
  double base_drag = 1000.0;       ///< drag of each pinned base particle while maturing [nN s/um]
  int pinned_particles = 3;        ///< of either end of a maturing protrusion
  double maturation_strands = 1.0; ///< strands of actomyosin whose full pull is the F_am of F_mat [-]
  double handover_time = 0.4;      ///< in which the bundle gives way [s]
  double handover_share = 0.9;     ///< of f_mat F_am that bundle and cortex together put on the adhesion [-]
  double r_off_min = 2.78e-4;      ///< [1/s]
  double r_off_0 = 0.2;            ///< [1/s]
  double zeta_diss = 20.0;         ///< [1/nN]
  bool rupture = false;            ///< whether an adhesion breaks at rupture_ratio
  double rupture_ratio = 1.0;      ///< f_rupt [-]
};

struct PolarizationParameters {
  double rate = 1.1e-3; ///< r_pol [1/s]
};

struct DegradationParameters {
  double tip_rate = 0.2;            ///< r_degr,tip [1/s]
  double tip_distance = 2.4;        ///< [um]
  double protrusion_rate = 0.033;   ///< [1/s]
  double protrusion_distance = 1.4; ///< [um]
  double body_rate = 0.033;         ///< [1/s]
  double body_distance = 1.9;       ///< reach of degradation around the cell's body [um]
  double rear_share = 1.0;          ///< rate around the rear half of the body over body_rate [-]
  double smaller_share = 1.0;       ///< of the smaller of solid and contact pressure, added to the larger [-]
  double threshold = 0.02;          ///< p_th,degr, pressure above which protrusion and body degrade [kPa]
};

/// The attractant, which the paper does not have; laws.initiation_bias says what a cell makes of it.
struct CueParameters {
  double half_occupancy = 1.0; ///< K_d, concentration at which half of the receptors bind [-]
  double diffusion = 0.0;      ///< of the attractant; 0: it stays where it is [um^2/s]
  double decay = 0.0;          ///< of the attractant [1/s]
  double uptake = 0.0;         ///< of the attractant inside cells [1/s]
};

struct Row;

/// A number of the user's own that laws may name (parameters/laws/constants.hpp).
struct LawConstant {
  std::string name;
  double value = 0.0;             ///< in internal units
  std::shared_ptr<const Row> row; ///< its unit is that of formulas, 1 of a plain number; shared by copies
};

/// Laws as formulas; parameters/laws/law.hpp says what they may contain.
struct LawParameters {
  std::string fibre_stiffness = "eps < 0 ? 0 : eps <= eps_s ? 1 : exp((eps - eps_s)/d_s)"; ///< over k_0, Eq. 5 [-]
  std::string curvature_factor = "exp(-((kappa - kappa_0)/kappa_w)^2)";                    ///< f_curv of Eq. 6 [-]
  std::string contraction = "f_mat*f_curv*F_am";                                           ///< of a segment, Eq. 6 [nN]
  std::string maturation_force = "0.1*sum(steps, s_mat)*(m_mat*F_am)";          ///< that completes a step [nN]
  std::string maturation = "min(1, 0.1*steps)";                                 ///< f_mat after so many steps [-]
  std::string adhesion_stiffness = "k_ad";                                      ///< [nN/um]
  std::string disassembly_rate = "r_off_min + r_off_0*exp(-zeta_diss*F/f_mat)"; ///< r_off, Eq. 7 [1/s]
  std::string growth_force = "n_prot > 0 && A > 1 ? 1/A : 1";                   ///< over F_prot, Eq. 10 [-]
  std::string initiation_rate = "r_prot";                                       ///< of a particle [1/s]
  std::string initiation_bias = "1";                                            ///< over its mean [-]
  std::string polarization_rate = "r_pol";                                      ///< [1/s]
  std::string degradation_tip = "r_degr_tip";                                   ///< [1/s]
  std::string degradation_protrusion = "p > p_th_degr ? r_degr_prot : 0";       ///< [1/s]
  std::string degradation_body = "p > p_th_degr ? r_degr_body : 0";             ///< [1/s]
  std::vector<LawConstant> constants;                                           ///< by their names
};

struct OutputParameters {
  double track_interval = 60.0;             ///< [s]
  double checkpoint_interval = 600.0;       ///< of the checkpoint to resume from; 0: only when the run stops [s]
  double kept_checkpoint_interval = 3600.0; ///< of checkpoints that are kept, to branch from; 0: none [s]
  double field_interval = 300.0;            ///< of frames in fields.h5 and in the report's player; 0: none [s]
  bool report = true;                       ///< report.html
};

struct SolverParameters {
  SolverMethod method = SolverMethod::multigrid;
  double tolerance = 1e-4; ///< relative residual at which the drag system counts as solved [-]
  int max_iterations = 5000;
};

/// Where one of several cells starts.
struct CellStart {
  double x = 0.0; ///< of its centre [um]
  double y = 0.0; ///< of its centre [um]
};

/// A parameter that gets another value in the middle of a run (parameters/changes.hpp).
struct TimedChange {
  double at = 3.0 * 3600.0; ///< holds in steps that begin then or later [s]
  std::string path;         ///< of the parameter
  std::string value;        ///< as it stands in a scenario file
};

/// What the file of another version says beyond the parameters. No parameter: no result depends on it.
struct Origin {
  std::string version; ///< of the program that wrote the file, if its model is another (parameters/version.hpp)
  std::map<std::string, std::string, std::less<>> gone; ///< readings that no program of this version computes
                                                        ///< (parameters/version.hpp): path and value
};

struct Parameters {
  RunParameters run;
  EcmParameters ecm;
  FibreParameters fibres;
  CellParameters cell;
  ContactParameters contact;
  NucleusParameters nucleus;
  ActomyosinParameters actomyosin;
  ProtrusionParameters protrusion;
  AdhesionParameters adhesion;
  PolarizationParameters polarization;
  DegradationParameters degradation;
  CueParameters cues;
  LawParameters laws;
  OutputParameters output;
  SolverParameters solver;
  std::vector<CellStart> cells;     ///< of several cells; empty: one, which starts at (cell.start_x, cell.start_y)
  std::vector<TimedChange> changes; ///< in the order of their times

  /// No parameter: what was read of the files that fields name, kept by readers and shared by copies
  /// (fields/grids.hpp).
  std::shared_ptr<fields::Grids> grids;

  Origin origin;
};

/// Where the cells start, in the order of their ids: Parameters::cells, or the one at cell.start_x, cell.start_y.
std::vector<CellStart> cell_starts(const Parameters& p);

} // namespace matrigrate
