#include "parameters/schema.hpp"

#include <array>

namespace matrigrate {

namespace {

constexpr std::string_view table_1 = "Heck et al. 2020, Table 1";
constexpr std::string_view methods = "Heck et al. 2020, Methods";
constexpr std::string_view chosen = "this program";

constexpr double most_seeds = 9007199254740991.0; // 2^53 - 1: every tool reads it back exactly
constexpr auto numerical = Audience::numerical;

constexpr Range closed(double low, double high) { return {low, high, true, true}; }
constexpr Range open(double low, double high) { return {low, high, false, false}; }
constexpr Range above(double low, double high) { return {low, high, false, true}; } ///< (low, high]
constexpr Range below(double low, double high) { return {low, high, true, false}; } ///< [low, high)
constexpr Range none{};

/// Access is a captureless lambda that returns the member of the enumeration.
template <class Access>
constexpr Choice choice(Access, std::span<const std::string_view> names) {
  return {names, [](Parameters& p) { return static_cast<std::size_t>(Access{}(p)); },
          [](Parameters& p, std::size_t index) {
            auto& value = Access{}(p);
            value = static_cast<std::remove_reference_t<decltype(value)>>(index);
          }};
}

constexpr std::array<std::string_view, 2> lattices{"square", "hexagonal"};
constexpr std::array<std::string_view, 2> formulations{"total_lagrangian", "updated_lagrangian"};

// clang-format off
constexpr std::array all_sections{
    Section{"run", "The run: how long, in which steps, with which random numbers"},
    Section{"ecm", "The extracellular matrix"},
    Section{"cell", "The cell"},
    Section{"degradation", "Degradation of the matrix by the cell"},
    Section{"solver", "The linear system of every step"},
};

constexpr std::array rows{
    Row{"run.duration", [](Parameters& p) -> double& { return p.run.duration; }, "h", above(0, 8760),
        "", methods, "Simulated time"},
    Row{"run.time_step", [](Parameters& p) -> double& { return p.run.time_step; }, "s", above(0, 60),
        "dt", table_1, "Time step"},
    Row{"run.seed", [](Parameters& p) -> std::uint64_t& { return p.run.seed; }, "1", closed(0, most_seeds),
        "", chosen, "Seed of the random numbers: the same seed gives the same bits"},
    Row{"run.threads", [](Parameters& p) -> int& { return p.run.threads; }, "1", closed(0, 1024),
        "", chosen, "Threads to compute with, 0 for as many as the machine has; never changes a result"},

    Row{"ecm.youngs_modulus", [](Parameters& p) -> double& { return p.ecm.youngs_modulus; }, "Pa", above(0, 1e7),
        "E", table_1, "Young's modulus of the intact matrix"},
    Row{"ecm.poissons_ratio", [](Parameters& p) -> double& { return p.ecm.poissons_ratio; }, "1", open(0, 0.5),
        "nu", table_1, "Poisson's ratio of the intact matrix"},
    Row{"ecm.viscosity", [](Parameters& p) -> double& { return p.ecm.viscosity; }, "Pa s", above(0, 1e9),
        "mu", table_1, "Viscosity of the matrix, intact or degraded"},
    Row{"ecm.radius", [](Parameters& p) -> double& { return p.ecm.radius; }, "um", closed(10, 2000),
        "", table_1, "Radius of the disc of matrix, clamped at its rim"},
    Row{"ecm.cell_hole", [](Parameters& p) -> bool& { return p.ecm.cell_hole; }, "", none,
        "", "MODEL.md, D6", "Whether the disc of the cell and its margin of degradation start as fluid"},
    Row{"ecm.particle_spacing", [](Parameters& p) -> double& { return p.ecm.particle_spacing; }, "um", closed(0.1, 50),
        "d_p", table_1, "Distance of neighbouring matrix particles", numerical},
    Row{"ecm.smoothing_length", [](Parameters& p) -> double& { return p.ecm.smoothing_length; }, "um", closed(0.1, 150),
        "h", table_1, "Smoothing length of the kernel, which reaches twice as far", numerical},
    Row{"ecm.lattice", choice([](Parameters& p) -> Lattice& { return p.ecm.lattice; }, lattices), "", none,
        "", "MODEL.md, D2", "Arrangement of the matrix particles at the start", numerical},
    Row{"ecm.thickness", [](Parameters& p) -> double& { return p.ecm.thickness; }, "um", above(0, 1000),
        "t_z", "MODEL.md, D1", "Thickness of the plane model: a force per depth times it meets the forces of the cell",
        numerical},
    Row{"ecm.formulation", choice([](Parameters& p) -> Formulation& { return p.ecm.formulation; },
        formulations), "", none,
        "", "MODEL.md, D4", "Whether the stress of the solid is summed over reference or over current neighbours", numerical},
    Row{"ecm.hourglass_weight", [](Parameters& p) -> double& { return p.ecm.hourglass_weight; }, "1", closed(0, 10),
        "a_hg", "MODEL.md, D5", "Weight of the penalty against zero-energy modes of the particles", numerical},
    Row{"ecm.support_floor", [](Parameters& p) -> double& { return p.ecm.support_floor; }, "1", above(0, 1),
        "", "MODEL.md, D4", "Smallest eigenvalue of the support tensor that is inverted as it is", numerical},
    Row{"ecm.orphan_support", [](Parameters& p) -> double& { return p.ecm.orphan_support; }, "1", below(0, 1),
        "", "MODEL.md, D7", "A solid particle with less than this share of its intact support becomes fluid", numerical},
    Row{"ecm.density_min", [](Parameters& p) -> double& { return p.ecm.density_min; }, "1", open(0, 1),
        "", "MODEL.md, D7", "Lower bound of the density over its initial value", numerical},
    Row{"ecm.density_max", [](Parameters& p) -> double& { return p.ecm.density_max; }, "1", above(1, 10),
        "", "MODEL.md, D7", "Upper bound of the density over its initial value", numerical},
    Row{"ecm.verlet_skin", [](Parameters& p) -> double& { return p.ecm.verlet_skin; }, "um", above(0, 50),
        "", chosen, "Neighbours are listed up to this distance beyond the support; never changes a result", numerical},

    Row{"cell.radius", [](Parameters& p) -> double& { return p.cell.radius; }, "um", above(0, 500),
        "R", table_1, "Radius of the cell at the start"},

    Row{"degradation.body_distance", [](Parameters& p) -> double& { return p.degradation.body_distance; },
        "um", closed(0, 100),
        "d_degr,cell", table_1, "Reach of degradation around the body of the cell"},

    Row{"solver.tolerance", [](Parameters& p) -> double& { return p.solver.tolerance; }, "1", above(0, 0.1),
        "", chosen, "Relative residual at which the drag system counts as solved", numerical},
    Row{"solver.max_iterations", [](Parameters& p) -> int& { return p.solver.max_iterations; }, "1", closed(1, 1000000),
        "", chosen, "Iterations after which the solver gives up", numerical},
};
// clang-format on

} // namespace

std::span<const Row> schema() { return rows; }

std::span<const Section> sections() { return all_sections; }

} // namespace matrigrate
