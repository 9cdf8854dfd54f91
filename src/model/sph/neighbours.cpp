#include "sph/neighbours.hpp"

#include "base/parallel.hpp"
#include "base/points_in.hpp"
#include "state/ecm.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

namespace matrigrate {

namespace {

/// Cells of at least `reach`, so that all partners of a particle lie in its own cell and the eight around it.
struct Grid {
  Vec2 origin = Vec2::Zero();
  Vec2 cell = Vec2::Ones();
  int columns = 1;
  int rows = 1;
  bool periodic = false;
  std::vector<std::uint32_t> first; // of its particles, those in cell c: sorted[first[c]] .. sorted[first[c + 1] - 1]
  std::vector<std::uint32_t> sorted;

  int column_of(const Vec2& x) const {
    const int c = static_cast<int>(std::floor((x.x() - origin.x()) / cell.x()));
    return periodic ? ((c % columns) + columns) % columns : std::clamp(c, 0, columns - 1);
  }
  int row_of(const Vec2& x) const {
    return std::clamp(static_cast<int>(std::floor((x.y() - origin.y()) / cell.y())), 0, rows - 1);
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
  }
};

/// Cells along an extent: as many as fit, but no more than a few a particle however far one has strayed.
int cells_along(double extent, double reach, std::size_t n) {
  const double most = 4.0 * std::sqrt(static_cast<double>(n)) + 8.0;
  return static_cast<int>(std::max(1.0, std::min(std::floor(extent / reach), most)));
}

/// The bounding box of some of the points, at least one.
Box around(std::span<const std::uint32_t> some, std::span<const Vec2> x) {
  Box box{x[some.front()], x[some.front()]};
  for (const std::uint32_t i : some) {
    box.low = box.low.cwiseMin(x[i]);
    box.high = box.high.cwiseMax(x[i]);
    if (!x[i].allFinite()) throw std::invalid_argument("neighbours_within: a position is not finite");
  }
  return box;
}

/// @param some  the particles in the grid, ascending; at least one
Grid make_grid(std::span<const std::uint32_t> some, std::span<const Vec2> x, double reach, double period_x) {
  Grid g;
  const Box box = around(some, x);
  g.periodic = period_x > 0.0;
  g.origin = box.low;
  const Vec2 size = box.high - box.low;
  const Vec2 extent(g.periodic ? period_x : std::max(size.x(), reach), std::max(size.y(), reach));
  g.columns = cells_along(extent.x(), reach, some.size());
  g.rows = cells_along(extent.y(), reach, some.size());
  if (g.periodic && g.columns < 3) throw std::invalid_argument("neighbours_within: the period is too short");
  g.cell = Vec2(extent.x() / g.columns, extent.y() / g.rows);

  std::vector<std::uint32_t> cell_of;
  g.first.assign(g.index(0, g.rows) + 1, 0);
  for (const std::uint32_t i : some) {
    cell_of.push_back(static_cast<std::uint32_t>(g.index(g.column_of(x[i]), g.row_of(x[i]))));
    ++g.first[cell_of.back() + 1];
  }
  for (std::size_t c = 1; c < g.first.size(); ++c) g.first[c] += g.first[c - 1];
  g.sorted.resize(some.size());
  std::vector<std::uint32_t> next(g.first.begin(), g.first.end() - 1);
  for (std::size_t k = 0; k < some.size(); ++k) g.sorted[next[cell_of[k]]++] = some[k];
  return g;
}

/// All particles that may be within reach of some of them: those in their bounding box, enlarged by more than the
/// reach.
std::vector<std::uint32_t> near(std::span<const std::uint32_t> some, std::span<const Vec2> x, double reach,
                                double period_x) {
  Box box = around(some, x);
  box.low.array() -= 1.000001 * reach;
  box.high.array() += 1.000001 * reach;
  if (period_x > 0.0) box = unbounded_along_x(box);
  return points_in(box, x);
}

/// Whether any squared distance |a_i - b_i|^2 exceeds `limit` or is not a number.
MATRIGRATE_SIMD
bool any_further(std::span<const Vec2> a, std::span<const Vec2> b, double limit) {
  std::uint64_t further = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i].x() - b[i].x(), y = a[i].y() - b[i].y();
    further |= x * x + y * y <= limit ? 0U : 1U;
  }
  return further != 0;
}

/// Appends each j != i of the grid within reach of i.
void add_partners(const Grid& g, std::span<const Vec2> x, std::size_t i, double reach, double period_x,
                  std::vector<std::uint32_t>& partners) {
  const int column = g.column_of(x[i]);
  const int row = g.row_of(x[i]);
  for (int r = std::max(0, row - 1); r <= std::min(g.rows - 1, row + 1); ++r)
    for (int c = column - 1; c <= column + 1; ++c) {
      if (!g.periodic && (c < 0 || c >= g.columns)) continue;
      const std::size_t cell = g.index((c + g.columns) % g.columns, r);
      std::size_t count = partners.size();
      partners.resize(count + g.first[cell + 1] - g.first[cell]);
      for (std::uint32_t k = g.first[cell]; k < g.first[cell + 1];
           ++k) { // without branches, which would be unpredictable
        const std::uint32_t j = g.sorted[k];
        const bool close = nearest_image(x[i] - x[j], period_x).squaredNorm() <= reach * reach;
        partners[count] = j;
        count += static_cast<std::size_t>(close & (j != i));
      }
      partners.resize(count);
    }
}

} // namespace

Adjacency neighbours_within(std::span<const Vec2> x, double reach, double period_x) {
  Adjacency list;
  list.first.assign(x.size() + 1, 0);
  if (x.empty()) return list;
  std::vector<std::uint32_t> all(x.size());
  std::iota(all.begin(), all.end(), 0U);
  const Grid g = make_grid(all, x, reach, period_x);
  std::vector<std::vector<std::uint32_t>> partners((x.size() + parallel_block - 1) / parallel_block); // of each block
  const auto of_block = [&](std::size_t b) {
    const std::size_t end = std::min(x.size(), (b + 1) * parallel_block);
    for (std::size_t i = b * parallel_block; i < end; ++i) {
      const std::size_t before = partners[b].size();
      add_partners(g, x, i, reach, period_x, partners[b]);
      std::sort(partners[b].begin() + static_cast<std::ptrdiff_t>(before), partners[b].end());
      list.first[i + 1] = static_cast<std::uint32_t>(partners[b].size() - before);
    }
  };
  parallel_for(partners.size(), of_block, 1);
  for (std::size_t i = 0; i < x.size(); ++i) list.first[i + 1] += list.first[i];
  list.index.reserve(list.first.back());
  for (const auto& block : partners) list.index.insert(list.index.end(), block.begin(), block.end());
  return list;
}

std::span<const std::uint8_t> VerletList::update(std::span<const Vec2> x, double period_x) {
  constexpr std::size_t few = 8; // one particle in so many
  const bool listed = m_x_listed.size() == x.size();
  const double safe = 0.5 * m_skin;
  const auto further = [&](std::size_t begin, std::size_t end) {
    return any_further(x.subspan(begin, end - begin), std::span(m_x_listed).subspan(begin, end - begin), safe * safe);
  };
  if (listed && !parallel_any(x.size(), further)) return {};
  ++m_updates;
  const std::vector<std::uint32_t> from_there = listed ? moved(x) : std::vector<std::uint32_t>();
  if (listed && few * from_there.size() < x.size()) {
    mend(x, period_x, from_there);
    return m_changed;
  }
  list_anew(x, period_x);
  return m_changed;
}

/// All rows, each with room for a few more.
void VerletList::list_anew(std::span<const Vec2> x, double period_x) {
  constexpr std::uint32_t room = 8;
  const Adjacency full = neighbours_within(x, m_reach + m_skin, period_x);
  m_x_listed.assign(x.begin(), x.end());
  const std::size_t n = full.size();
  m_pairs.first.assign(1, 0);
  m_pairs.count.resize(n);
  m_pairs.index.assign(full.pairs() + room * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = full.of(i);
    std::ranges::copy(row, m_pairs.index.begin() + m_pairs.first[i]);
    m_pairs.count[i] = static_cast<std::uint32_t>(row.size());
    m_pairs.first.push_back(m_pairs.first[i] + m_pairs.count[i] + room);
  }
  m_changed.assign(n, 1);
}

/// The row of i.   @return false, with nothing done, where there is no room for it
bool VerletList::replace(std::uint32_t i, std::span<const std::uint32_t> row) {
  if (m_pairs.first[i] + row.size() > m_pairs.first[i + 1]) return false;
  std::ranges::copy(row, m_pairs.index.begin() + m_pairs.first[i]);
  m_pairs.count[i] = static_cast<std::uint32_t>(row.size());
  m_changed[i] = 1;
  return true;
}

/// j into the row of i, if it is not there.   @return as above
bool VerletList::insert(std::uint32_t i, std::uint32_t j) {
  const auto begin = m_pairs.index.begin() + m_pairs.first[i];
  const auto end = begin + m_pairs.count[i];
  const auto place = std::lower_bound(begin, end, j);
  if (place != end && *place == j) return true;
  if (m_pairs.first[i] + m_pairs.count[i] == m_pairs.first[i + 1]) return false;
  std::copy_backward(place, end, end + 1);
  *place = j;
  ++m_pairs.count[i];
  m_changed[i] = 1;
  return true;
}

/// j out of the row of i, if it is there.
void VerletList::remove(std::uint32_t i, std::uint32_t j) {
  const auto begin = m_pairs.index.begin() + m_pairs.first[i];
  const auto end = begin + m_pairs.count[i];
  const auto place = std::lower_bound(begin, end, j);
  if (place == end || *place != j) return;
  std::copy(place + 1, end, place);
  --m_pairs.count[i];
  m_changed[i] = 1;
}

/// Those that would have to be listed anew soon, or at once.
std::vector<std::uint32_t> VerletList::moved(std::span<const Vec2> x) const {
  const double soon = 0.25 * m_skin;
  std::vector<std::uint32_t> moved;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (!((x[i] - m_x_listed[i]).squaredNorm() <= soon * soon)) moved.push_back(static_cast<std::uint32_t>(i));
  return moved;
}

/// Rebuilds the rows of the moved particles and updates the rows of their old and new neighbours.
void VerletList::mend(std::span<const Vec2> x, double period_x, std::span<const std::uint32_t> moved) {
  m_changed.assign(x.size(), 0);
  for (const std::uint32_t i : moved) m_x_listed[i] = x[i];
  const double reach = m_reach + m_skin;
  const Grid grid = make_grid(near(moved, m_x_listed, reach, period_x), m_x_listed, reach, period_x);
  std::vector<std::vector<std::uint32_t>> rows(moved.size());
  const auto find_row = [&](std::size_t k) {
    rows[k].reserve(64); // more than most have
    add_partners(grid, m_x_listed, moved[k], reach, period_x, rows[k]);
    std::ranges::sort(rows[k]);
  };
  parallel_for(moved.size(), find_row, 32);
  std::vector<std::uint32_t> lost, gained;
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const std::uint32_t i = moved[k];
    if (std::ranges::equal(m_pairs.of(i), rows[k])) continue;
    lost.clear();
    gained.clear();
    std::ranges::set_difference(m_pairs.of(i), rows[k], std::back_inserter(lost));
    std::ranges::set_difference(rows[k], m_pairs.of(i), std::back_inserter(gained));
    for (const std::uint32_t j : lost) remove(j, i);
    bool fits = replace(i, rows[k]);
    for (const std::uint32_t j : gained) fits = fits && insert(j, i);
    if (!fits) return list_anew(x, period_x);
  }
}

} // namespace matrigrate
