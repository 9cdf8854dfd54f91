#include "parameters/schema.hpp"

#include <array>

namespace matrigrate {

namespace {

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
// clang-format on

} // namespace

std::span<const Section> sections() { return all_sections; }

} // namespace matrigrate
