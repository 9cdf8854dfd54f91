#include "parameters/schema.hpp"

#include <array>

namespace matrigrate {

namespace {

constexpr std::string_view by_us = "this program";
constexpr std::string_view d40 = "MODEL.md, I40";
constexpr auto aside = Audience::optional;

bool has_several(const Parameters& p) { return !p.cells.empty(); }
bool has_nucleus(const Parameters& p) { return p.nucleus.radius != 0.0; }

constexpr Range from(double low, double high) { return {low, high, true, true}; }
constexpr Range beyond(double low, double high) { return {low, high, false, true}; } ///< (low, high]

double& start_x(Parameters& p) { return (p.cells.empty() ? p.cells.emplace_back() : p.cells.back()).x; }
double& start_y(Parameters& p) { return (p.cells.empty() ? p.cells.emplace_back() : p.cells.back()).y; }

double& time_of_change(Parameters& p) { return (p.changes.empty() ? p.changes.emplace_back() : p.changes.back()).at; }

// clang-format off
constexpr std::array rows_of_cells{
    Row{"cells.x", start_x, "um", from(-2000, 2000), "", by_us, "x of a cell's centre at the start"},
    Row{"cells.y", start_y, "um", from(-2000, 2000), "", by_us, "y of a cell's centre at the start"},
};

constexpr Row row_of_change{"changes.at", time_of_change, "h", beyond(0, 8760), "", by_us,
                            "Time from which on the parameters below it hold; a multiple of run.time_step before run.duration"};

constexpr std::array rows_of_parts{
    Row{"contact.cells.repulsion", [](Parameters& p) -> double& { return p.contact.cells.repulsion; }, "Pa", beyond(0, 1e7),
        "", "MODEL.md, I38", "Repulsive pressure between two cells at zero gap", aside, {}, has_several},
    Row{"contact.cells.repulsion_range", [](Parameters& p) -> double& { return p.contact.cells.repulsion_range; }, "um", beyond(0, 20),
        "", "MODEL.md, I38", "Gap below which two cells repel each other", aside, {}, has_several},
    Row{"contact.cells.adhesion", [](Parameters& p) -> double& { return p.contact.cells.adhesion; }, "Pa", from(0, 1e6),
        "", "MODEL.md, I39", "Largest adhesive stress between two cells; 0: cells do not adhere to each other", aside, {}, has_several},
    Row{"contact.cells.adhesion_range", [](Parameters& p) -> double& { return p.contact.cells.adhesion_range; }, "um", beyond(0, 20),
        "", "MODEL.md, I39", "Two cells attract each other at gaps of up to this much beyond contact.cells.repulsion_range", aside, {}, has_several},

    Row{"nucleus.radius", [](Parameters& p) -> double& { return p.nucleus.radius; }, "um", from(0, 500),
        "R_n", d40, "Radius of the nucleus at the start; 0: no nucleus", aside, "0 um"},
    Row{"nucleus.shear_modulus", [](Parameters& p) -> double& { return p.nucleus.shear_modulus; }, "Pa", from(0, 1e7),
        "", d40, "Shear modulus of the chromatin, which resists a change of shape", aside, {}, has_nucleus},
    Row{"nucleus.stretch_stiffness", [](Parameters& p) -> double& { return p.nucleus.stretch_stiffness; }, "nN", beyond(0, 1000),
        "", d40, "Stretch stiffness of the lamina: tension per strain", aside, {}, has_nucleus},
    Row{"nucleus.bending_stiffness", [](Parameters& p) -> double& { return p.nucleus.bending_stiffness; }, "nN um^2", from(0, 1000),
        "", d40, "Bending stiffness of the lamina", aside, {}, has_nucleus},
    Row{"nucleus.bulk_modulus", [](Parameters& p) -> double& { return p.nucleus.bulk_modulus; }, "Pa", from(0, 1e7),
        "", d40, "Bulk modulus of the nucleus: pressure per relative loss of area", aside, {}, has_nucleus},
    Row{"nucleus.retardation_time", [](Parameters& p) -> double& { return p.nucleus.retardation_time; }, "s", from(0, 1e6),
        "", d40, "Kelvin-Voigt retardation time of lamina and chromatin", aside, {}, has_nucleus},
    Row{"nucleus.centring_stiffness", [](Parameters& p) -> double& { return p.nucleus.centring_stiffness; }, "N/m", from(0, 1),
        "", d40, "Stiffness of the filaments that hold the nucleus in the middle of the cell", aside, {}, has_nucleus},
    Row{"nucleus.drag", [](Parameters& p) -> double& { return p.nucleus.drag; }, "N s/m", from(0, 1000),
        "", d40, "Drag coefficient of the nucleus relative to the cytoplasm; the cytoplasm moves with the cortex", aside, {}, has_nucleus},
    Row{"nucleus.repulsion", [](Parameters& p) -> double& { return p.nucleus.repulsion; }, "Pa", beyond(0, 1e7),
        "", d40, "Repulsive pressure between nucleus and cortex at zero gap", aside, {}, has_nucleus},
    Row{"nucleus.repulsion_range", [](Parameters& p) -> double& { return p.nucleus.repulsion_range; }, "um", beyond(0, 20),
        "", d40, "Gap below which nucleus and cortex repel each other", aside, {}, has_nucleus},
    Row{"nucleus.particles", [](Parameters& p) -> int& { return p.nucleus.particles; }, "1", from(12, 2000),
        "", d40, "Number of particles of the lamina", Audience::numerical, {}, has_nucleus},
};
// clang-format on

} // namespace

std::span<const Row> cell_rows() { return rows_of_cells; }

const Row& change_time() { return row_of_change; }

std::span<const Row> part_rows() { return rows_of_parts; }

} // namespace matrigrate
