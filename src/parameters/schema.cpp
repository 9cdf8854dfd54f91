#include "parameters/schema.hpp"

#include <algorithm>
#include <array>

namespace matrigrate {

namespace {

constexpr std::string_view table_1 = "Heck et al. 2020, Table 1";
constexpr std::string_view methods = "Heck et al. 2020, Methods";
constexpr std::string_view paper = "Heck et al. 2020";
constexpr std::string_view chosen = "this program";

constexpr double max_seeds = 9007199254740991.0; // 2^53 - 1: every tool reads it back exactly
constexpr auto usual = Audience::usual;
constexpr auto numerical = Audience::numerical;
constexpr auto optional = Audience::optional;

constexpr Range closed(double low, double high) { return {low, high, true, true}; }
constexpr Range open(double low, double high) { return {low, high, false, false}; }
constexpr Range above(double low, double high) { return {low, high, false, true}; } ///< (low, high]
constexpr Range below(double low, double high) { return {low, high, true, false}; } ///< [low, high)
constexpr Range none{};
constexpr double half_turn = 3.141592653589793;

/// @param member  a captureless lambda that returns the member of the enumeration
template <class Enumeration>
constexpr Choice choice(Enumeration /*member*/, std::span<const std::string_view> names) {
  return {names, [](Parameters& p) { return static_cast<std::size_t>(Enumeration{}(p)); },
          [](Parameters& p, std::size_t index) {
            auto& value = Enumeration{}(p);
            value = static_cast<std::remove_reference_t<decltype(value)>>(index);
          }};
}

constexpr std::array<std::string_view, 2> integrators{"reference", "adaptive"};
constexpr std::array<std::string_view, 2> lattices{"square", "hexagonal"};
constexpr std::array<std::string_view, 3> fibre_arrangements{"none", "isotropic", "uniaxial"};
constexpr std::array<std::string_view, 2> solver_methods{"multigrid", "conjugate_gradient"};

bool has_several(const Parameters& p) { return !p.cells.empty(); }
bool has_nucleus(const Parameters& p) { return p.nucleus.radius != 0.0; }

double& start_x(Parameters& p) { return (p.cells.empty() ? p.cells.emplace_back() : p.cells.back()).x; }
double& start_y(Parameters& p) { return (p.cells.empty() ? p.cells.emplace_back() : p.cells.back()).y; }
double& time_of_change(Parameters& p) { return (p.changes.empty() ? p.changes.emplace_back() : p.changes.back()).at; }

/// @param before  the law of every version without these keys
constexpr Row law(std::string_view path, Access<std::string> member, std::string_view unit, Range range,
                  std::string_view source, std::string_view description, std::span<const LawVariable> arguments,
                  std::span<const LawVariable> shared, std::string_view before) {
  return {path, member, unit, range, "", source, description, optional, before, nullptr, arguments, shared};
}

// clang-format off
constexpr std::array all_sections{
    Section{"run", "The run: duration, time steps, random numbers"},
    Section{"ecm", "The extracellular matrix"},
    Section{"ecm.fields", "Fields of the matrix: properties that vary in space"},
    Section{"fibres", "Strain-stiffening fibres of the matrix"},
    Section{"fibres.field", "Fields of the fibres"},
    Section{"cell", "The cell"},
    Section{"contact", "Contact of cell and matrix"},
    Section{"contact.cells", "Contact of cells with each other"},
    Section{"nucleus", "The nucleus of the cell; off in the paper"},
    Section{"actomyosin", "Contraction of the cortex"},
    Section{"protrusion", "Initiation and growth of protrusions"},
    Section{"adhesion", "Adhesion, maturation and disassembly"},
    Section{"polarization", "Polarization of the cell"},
    Section{"degradation", "Degradation of the matrix by the cell"},
    Section{"cues", "Cues that bias where protrusions are initiated; off in the paper"},
    Section{"laws", "Laws as formulas, in um, s, nN and Pa"},
    Section{"output", "What a run writes, and how often"},
    Section{"solver", "The linear system of every step"},
};

constexpr std::array strain{LawVariable{"eps", "", -0.5, 1.0, 0.1, -0.1, 0.3, "strain of the fibre"}};
/// What the laws of a cell may use besides; those of no protrusion the first seven, that of f_mat all but the last.
constexpr std::array of_the_place{LawVariable{"x", "um", -2000.0, 2000.0, 0.0, -100.0, 100.0, "where the law acts: particle of the cortex, tip of the protrusion, particle of the matrix, centre of the cell"},
                                  LawVariable{"y", "um", -2000.0, 2000.0, 0.0, -100.0, 100.0, "the same"},
                                  LawVariable{"time", "s", 0.0, 1e7, 3600.0, 0.0, 21600.0, "time since the run began"},
                                  LawVariable{"density", "", 0.1, 10.0, 1.0, 0.8, 1.2, "density of the solid matrix around, over the initial one (without solid: 1)"},
                                  LawVariable{"pressure", "Pa", -1e4, 1e4, 0.0, -100.0, 500.0, "pressure of the solid matrix around (without: 0)"},
                                  LawVariable{"f_degr", "", 0.0, 1.0, 0.5, 0.0, 1.0, "intact fraction of the matrix around, with what is inside the cell"},
                                  LawVariable{"stiffness", "Pa", 0.0, 1e7, 200.0, 0.0, 1000.0, "Young's modulus of the solid matrix around (without: 0)"},
                                  LawVariable{"l", "um", 0.0, 100.0, 10.0, 0.0, 40.0, "length of the protrusion (elsewhere: 0)"},
                                  LawVariable{"age", "s", 0.0, 1e5, 1200.0, 0.0, 7200.0, "time since the protrusion began (elsewhere: 0)"},
                                  LawVariable{"t_mat", "s", 0.0, 1e5, 600.0, 0.0, 3600.0, "time since it matured (before, and elsewhere: 0)"},
                                  LawVariable{"f_mat", "", 0.0, 1.0, 0.5, 0.0, 1.0, "maturation of the protrusion, growing: 0 (elsewhere: that of the body)"}};
constexpr std::span all_shared{of_the_place};
constexpr std::span without_f_mat = all_shared.first(10);
constexpr std::span of_no_protrusion = all_shared.first(7);

constexpr std::array segment{LawVariable{"kappa", "1/um", -5.0, 5.0, 0.0, -1.0, 1.0, "curvature of the cortex (convex: positive)"}};
constexpr std::array strand{LawVariable{"f_mat", "", 0.0, 1.0, 0.5, 0.0, 1.0, "maturation of the strand, growing or maturing: 0"},
                            LawVariable{"f_curv", "", 0.0, 1.0, 1.0, 0.0, 1.0, "curvature_factor there"},
                            LawVariable{"kappa", "1/um", -5.0, 5.0, 0.0, -1.0, 1.0, "curvature of the cortex (convex: positive)"},
                            LawVariable{"speed", "um/s", -10.0, 10.0, 0.0, -0.1, 0.2, "speed at which the segment shortens"}};
constexpr std::array maturing{LawVariable{"steps", "", 0.0, 10.0, 3.0, 0.0, 10.0, "steps of maturation that are done"},
                              LawVariable{"F", "nN", 0.0, 10.0, 0.3, 0.0, 1.5, "force of the adhesion"},
                              LawVariable{"t", "s", 0.0, 1e5, 300.0, 0.0, 600.0, "time since the protrusion adhered, without the wait for its steps"}};
constexpr std::array matured{LawVariable{"steps", "", 0.0, 11.0, 3.0, 0.0, 11.0, "steps, the running one included: whole while the protrusion matures, in the end by its part"}};
constexpr std::array spring{LawVariable{"stretch", "um", 0.0, 10.0, 0.15, 0.0, 1.0, "length of the adhesion beyond its rest length"}};
constexpr std::array adhesion{LawVariable{"F", "nN", 0.0, 10.0, 0.3, 0.0, 1.5, "force of the adhesion"},
                              LawVariable{"f_mat", "", 0.01, 1.0, 0.5, 0.01, 1.0, "maturation of its protrusion"},
                              LawVariable{"t", "s", 0.0, 1e5, 600.0, 0.0, 3600.0, "time since contraction began"}};
constexpr std::array growth{LawVariable{"A", "", 0.1, 10.0, 1.0, 0.5, 3.0, "area of the cell over the initial one"},
                            LawVariable{"l", "um", 0.0, 100.0, 10.0, 0.0, 40.0, "length of the protrusion"},
                            LawVariable{"t", "s", 0.0, 1e5, 200.0, 0.0, 3600.0, "time since it began"},
                            LawVariable{"speed", "um/s", -10.0, 10.0, 0.0, -0.05, 0.2, "speed of its tip along its direction"}};
constexpr std::array place{LawVariable{"angle", "rad", -half_turn, half_turn, 0.0, -half_turn, half_turn, "angle to the polarization (before there is one: the mean of the law over all angles)"},
                           LawVariable{"kappa", "1/um", -5.0, 5.0, 0.05, -1.0, 1.0, "curvature of the cortex (convex: positive)"},
                           LawVariable{"occupancy", "", 0.0, 1.0, 0.5, 0.0, 1.0, "share of receptors that attractant occupies"},
                           LawVariable{"ligand", "", 0.0, 100.0, 1.0, 0.0, 2.0, "ligand on the solid"},
                           LawVariable{"alignment", "", -1.0, 1.0, 0.0, -1.0, 1.0, "alignment with the fibres (1: along, -1: across)"}};
constexpr std::array turn{LawVariable{"angle", "rad", 0.0, half_turn, 0.5, 0.0, half_turn, "angle between the two"}};
constexpr std::array matrix{LawVariable{"f", "", 0.0, 1.0, 1.0, 0.0, 1.0, "intact fraction of the matrix"},
                            LawVariable{"p", "Pa", -1e4, 1e4, 100.0, -100.0, 500.0, "pressure"}};

constexpr std::array rows_of_cells{
    Row{"cells.x", start_x, "um", closed(-2000, 2000), "", chosen, "x of a cell's centre at the start"},
    Row{"cells.y", start_y, "um", closed(-2000, 2000), "", chosen, "y of a cell's centre at the start"},
};

constexpr Row row_of_change{"changes.at", time_of_change, "h", above(0, 8760), "", chosen,
                            "Time from which on the parameters below it hold; a multiple of run.time_step before run.duration"};

constexpr std::array rows{
    Row{"run.duration", [](Parameters& p) -> double& { return p.run.duration; }, "h", above(0, 8760),
        "", methods, "Simulated time"},
    Row{"run.time_step", [](Parameters& p) -> double& { return p.run.time_step; }, "s", above(0, 60),
        "dt", table_1, "Step of the reference integrator, or longest step of the adaptive one; if left out: 0.4 s or 5 s"},
    Row{"run.integrator", choice([](Parameters& p) -> Integrator& { return p.run.integrator; }, integrators), "", none,
        "", "MODEL.md, I29", "reference: all steps are time_step; adaptive: steps of at most time_step, halved when a particle would move too far"},
    Row{"run.seed", [](Parameters& p) -> std::uint64_t& { return p.run.seed; }, "1", closed(0, max_seeds),
        "", chosen, "Seed of the random numbers: the same seed gives the same bits"},
    Row{"run.threads", [](Parameters& p) -> int& { return p.run.threads; }, "1", closed(0, 1024),
        "", chosen, "Number of threads; 0: as many as pay for this many particles, on idle cores; results do not depend on it"},

    Row{"ecm.youngs_modulus", [](Parameters& p) -> double& { return p.ecm.youngs_modulus; }, "Pa", above(0, 1e7),
        "E", table_1, "Young's modulus of the intact matrix"},
    Row{"ecm.poissons_ratio", [](Parameters& p) -> double& { return p.ecm.poissons_ratio; }, "1", open(0, 0.5),
        "nu", table_1, "Poisson's ratio of the intact matrix"},
    Row{"ecm.viscosity", [](Parameters& p) -> double& { return p.ecm.viscosity; }, "Pa s", above(0, 1e9),
        "mu", table_1, "Viscosity of the matrix, intact or degraded"},
    Row{"ecm.radius", [](Parameters& p) -> double& { return p.ecm.radius; }, "um", closed(10, 2000),
        "", table_1, "Radius of the disc of matrix, clamped at its rim"},
    Row{"ecm.cell_hole", [](Parameters& p) -> bool& { return p.ecm.cell_hole; }, "", none,
        "", "MODEL.md, I6", "Whether the matrix under the cell, and within reach of its degradation, is fluid at the start"},
    Row{"ecm.particle_spacing", [](Parameters& p) -> double& { return p.ecm.particle_spacing; }, "um", closed(0.1, 50),
        "d_p", table_1, "Distance of neighbouring matrix particles", numerical},
    Row{"ecm.smoothing_length", [](Parameters& p) -> double& { return p.ecm.smoothing_length; }, "um", closed(0.1, 150),
        "h", table_1, "Smoothing length of the kernel; its support has twice this radius", numerical},
    Row{"ecm.lattice", choice([](Parameters& p) -> Lattice& { return p.ecm.lattice; }, lattices), "", none,
        "", "MODEL.md, I2", "Arrangement of the matrix particles at the start", numerical},
    Row{"ecm.thickness", [](Parameters& p) -> double& { return p.ecm.thickness; }, "um", above(0, 1000),
        "t_z", "MODEL.md, I1", "Thickness of the plane model; matrix forces per depth are multiplied by it",
        numerical},
    Row{"ecm.hourglass_weight", [](Parameters& p) -> double& { return p.ecm.hourglass_weight; }, "1", closed(0, 10),
        "a_hg", "MODEL.md, I5", "Weight of the penalty against zero-energy modes of the particles", numerical},
    Row{"ecm.support_floor", [](Parameters& p) -> double& { return p.ecm.support_floor; }, "1", above(0, 1),
        "", "MODEL.md, I4", "Lower bound of the eigenvalues of the support tensor; smaller ones are raised to it before inversion", numerical},
    Row{"ecm.orphan_support", [](Parameters& p) -> double& { return p.ecm.orphan_support; }, "1", below(0, 1),
        "", "MODEL.md, I7", "Fraction of its intact support below which a solid particle becomes fluid", numerical},
    Row{"ecm.density_min", [](Parameters& p) -> double& { return p.ecm.density_min; }, "1", open(0, 1),
        "", "MODEL.md, I7", "Density over its initial value at which a stretched particle tears and becomes fluid", numerical},
    Row{"ecm.density_max", [](Parameters& p) -> double& { return p.ecm.density_max; }, "1", above(1, 10),
        "", "MODEL.md, I7", "Density over its initial value at which a compressed particle is crushed and becomes fluid", numerical},
    Row{"ecm.verlet_skin", [](Parameters& p) -> double& { return p.ecm.verlet_skin; }, "um", above(0, 50),
        "", chosen, "Skin of the neighbour list beyond the support of the kernel; results do not depend on it", numerical},
    Row{"ecm.drag_lag", [](Parameters& p) -> double& { return p.ecm.drag_lag; }, "um", closed(0, 0.1),
        "", "MODEL.md, I30", "Displacement of a particle after which the drag coefficients of its tile are recomputed; scaled with the step by the adaptive integrator", numerical},

    Row{"ecm.fields.youngs_modulus", [](Parameters& p) -> std::string& { return p.ecm.fields.youngs_modulus; }, "Pa", above(0, 1e7),
        "", "MODEL.md, I32", "Young's modulus of the intact matrix as a function of position; replaces ecm.youngs_modulus", optional, ""},
    Row{"ecm.fields.f_degr", [](Parameters& p) -> std::string& { return p.ecm.fields.f_degr; }, "1", closed(0, 1),
        "", "MODEL.md, I32", "Intact fraction of the matrix at the start: 1 solid, 0 fluid (channels, holes, tracks)", optional, ""},
    Row{"ecm.fields.ligand", [](Parameters& p) -> std::string& { return p.ecm.fields.ligand; }, "1", closed(0, 100),
        "", "MODEL.md, I35", "Ligand on the solid, relative to the usual amount; adhesions need it: at 0 nothing adheres", optional, ""},
    Row{"ecm.fields.attractant", [](Parameters& p) -> std::string& { return p.ecm.fields.attractant; }, "1", closed(0, 1e6),
        "", "MODEL.md, I34", "Concentration of chemoattractant in an arbitrary unit; with cues.diffusion the initial and the boundary values", optional, ""},
    Row{"ecm.fields.attractant_source", [](Parameters& p) -> std::string& { return p.ecm.fields.attractant_source; }, "1/s", closed(0, 1e6),
        "", "MODEL.md, I34", "Rate of release of chemoattractant, in concentration per second", optional, ""},
    Row{"ecm.fields.obstacle", [](Parameters& p) -> std::string& { return p.ecm.fields.obstacle; }, "1", closed(0, 1),
        "", "MODEL.md, I33", "Rigid obstacles (pillars, walls) where the field is 0.5 or more; they neither move nor degrade", optional, ""},

    Row{"fibres.arrangement", choice([](Parameters& p) -> FibreArrangement& { return p.fibres.arrangement; }, fibre_arrangements), "", none,
        "", methods, "Which neighbouring matrix particles are joined by fibres: none, all, or only those along one direction"},
    Row{"fibres.direction_deg", [](Parameters& p) -> double& { return p.fibres.direction_deg; }, "deg", closed(-180, 180),
        "", methods, "Direction of uniaxial fibres, in degrees from the x axis"},
    Row{"fibres.half_angle_deg", [](Parameters& p) -> double& { return p.fibres.half_angle_deg; }, "deg", above(0, 90),
        "", methods, "Largest angle between a uniaxial fibre and the direction, in degrees"},
    Row{"fibres.stiffness", [](Parameters& p) -> double& { return p.fibres.stiffness; }, "Pa", closed(0, 1e7),
        "k_0", table_1, "Stiffness of the fibres below the onset of stiffening"},
    Row{"fibres.onset", [](Parameters& p) -> double& { return p.fibres.onset; }, "1", closed(0, 10),
        "eps_s", table_1, "Strain at which a fibre begins to stiffen"},
    Row{"fibres.stiffening_strain", [](Parameters& p) -> double& { return p.fibres.stiffening_strain; }, "1", closed(0.005, 100),
        "d_s", table_1, "Further strain over which the stiffness of a fibre grows by the factor e"},

    Row{"fibres.field.direction_deg", [](Parameters& p) -> std::string& { return p.fibres.field.direction_deg; }, "deg", closed(-360, 360),
        "", "MODEL.md, I32", "Direction of uniaxial fibres as a function of position; replaces fibres.direction_deg", optional, ""},
    Row{"fibres.field.stiffness", [](Parameters& p) -> std::string& { return p.fibres.field.stiffness; }, "Pa", closed(0, 1e7),
        "", "MODEL.md, I32", "Stiffness of the fibres as a function of position; replaces fibres.stiffness", optional, ""},

    Row{"cell.radius", [](Parameters& p) -> double& { return p.cell.radius; }, "um", above(0, 500),
        "R", table_1, "Radius of the cell at the start"},
    Row{"cell.start_x", [](Parameters& p) -> double& { return p.cell.start_x; }, "um", closed(-2000, 2000),
        "", chosen, "x of the cell's centre at the start"},
    Row{"cell.start_y", [](Parameters& p) -> double& { return p.cell.start_y; }, "um", closed(-2000, 2000),
        "", chosen, "y of the cell's centre at the start"},
    Row{"cell.spring_stiffness", [](Parameters& p) -> double& { return p.cell.spring_stiffness; }, "N/m", closed(0, 1),
        "k_s", table_1, "Stiffness of the springs of the cortex"},
    Row{"cell.dashpot", [](Parameters& p) -> double& { return p.cell.dashpot; }, "N s/m", closed(0, 1),
        "eta_c", table_1, "Viscosity of the dashpots of the cortex"},
    Row{"cell.bending_stiffness", [](Parameters& p) -> double& { return p.cell.bending_stiffness; }, "N m", closed(0, 1e-12),
        "k_bend", "MODEL.md, I11", "Bending stiffness of the cortex"},
    Row{"cell.area_stiffness", [](Parameters& p) -> double& { return p.cell.area_stiffness; }, "N/m^2", closed(0, 1000),
        "k_A", table_1, "Stiffness of the cell against areas below the initial one"},
    Row{"cell.liquid_drag", [](Parameters& p) -> double& { return p.cell.liquid_drag; }, "Pa s", above(0, 1e6),
        "gamma_liquid", table_1, "Drag of a particle of the cortex in the liquid, per depth"},
    Row{"cell.repulsion_stiffness", [](Parameters& p) -> double& { return p.cell.repulsion_stiffness; }, "N/m^1.5", closed(0, 1000),
        "k_rep", table_1, "Stiffness of the self-repulsion of the cortex"},
    Row{"cell.repulsion_distance", [](Parameters& p) -> double& { return p.cell.repulsion_distance; }, "um", above(0, 10),
        "d_rep", table_1, "Range of the self-repulsion of the cortex"},
    Row{"cell.crowding", [](Parameters& p) -> double& { return p.cell.crowding; }, "1", open(0, 1),
        "", "MODEL.md, I10", "Fraction of its initial length below which a segment stiffens in compression", numerical},
    Row{"cell.particles", [](Parameters& p) -> int& { return p.cell.particles; }, "1", closed(20, 10000),
        "", table_1, "Number of particles of the cortex", numerical},

    Row{"contact.range", [](Parameters& p) -> double& { return p.contact.range; }, "um", above(0, 20),
        "d_c", "MODEL.md, I13", "Range of the elastic contact with solid matrix"},
    Row{"contact.fluid_share", [](Parameters& p) -> double& { return p.contact.fluid_share; }, "1", closed(0, 1),
        "", "MODEL.md, I12", "Viscous coupling of growing and maturing protrusions to fluid outside the cell, relative to their coupling to solid"},
    Row{"contact.body_fluid_share", [](Parameters& p) -> double& { return p.contact.body_fluid_share; }, "1", closed(0, 1),
        "", "MODEL.md, I12", "The same of the rest of the cortex", usual, "contact.fluid_share"},
    Row{"contact.sample_spacing", [](Parameters& p) -> double& { return p.contact.sample_spacing; }, "um", closed(0.02, 20),
        "", "MODEL.md, I12", "Largest distance between points of viscous coupling on a segment", numerical},
    Row{"contact.deepest_solid", [](Parameters& p) -> double& { return p.contact.deepest_solid; }, "um", above(0, 20),
        "", "MODEL.md, I13", "Depth inside the cell beyond which a solid particle becomes fluid at once", numerical},

    Row{"contact.cells.repulsion", [](Parameters& p) -> double& { return p.contact.cells.repulsion; }, "Pa", above(0, 1e7),
        "", "MODEL.md, I38", "Repulsive pressure between two cells at zero gap", optional, {}, has_several},
    Row{"contact.cells.repulsion_range", [](Parameters& p) -> double& { return p.contact.cells.repulsion_range; }, "um", above(0, 20),
        "", "MODEL.md, I38", "Gap below which two cells repel each other", optional, {}, has_several},
    Row{"contact.cells.adhesion", [](Parameters& p) -> double& { return p.contact.cells.adhesion; }, "Pa", closed(0, 1e6),
        "", "MODEL.md, I39", "Largest adhesive stress between two cells; 0: cells do not adhere to each other", optional, {}, has_several},
    Row{"contact.cells.adhesion_range", [](Parameters& p) -> double& { return p.contact.cells.adhesion_range; }, "um", above(0, 20),
        "", "MODEL.md, I39", "Two cells attract each other at gaps of up to this much beyond contact.cells.repulsion_range", optional, {}, has_several},

    Row{"nucleus.radius", [](Parameters& p) -> double& { return p.nucleus.radius; }, "um", closed(0, 500),
        "R_n", "MODEL.md, I40", "Radius of the nucleus at the start; 0: no nucleus", optional, "0 um"},
    Row{"nucleus.shear_modulus", [](Parameters& p) -> double& { return p.nucleus.shear_modulus; }, "Pa", closed(0, 1e7),
        "", "MODEL.md, I40", "Shear modulus of the chromatin, which resists a change of shape", optional, {}, has_nucleus},
    Row{"nucleus.stretch_stiffness", [](Parameters& p) -> double& { return p.nucleus.stretch_stiffness; }, "nN", above(0, 1000),
        "", "MODEL.md, I40", "Stretch stiffness of the lamina: tension per strain", optional, {}, has_nucleus},
    Row{"nucleus.bending_stiffness", [](Parameters& p) -> double& { return p.nucleus.bending_stiffness; }, "nN um^2", closed(0, 1000),
        "", "MODEL.md, I40", "Bending stiffness of the lamina", optional, {}, has_nucleus},
    Row{"nucleus.bulk_modulus", [](Parameters& p) -> double& { return p.nucleus.bulk_modulus; }, "Pa", closed(0, 1e7),
        "", "MODEL.md, I40", "Bulk modulus of the nucleus: pressure per relative loss of area", optional, {}, has_nucleus},
    Row{"nucleus.retardation_time", [](Parameters& p) -> double& { return p.nucleus.retardation_time; }, "s", closed(0, 1e6),
        "", "MODEL.md, I40", "Kelvin-Voigt retardation time of lamina and chromatin", optional, {}, has_nucleus},
    Row{"nucleus.centring_stiffness", [](Parameters& p) -> double& { return p.nucleus.centring_stiffness; }, "N/m", closed(0, 1),
        "", "MODEL.md, I40", "Stiffness of the filaments that hold the nucleus in the middle of the cell", optional, {}, has_nucleus},
    Row{"nucleus.drag", [](Parameters& p) -> double& { return p.nucleus.drag; }, "N s/m", closed(0, 1000),
        "", "MODEL.md, I40", "Drag coefficient of the nucleus relative to the cytoplasm; the cytoplasm moves with the cortex", optional, {}, has_nucleus},
    Row{"nucleus.repulsion", [](Parameters& p) -> double& { return p.nucleus.repulsion; }, "Pa", above(0, 1e7),
        "", "MODEL.md, I40", "Repulsive pressure between nucleus and cortex at zero gap", optional, {}, has_nucleus},
    Row{"nucleus.repulsion_range", [](Parameters& p) -> double& { return p.nucleus.repulsion_range; }, "um", above(0, 20),
        "", "MODEL.md, I40", "Gap below which nucleus and cortex repel each other", optional, {}, has_nucleus},
    Row{"nucleus.particles", [](Parameters& p) -> int& { return p.nucleus.particles; }, "1", closed(12, 2000),
        "", "MODEL.md, I40", "Number of particles of the lamina", numerical, {}, has_nucleus},

    Row{"actomyosin.force", [](Parameters& p) -> double& { return p.actomyosin.force; }, "nN", closed(0, 1000),
        "F_am", table_1, "Actomyosin force of one strand at full maturation; a protrusion has two"},
    Row{"actomyosin.f_mat_body", [](Parameters& p) -> double& { return p.actomyosin.f_mat_body; }, "1", closed(0, 1),
        "f_mat", methods, "Maturation of the body of the cell"},
    Row{"actomyosin.curvature_optimum", [](Parameters& p) -> double& { return p.actomyosin.curvature_optimum; }, "1/um", closed(-100, 100),
        "kappa_0", table_1, "Curvature at which a segment contracts most, convex positive"},
    Row{"actomyosin.curvature_width", [](Parameters& p) -> double& { return p.actomyosin.curvature_width; }, "1/um", above(0, 100),
        "kappa_w", table_1, "Width of the curvature factor"},

    Row{"protrusion.initiation_rate", [](Parameters& p) -> double& { return p.protrusion.initiation_rate; }, "1/s", closed(0, 10),
        "r_prot", table_1, "Rate of initiation of protrusions at each particle of the front"},
    Row{"protrusion.force", [](Parameters& p) -> double& { return p.protrusion.force; }, "nN", closed(0, 1000),
        "F_prot", table_1, "Growth force of a protrusion, divided among its pushing particles"},
    Row{"protrusion.growth_time", [](Parameters& p) -> double& { return p.protrusion.growth_time; }, "s", above(0, 1e6),
        "T_prot", table_1, "Duration of growth"},
    Row{"protrusion.finishing_time", [](Parameters& p) -> double& { return p.protrusion.finishing_time; }, "s", closed(0, 1e6),
        "T_finish", table_1, "Duration of contraction after the adhesion is lost"},
    Row{"protrusion.spring_stiffness", [](Parameters& p) -> double& { return p.protrusion.spring_stiffness; }, "N/m", closed(0, 1),
        "k_s,prot", table_1, "Stiffness of the springs of a growing or maturing protrusion"},
    Row{"protrusion.deflection_rate", [](Parameters& p) -> double& { return p.protrusion.deflection_rate; }, "1/s", closed(0, 10),
        "r_defl", table_1, "Rate at which growth turns towards degraded matrix"},
    Row{"protrusion.number", [](Parameters& p) -> int& { return p.protrusion.number; }, "1", closed(0, 100),
        "n_prot", methods, "Target number of simultaneous protrusions; 0: stochastic initiation at initiation_rate"},
    Row{"protrusion.candidate_interval", [](Parameters& p) -> double& { return p.protrusion.candidate_interval; }, "s", closed(0.01, 1e4),
        "", methods, "With a target number: one candidate is drawn in each interval, whatever the time step"},
    Row{"protrusion.rear_share", [](Parameters& p) -> double& { return p.protrusion.rear_share; }, "1", closed(0, 1),
        "", methods, "With a target number: probability of a rear particle, relative to a front particle"},
    Row{"protrusion.area_limit", [](Parameters& p) -> double& { return p.protrusion.area_limit; }, "1", above(1, 100),
        "", methods, "With a target number: no protrusion is initiated in a cell of more than this many times A_0"},
    Row{"protrusion.least_facing", [](Parameters& p) -> double& { return p.protrusion.least_facing; }, "1", closed(0, 1),
        "", "MODEL.md, I16", "A protrusion is initiated only where its tip would feel at least this fraction of the growth force", numerical},
    Row{"protrusion.half_width", [](Parameters& p) -> int& { return p.protrusion.half_width; }, "1", closed(2, 5000),
        "w_prot", table_1, "Number of particles of a protrusion on each side of its centre", numerical},
    Row{"protrusion.tip_half_width", [](Parameters& p) -> int& { return p.protrusion.tip_half_width; }, "1", closed(0, 5000),
        "w_f", table_1, "Number of pushing particles on each side of the centre", numerical},
    Row{"protrusion.deflection_cone", [](Parameters& p) -> double& { return p.protrusion.deflection_cone; }, "rad", above(0, 3.1415926536),
        "", "MODEL.md, I17", "Half angle of the cone ahead of the tip in which degraded matrix deflects growth; a bare number is in radians", numerical},
    Row{"protrusion.spreading_rate", [](Parameters& p) -> double& { return p.protrusion.spreading_rate; }, "1/s", closed(0, 10),
        "", "MODEL.md, I16", "Rate at which the particles of a growing protrusion slide towards equal spacing", numerical},

    Row{"adhesion.stiffness", [](Parameters& p) -> double& { return p.adhesion.stiffness; }, "N/m", above(0, 1),
        "k_ad", table_1, "Stiffness of the adhesion spring"},
    Row{"adhesion.rest_length", [](Parameters& p) -> double& { return p.adhesion.rest_length; }, "um", closed(0, 100),
        "l_0,adh", table_1, "Rest length of the adhesion spring"},
    Row{"adhesion.maturation_time", [](Parameters& p) -> double& { return p.adhesion.maturation_time; }, "s", above(0, 1e6),
        "T_mat", table_1, "Duration of maturation"},
    Row{"adhesion.r_off_min", [](Parameters& p) -> double& { return p.adhesion.r_off_min; }, "1/s", closed(0, 10),
        "r_off,min", table_1, "Rate of disassembly at high force"},
    Row{"adhesion.r_off_0", [](Parameters& p) -> double& { return p.adhesion.r_off_0; }, "1/s", closed(0, 10),
        "r_off,0", table_1, "Additional rate of disassembly at zero force"},
    Row{"adhesion.zeta_diss", [](Parameters& p) -> double& { return p.adhesion.zeta_diss; }, "1/nN", closed(0, 1e6),
        "zeta_diss", table_1, "Sensitivity of disassembly to force"},
    Row{"adhesion.rupture", [](Parameters& p) -> bool& { return p.adhesion.rupture; }, "", none,
        "", methods, "Whether adhesions rupture at rupture_ratio; off in the paper without fibres"},
    Row{"adhesion.rupture_ratio", [](Parameters& p) -> double& { return p.adhesion.rupture_ratio; }, "1", above(0, 1e6),
        "f_rupt", table_1, "Force at which an adhesion ruptures, relative to 2 f_mat F_am (both strands)"},
    Row{"adhesion.step_threshold", [](Parameters& p) -> double& { return p.adhesion.step_threshold; }, "1", above(0, 1),
        "s_mat", methods, "Fraction of the force of a maturation step that completes the step", numerical},
    Row{"adhesion.rest_speed", [](Parameters& p) -> double& { return p.adhesion.rest_speed; }, "nm/s", closed(0, 1000),
        "", "MODEL.md, I19", "Maturation steps count once the tip recoils more slowly than this towards its base; 0: at any speed", numerical, "0 nm/s"},
    Row{"adhesion.handover_time", [](Parameters& p) -> double& { return p.adhesion.handover_time; }, "s", above(0, 1e4),
        "", "MODEL.md, I20", "Time constant with which the pull of maturation relaxes", numerical, "0.4 s"},
    Row{"adhesion.handover_share", [](Parameters& p) -> double& { return p.adhesion.handover_share; }, "1", closed(0, 1),
        "", "MODEL.md, I20", "The pull of maturation relaxes while the adhesion carries more than this fraction of f_mat F_am (one strand)", numerical, "0.9"},
    Row{"adhesion.base_drag", [](Parameters& p) -> double& { return p.adhesion.base_drag; }, "N s/m", closed(0, 1000),
        "", "MODEL.md, I19", "Drag of each pinned particle of the base while a protrusion matures", numerical},
    Row{"adhesion.pinned_particles", [](Parameters& p) -> int& { return p.adhesion.pinned_particles; }, "1", closed(1, 500),
        "", "MODEL.md, I19", "Number of pinned particles at either end of a maturing protrusion", numerical, "3"},
    Row{"adhesion.maturation_strands", [](Parameters& p) -> double& { return p.adhesion.maturation_strands; }, "1", closed(1, 2),
        "m_mat", "MODEL.md, I28", "F_mat is f_mat times this number times F_am (1: one strand, 2: both)", numerical, "1"},
    Row{"adhesion.spread", [](Parameters& p) -> double& { return p.adhesion.spread; }, "1", closed(0.8, 4),
        "", "MODEL.md, I18", "Smoothing length of the kernel that spreads an adhesion over the matrix, relative to ecm.smoothing_length", numerical, "1"},
    Row{"adhesion.least_support", [](Parameters& p) -> double& { return p.adhesion.least_support; }, "1", open(0, 1),
        "", "MODEL.md, I18", "Fraction of solid around the anchor below which the adhesion is lost", numerical},

    Row{"polarization.rate", [](Parameters& p) -> double& { return p.polarization.rate; }, "1/s", closed(0, 10),
        "r_pol", table_1, "Rate at which the polarization turns towards mature adhesions"},

    Row{"degradation.tip_rate", [](Parameters& p) -> double& { return p.degradation.tip_rate; }, "1/s", closed(0, 100),
        "r_degr,tip", table_1, "Rate of degradation at the tip of a growing protrusion"},
    Row{"degradation.tip_distance", [](Parameters& p) -> double& { return p.degradation.tip_distance; }, "um", closed(0, 100),
        "d_degr,tip", table_1, "Reach of degradation around the pushing particles"},
    Row{"degradation.protrusion_rate", [](Parameters& p) -> double& { return p.degradation.protrusion_rate; }, "1/s", closed(0, 100),
        "r_degr,prot", table_1, "Rate of degradation along a protrusion"},
    Row{"degradation.protrusion_distance", [](Parameters& p) -> double& { return p.degradation.protrusion_distance; }, "um", closed(0, 100),
        "d_degr,prot", table_1, "Reach of degradation around a protrusion"},
    Row{"degradation.body_rate", [](Parameters& p) -> double& { return p.degradation.body_rate; }, "1/s", closed(0, 100),
        "r_degr,body", table_1, "Rate of degradation around the body of the cell"},
    Row{"degradation.body_distance", [](Parameters& p) -> double& { return p.degradation.body_distance; },
        "um", closed(0, 100),
        "d_degr,cell", table_1, "Reach of degradation around the body of the cell"},
    Row{"degradation.threshold", [](Parameters& p) -> double& { return p.degradation.threshold; }, "Pa", closed(0, 1e6),
        "p_th,degr", table_1, "Pressure above which protrusion and body degrade the matrix"},
    Row{"degradation.body_rear_share", [](Parameters& p) -> double& { return p.degradation.rear_share; }, "1", closed(0, 1),
        "", "MODEL.md, I15", "Rate of degradation around the rear half of the body, relative to body_rate", numerical, "1"},
    Row{"degradation.smaller_share", [](Parameters& p) -> double& { return p.degradation.smaller_share; }, "1", closed(0, 1),
        "", "MODEL.md, I15", "Part of the smaller of solid and contact pressure that is added to the larger before it is compared with the threshold; 1: their sum, 0: the larger alone", numerical, "1"},

    Row{"cues.half_occupancy", [](Parameters& p) -> double& { return p.cues.half_occupancy; }, "1", above(0, 1e9),
        "K_d", "MODEL.md, I34", "Concentration at which half of the receptors are occupied, in the unit of ecm.fields.attractant", usual, "1"},
    Row{"cues.diffusion", [](Parameters& p) -> double& { return p.cues.diffusion; }, "um^2/s", closed(0, 1e6),
        "D", "MODEL.md, I34", "Diffusion coefficient of the attractant; 0: a steady field", usual, "0 um^2/s"},
    Row{"cues.decay", [](Parameters& p) -> double& { return p.cues.decay; }, "1/s", closed(0, 1e3),
        "", "MODEL.md, I34", "Rate at which a diffusing attractant decays", usual, "0 1/s"},
    Row{"cues.uptake", [](Parameters& p) -> double& { return p.cues.uptake; }, "1/s", closed(0, 1e3),
        "", "MODEL.md, I34", "Rate at which cells take up a diffusing attractant beneath them", usual, "0 1/s"},

    law("laws.fibre_stiffness", [](Parameters& p) -> std::string& { return p.laws.fibre_stiffness; }, "1", closed(0, 1e100), paper,
        "Eq. 5: stiffness of a fibre over k_0", strain, {},
        "eps < 0 ? 0 : eps <= eps_s ? 1 : exp((eps - eps_s)/d_s)"),
    law("laws.curvature_factor", [](Parameters& p) -> std::string& { return p.laws.curvature_factor; }, "1", closed(0, 1), "MODEL.md, I14",
        "Eq. 6: factor of the actomyosin tension", segment, all_shared,
        "exp(-0.5*((kappa - kappa_0)/kappa_w)^2)"),
    law("laws.contraction", [](Parameters& p) -> std::string& { return p.laws.contraction; }, "nN", closed(0, 1000), paper,
        "Eq. 6: tension of a segment of the cortex", strand, all_shared,
        "f_mat*f_curv*F_am"),
    law("laws.maturation_force", [](Parameters& p) -> std::string& { return p.laws.maturation_force; }, "nN", closed(0, 1000), methods,
        "Force of the adhesion at which the next step of maturation is done", maturing, all_shared,
        "0.1*sum(steps, s_mat)*(m_mat*F_am)"),
    law("laws.maturation", [](Parameters& p) -> std::string& { return p.laws.maturation; }, "1", closed(0, 1), methods,
        "f_mat after so many steps of maturation", matured, without_f_mat,
        "min(1, 0.1*steps)"),
    law("laws.adhesion_stiffness", [](Parameters& p) -> std::string& { return p.laws.adhesion_stiffness; }, "nN/um", closed(0, 1e6), methods,
        "Stiffness of an adhesion: its force over its stretch", spring, all_shared,
        "k_ad"),
    law("laws.disassembly_rate", [](Parameters& p) -> std::string& { return p.laws.disassembly_rate; }, "1/s", closed(0, 1e6), paper,
        "Eq. 7: rate at which an adhesion disassembles", adhesion, all_shared,
        "r_off_min + r_off_0*exp(-zeta_diss*F/f_mat)"),
    law("laws.growth_force", [](Parameters& p) -> std::string& { return p.laws.growth_force; }, "1", closed(0, 100), paper,
        "Eq. 10: force of growth over F_prot", growth, all_shared,
        "n_prot > 0 && A > 1 ? 1/A : 1"),
    law("laws.initiation_rate", [](Parameters& p) -> std::string& { return p.laws.initiation_rate; }, "1/s", closed(0, 1e6), methods,
        "Rate of initiation at a particle of the front", place, of_no_protrusion,
        "r_prot"),
    law("laws.initiation_bias", [](Parameters& p) -> std::string& { return p.laws.initiation_bias; }, "1", closed(0, 1e300), methods,
        "Where along the cortex protrusions begin: the rate is multiplied by bias / mean bias, so the total rate of the cell stays the same. A bias of 0 along the whole cortex is none", place, of_no_protrusion,
        "1"),
    law("laws.polarization_rate", [](Parameters& p) -> std::string& { return p.laws.polarization_rate; }, "1/s", closed(0, 1e6), methods,
        "Rate at which the polarization turns to the mean direction of the adhesions", turn, of_no_protrusion,
        "r_pol"),
    law("laws.degradation_tip", [](Parameters& p) -> std::string& { return p.laws.degradation_tip; }, "1/s", closed(0, 1e6), methods,
        "Rate of degradation at the tip of a growing protrusion", matrix, all_shared,
        "r_degr_tip"),
    law("laws.degradation_protrusion", [](Parameters& p) -> std::string& { return p.laws.degradation_protrusion; }, "1/s", closed(0, 1e6), methods,
        "Rate of degradation along a protrusion", matrix, all_shared,
        "p > p_th_degr ? r_degr_prot : 0"),
    law("laws.degradation_body", [](Parameters& p) -> std::string& { return p.laws.degradation_body; }, "1/s", closed(0, 1e6), methods,
        "Rate of degradation around the body of the cell; around its rear times body_rear_share", matrix, of_no_protrusion,
        "p > p_th_degr ? r_degr_body : 0"),
    Row{"laws.constants", [](Parameters& p) -> std::vector<LawConstant>& { return p.laws.constants; }, "", {},
        "", chosen, "Constants of your own for these formulas, each of them a parameter: a table, or one text", optional, ""},

    Row{"output.track_interval", [](Parameters& p) -> double& { return p.output.track_interval; }, "s", above(0, 1e9),
        "", chosen, "Time between rows of tracks.csv and health.csv"},
    Row{"output.checkpoint_interval", [](Parameters& p) -> double& { return p.output.checkpoint_interval; }, "s", closed(0, 1e9),
        "", chosen, "Time between checkpoints to resume from; 0: only at the end and at signals"},
    Row{"output.kept_checkpoint_interval", [](Parameters& p) -> double& { return p.output.kept_checkpoint_interval; }, "s", closed(0, 1e9),
        "", chosen, "Time between checkpoints that are kept to branch from; 0: none"},
    Row{"output.field_interval", [](Parameters& p) -> double& { return p.output.field_interval; }, "s", closed(0, 1e9),
        "", chosen, "Time between frames of cell and matrix in fields.h5 and in the report's player; 0: none"},
    Row{"output.report", [](Parameters& p) -> bool& { return p.output.report; }, "", none,
        "", chosen, "Whether report.html is written"},

    Row{"solver.method", choice([](Parameters& p) -> SolverMethod& { return p.solver.method; }, solver_methods), "", none,
        "", chosen, "Conjugate gradients, preconditioned by a multigrid cycle or by the diagonal", numerical},
    Row{"solver.tolerance", [](Parameters& p) -> double& { return p.solver.tolerance; }, "1", above(0, 0.1),
        "", chosen, "Relative residual at which the drag system counts as solved; 100 times larger with multigrid and the adaptive integrator", numerical},
    Row{"solver.max_iterations", [](Parameters& p) -> int& { return p.solver.max_iterations; }, "1", closed(1, 1000000),
        "", chosen, "Iterations after which the solver gives up", numerical},
};
// clang-format on

} // namespace

std::span<const Row> schema() { return rows; }

std::span<const Row> law_rows() {
  const auto first = std::ranges::find(rows, "laws", section_of);
  return {first, std::ranges::find(rows, "laws.constants", &Row::path)};
}

std::span<const Row> cell_rows() { return rows_of_cells; }

const Row& change_time() { return row_of_change; }

std::span<const Section> sections() { return all_sections; }

std::span<const LawVariable> shared_arguments() { return of_the_place; }

} // namespace matrigrate
