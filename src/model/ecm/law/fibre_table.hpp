#pragma once

#include "ecm/law/fibres.hpp"
#include "parameters/parameters.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

/// A law of fibres that a user gives as a formula (laws.fibre_stiffness), as a table that any thread may read.
/// Test: tests/unit/ecm/law/law_test.cpp
namespace matrigrate {

/// Stiffness over k_0 as polynomials of degree 5 on pieces, at first of 0.003 or less, halved until they differ from
/// the law by less than 1e-11 of its largest value on the piece, or are shorter than 1e-12, as at a jump. Tension and
/// energy are their integrals, so that each is the derivative of the next, exactly. Beyond both ends the stiffness
/// stays. What is narrower than 0.001 may be missed, unless pieces are told to end there.
class FibreTable {
public:
  /// @param stiffness  over k_0, finite from `low` < 0 to `high` > 0
  /// @param cuts  where it may jump or bend: pieces end there
  /// @throws std::invalid_argument if more than 20,000 pieces are needed
  FibreTable(const std::function<double(double)>& stiffness, double low, double high,
             std::span<const double> cuts = {});

  /// Tension and stiffness.
  struct Pull {
    double tension = 0.0;
    double stiffness = 0.0;
  };

  Pull pull(double strain) const;        ///< tension() and stiffness() in one look-up
  double stiffness(double strain) const; ///< over k_0, >= 0 [-]
  double tension(double strain) const;   ///< integral of stiffness() from 0 [-]
  double energy(double strain) const;    ///< integral of tension() from 0 [-]

  /// The stiffness that a fibre has as it begins to be stretched [-].
  double at_rest() const { return m_at_rest; }

  /// Whether a compressed fibre pushes.
  bool pushes() const { return m_pushes; }

  std::size_t size() const { return m_pieces.size(); }

private:
  static constexpr std::size_t terms = 6;

  struct Piece {
    double begin = 0.0;
    double half = 0.0;             ///< half of its length
    std::array<double, terms> c{}; ///< of the stiffness, in u from -1 to 1
    double tension = 0.0;          ///< at its beginning
    double energy = 0.0;           ///< at its beginning
    double once = 0.0;             ///< integral of the polynomial, without a constant, at u = -1
    double twice = 0.0;            ///< integral of that
  };

  void add(const std::function<double(double)>& stiffness, double begin, double end);
  void integrate();
  const Piece& piece(double strain) const;
  static double tension_on(const Piece& piece, double u);
  static double energy_on(const Piece& piece, double u);

  double m_low, m_high;
  std::vector<Piece> m_pieces;
  std::vector<std::uint32_t> m_first; ///< of equal intervals: the piece that holds its beginning
  double m_at_rest = 0.0;
  bool m_pushes = false;
};

/// Whether the law of fibres is not that of the paper, which ecm/law/fibres.hpp has.
bool has_fibre_table(const Parameters& p);

/// The table of such a law; null for that of the paper.
/// @throws std::invalid_argument if the law cannot be read or tabulated
std::shared_ptr<const FibreTable> fibre_table(const Parameters& p);

/// The law of one fibre: that of the paper, or a table.
struct FibreLaw {
  const FibreParameters& p;
  const FibreTable* table = nullptr;

  bool pushes() const { return table != nullptr && table->pushes(); }

  /// Force of a fibre over w_ij |X_ij|, per depth [kPa].
  double tension(double strain) const {
    return table == nullptr ? fibre_tension(strain, p) : p.stiffness * table->tension(strain);
  }

  /// Energy of a fibre over w_ij |X_ij|^2, per depth [kPa].
  double energy(double strain) const {
    return table == nullptr ? fibre_energy(strain, p) : p.stiffness * table->energy(strain);
  }

  /// What a step needs of a fibre.
  struct Pull {
    double tension = 0.0;  ///< [kPa]
    bool stiffens = false; ///< whether it is stiffer than as it begins to be stretched,
    double excess = 0.0;   ///< and by how much [kPa]
  };

  Pull pull(double strain) const {
    if (table == nullptr) {
      const bool stiffens = strain > p.onset;
      return {fibre_tension(strain, p), stiffens, stiffens ? fibre_stiffness(strain, p) - p.stiffness : 0.0};
    }
    const FibreTable::Pull found = table->pull(strain);
    const double excess = found.stiffness - table->at_rest();
    return {p.stiffness * found.tension, excess > 0.0, p.stiffness * excess};
  }
};

} // namespace matrigrate
