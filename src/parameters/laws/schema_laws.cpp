#include "parameters/laws/law.hpp"
#include "parameters/schema.hpp"

#include <array>

namespace matrigrate {

namespace {

constexpr std::string_view paper = "Heck et al. 2020";
constexpr std::string_view of_methods = "Heck et al. 2020, Methods";
constexpr auto rarely = Audience::optional;
constexpr Range rate{0.0, 1e6};
constexpr Range share{0.0, 1.0};
constexpr Range weight{0.0, 1e300};
constexpr Range stiffness{0.0, 1e100};

// `before` is the law of every version without these keys.
// clang-format off
constexpr std::array rows_of_laws{
    Row{"laws.fibre_stiffness", [](Parameters& p) -> std::string& { return p.laws.fibre_stiffness; }, "1", stiffness,
        "", paper, "Eq. 5: stiffness of a fibre over k_0 at the strain eps", rarely,
        "eps < 0 ? 0 : eps <= eps_s ? 1 : exp((eps - eps_s)/d_s)"},
    Row{"laws.curvature_factor", [](Parameters& p) -> std::string& { return p.laws.curvature_factor; }, "1", share,
        "", "MODEL.md, I14", "Eq. 6: factor of the actomyosin tension at the curvature kappa [1/um] of the cortex (convex: positive)", rarely,
        "exp(-0.5*((kappa - kappa_0)/kappa_w)^2)"},
    Row{"laws.disassembly_rate", [](Parameters& p) -> std::string& { return p.laws.disassembly_rate; }, "1/s", rate,
        "", paper, "Eq. 7: rate at which an adhesion disassembles. Arguments: its force F [nN], maturation f_mat, time t since contraction began [s]", rarely,
        "r_off_min + r_off_0*exp(-zeta_diss*F/f_mat)"},
    Row{"laws.growth_force", [](Parameters& p) -> std::string& { return p.laws.growth_force; }, "1", Range{0.0, 100.0},
        "", paper, "Eq. 10: force of growth over F_prot. Arguments: area A of the cell over the initial one, length l of the protrusion [um], time t since it began [s]", rarely,
        "n_prot > 0 && A > 1 ? 1/A : 1"},
    Row{"laws.initiation_rate", [](Parameters& p) -> std::string& { return p.laws.initiation_rate; }, "1/s", rate,
        "", of_methods, "Rate of initiation at a particle of the front. Arguments: angle to the polarization [rad] (before there is one: the mean of the law over all angles), curvature kappa [1/um], occupancy (share of occupied receptors), ligand, alignment with the fibres (-1 to 1)", rarely,
        "r_prot"},
    Row{"laws.initiation_bias", [](Parameters& p) -> std::string& { return p.laws.initiation_bias; }, "1", weight,
        "", of_methods, "Where along the cortex protrusions begin, by the arguments of that rate (angle, kappa, occupancy, ligand, alignment): the rate is multiplied by bias / mean bias, so the total rate of the cell stays the same. A bias of 0 along the whole cortex is none", rarely,
        "1"},
    Row{"laws.polarization_rate", [](Parameters& p) -> std::string& { return p.laws.polarization_rate; }, "1/s", rate,
        "", of_methods, "Rate at which the polarization turns to the mean direction of the adhesions. Argument: the angle between the two [rad]", rarely,
        "r_pol"},
    Row{"laws.degradation_tip", [](Parameters& p) -> std::string& { return p.laws.degradation_tip; }, "1/s", rate,
        "", of_methods, "Rate of degradation at the tip of a growing protrusion. Arguments: intact fraction f of the matrix, pressure p [Pa]", rarely,
        "r_degr_tip"},
    Row{"laws.degradation_protrusion", [](Parameters& p) -> std::string& { return p.laws.degradation_protrusion; }, "1/s", rate,
        "", of_methods, "Rate of degradation along a protrusion. Arguments: intact fraction f of the matrix, pressure p [Pa]", rarely,
        "p > p_th_degr ? r_degr_prot : 0"},
    Row{"laws.degradation_body", [](Parameters& p) -> std::string& { return p.laws.degradation_body; }, "1/s", rate,
        "", of_methods, "Rate of degradation around the body of the cell. Arguments: intact fraction f of the matrix, pressure p [Pa]", rarely,
        "p > p_th_degr ? r_degr_body : 0"},
    Row{"laws.constants", [](Parameters& p) -> std::string& { return p.laws.constants; }, "", {},
        "", "this program", "Constants of your own for these formulas, or a table [laws.constants]", rarely, ""},
};
// clang-format on

constexpr double half_turn = 3.141592653589793;

constexpr std::array strain{LawVariable{"eps", "", -0.5, 1.0, 0.1}};
constexpr std::array curvature{LawVariable{"kappa", "1/um", -5.0, 5.0, 0.0}};
constexpr std::array adhesion{LawVariable{"F", "nN", 0.0, 10.0, 0.3}, LawVariable{"f_mat", "", 0.01, 1.0, 0.5},
                              LawVariable{"t", "s", 0.0, 1e5, 600.0}};
constexpr std::array growth{LawVariable{"A", "", 0.1, 10.0, 1.0}, LawVariable{"l", "um", 0.0, 100.0, 10.0},
                            LawVariable{"t", "s", 0.0, 1e5, 200.0}};
constexpr std::array place{LawVariable{"angle", "rad", -half_turn, half_turn, 0.0},
                           LawVariable{"kappa", "1/um", -5.0, 5.0, 0.05}, LawVariable{"occupancy", "", 0.0, 1.0, 0.5},
                           LawVariable{"ligand", "", 0.0, 100.0, 1.0}, LawVariable{"alignment", "", -1.0, 1.0, 0.0}};
constexpr std::array turn{LawVariable{"angle", "rad", 0.0, half_turn, 0.5}};
constexpr std::array matrix{LawVariable{"f", "", 0.0, 1.0, 1.0}, LawVariable{"p", "Pa", -1e4, 1e4, 100.0}};

} // namespace

std::span<const Row> law_rows() { return rows_of_laws; }

std::span<const LawVariable> law_variables(const Row& law) {
  const std::string_view key = key_of(law);
  if (key == "fibre_stiffness") return strain;
  if (key == "curvature_factor") return curvature;
  if (key == "disassembly_rate") return adhesion;
  if (key == "growth_force") return growth;
  if (key.starts_with("initiation")) return place;
  if (key == "polarization_rate") return turn;
  if (key.starts_with("degradation")) return matrix;
  return {};
}

} // namespace matrigrate
