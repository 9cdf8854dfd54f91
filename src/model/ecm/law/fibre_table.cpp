#include "ecm/law/fibre_table.hpp"

#include "parameters/laws/law.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace matrigrate {

namespace {

constexpr double tolerance = 1e-11;
constexpr double shortest = 1e-12;
constexpr double longest = 0.003;
constexpr std::size_t most_pieces = 20'000;
constexpr std::size_t intervals = 2048;
constexpr int n = 6;

using Values = Eigen::Matrix<double, n, 1>;
using Square = Eigen::Matrix<double, n, n>;

/// Chebyshev node k of a piece, scaled to -1 to 1. No node lies on an end, so a jump of the law there does no harm.
double node(int k) { return -std::cos(std::numbers::pi * (k + 0.5) / n); }

/// From values at the nodes to coefficients.
const Square& to_coefficients() {
  static const Square inverse = [] {
    Square powers;
    for (int row = 0; row < n; ++row)
      for (int k = 0; k < n; ++k) powers(row, k) = std::pow(node(row), k);
    return Square(powers.inverse());
  }();
  return inverse;
}

template <class Coefficients>
double polynomial(const Coefficients& c, double u) {
  double sum = 0.0;
  for (int k = n; k-- > 0;) sum = sum * u + c[static_cast<std::size_t>(k)];
  return sum;
}

template <class Coefficients>
double once_integrated(const Coefficients& c, double u) {
  double sum = 0.0;
  for (std::size_t k = n; k-- > 0;) sum = (sum + c[k] / static_cast<double>(k + 1)) * u;
  return sum;
}

template <class Coefficients>
double twice_integrated(const Coefficients& c, double u) {
  double sum = 0.0;
  for (std::size_t k = n; k-- > 0;) sum = (sum + c[k] / static_cast<double>((k + 1) * (k + 2))) * u;
  return sum * u;
}

} // namespace

FibreTable::FibreTable(const std::function<double(double)>& stiffness, double low, double high,
                       std::span<const double> cuts)
    : m_low(low), m_high(high) {
  std::vector<double> ends{low, 0.0, high};
  const auto is_end = [&](double x) {
    return std::ranges::any_of(ends, [x](double end) { return std::abs(x - end) <= shortest; });
  };
  for (const double cut : cuts)
    if (cut > low && cut < high && !is_end(cut)) ends.push_back(cut);
  std::ranges::sort(ends);
  for (std::size_t k = 1; k < ends.size(); ++k) {
    const auto pieces = static_cast<int>(std::ceil((ends[k] - ends[k - 1]) / longest));
    const auto end = [&](int i) { return i == pieces ? ends[k] : ends[k - 1] + i * (ends[k] - ends[k - 1]) / pieces; };
    for (int i = 0; i < pieces; ++i) add(stiffness, end(i), end(i + 1));
  }
  integrate();
  m_first.resize(intervals + 1);
  for (std::size_t k = 0; k <= intervals; ++k) {
    const double begin = low + (high - low) * static_cast<double>(k) / static_cast<double>(intervals);
    const auto after = std::ranges::upper_bound(m_pieces, begin, {}, &Piece::begin);
    m_first[k] = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(1, after - m_pieces.begin()) - 1);
  }
  m_at_rest = this->stiffness(0.0);
}

void FibreTable::add(const std::function<double(double)>& stiffness, double begin, double end) {
  if (m_pieces.size() >= most_pieces)
    throw std::invalid_argument(
        fmt::format("varies too quickly near eps = {:.6g} to be tabulated in {} pieces", begin, most_pieces));
  Piece piece{.begin = begin, .half = 0.5 * (end - begin), .c = {}, .tension = 0.0, .energy = 0.0};
  const auto law = [&](double u) { return stiffness(begin + piece.half * (1.0 + u)); };
  Values at_nodes;
  for (int k = 0; k < n; ++k) at_nodes(k) = law(node(k));
  const Values c = to_coefficients() * at_nodes;
  for (std::size_t k = 0; k < terms; ++k) piece.c[k] = c(static_cast<Eigen::Index>(k));
  double scale = at_nodes.cwiseAbs().maxCoeff();
  double error = 0.0;
  for (const double u : {-0.9999, -0.83, -0.49, -0.11, 0.13, 0.47, 0.81, 0.9999}) {
    const double value = law(u);
    scale = std::max(scale, std::abs(value));
    error = std::max(error, std::abs(polynomial(piece.c, u) - value));
  }
  if (error > tolerance * scale && end - begin > shortest) {
    const double middle = begin + piece.half;
    add(stiffness, begin, middle);
    add(stiffness, middle, end);
    return;
  }
  if (begin < 0.0 && scale > 0.0) m_pushes = true;
  piece.once = once_integrated(piece.c, -1.0);
  piece.twice = twice_integrated(piece.c, -1.0);
  m_pieces.push_back(piece);
}

double FibreTable::tension_on(const Piece& piece, double u) {
  return piece.tension + piece.half * (once_integrated(piece.c, u) - piece.once);
}

double FibreTable::energy_on(const Piece& piece, double u) {
  return piece.energy + piece.half * (1.0 + u) * (piece.tension - piece.half * piece.once)
         + piece.half * piece.half * (twice_integrated(piece.c, u) - piece.twice);
}

void FibreTable::integrate() {
  const auto zero = std::ranges::find(m_pieces, 0.0, &Piece::begin);
  for (auto piece = zero; piece != m_pieces.end() && piece + 1 != m_pieces.end(); ++piece) {
    (piece + 1)->tension = tension_on(*piece, 1.0);
    (piece + 1)->energy = energy_on(*piece, 1.0);
  }
  double tension = 0.0, energy = 0.0; // at the end of the piece
  for (auto piece = zero; piece-- != m_pieces.begin();) {
    piece->tension = tension - tension_on(*piece, 1.0);
    piece->energy = energy - energy_on(*piece, 1.0);
    tension = piece->tension;
    energy = piece->energy;
  }
}

const FibreTable::Piece& FibreTable::piece(double strain) const {
  if (!(strain >= m_low)) return m_pieces.front(); // not a number
  const double share = (strain - m_low) / (m_high - m_low);
  std::size_t k = m_first[static_cast<std::size_t>(share * static_cast<double>(intervals))];
  while (k + 1 < m_pieces.size() && strain >= m_pieces[k + 1].begin) ++k;
  while (k > 0 && strain < m_pieces[k].begin) --k; // rounding
  return m_pieces[k];
}

FibreTable::Pull FibreTable::pull(double strain) const {
  const double within = std::clamp(strain, m_low, m_high);
  const Piece& found = piece(within);
  const double u = (within - found.begin) / found.half - 1.0;
  const double stiffness = std::max(0.0, polynomial(found.c, u));
  return {tension_on(found, u) + (strain - within) * stiffness, stiffness};
}

double FibreTable::stiffness(double strain) const { return pull(strain).stiffness; }

double FibreTable::tension(double strain) const { return pull(strain).tension; }

double FibreTable::energy(double strain) const {
  const double within = std::clamp(strain, m_low, m_high);
  const Piece& found = piece(within);
  const double value = energy_on(found, (within - found.begin) / found.half - 1.0);
  const double beyond = strain - within;
  return beyond == 0.0 ? value : value + beyond * (tension(within) + 0.5 * beyond * stiffness(within));
}

namespace {

const Row& stiffness_row() { return *find_row("laws.fibre_stiffness"); }

} // namespace

bool has_fibre_table(const Parameters& p) { return is_changed(stiffness_row(), p); }

std::shared_ptr<const FibreTable> fibre_table(const Parameters& p) {
  if (!has_fibre_table(p)) return nullptr;
  const Row& row = stiffness_row();
  const Law law(row.path, p);
  const LawVariable& strain = row.arguments.front();
  return std::make_shared<const FibreTable>([&](double eps) { return law({eps}); }, strain.low, strain.high,
                                            law_numbers(row, p));
}

} // namespace matrigrate
