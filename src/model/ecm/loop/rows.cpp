#include "ecm/loop/rows.hpp"

#include "base/pack.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace matrigrate {

namespace {

constexpr std::size_t lanes = ParticleRows::lanes;

/// Whether partners lie alike, but for rounding.
bool alike(const RowPartner& a, const RowPartner& b) {
  return std::abs(a.half_X - b.half_X) + std::abs(a.half_Y - b.half_Y)
         <= 1e-9 * (std::abs(a.half_X) + std::abs(a.half_Y));
}

/// The partner of particle i that entry k of the list is.
RowPartner partner_at(const Adjacency& pairs, const PairSeparations& separations, std::size_t i, std::uint32_t k) {
  const auto& [X, grad_W, w] = separations[k];
  return {static_cast<std::ptrdiff_t>(pairs.index[k]) - static_cast<std::ptrdiff_t>(i),
          0.5 * X.x(),
          0.5 * X.y(),
          grad_W.x(),
          grad_W.y(),
          w,
          w * X.x(),
          w * X.y()};
}

/// Whether the partners of particle i lie like those of particle i - 1.
bool like_previous(const Adjacency& pairs, const PairSeparations& separations, std::size_t i) {
  const std::uint32_t before = pairs.first[i - 1];
  const std::uint32_t here = pairs.first[i];
  const std::uint32_t count = pairs.first[i + 1] - here;
  if (here - before != count) return false;
  for (std::uint32_t k = 0; k < count; ++k) {
    const RowPartner a = partner_at(pairs, separations, i - 1, before + k);
    const RowPartner b = partner_at(pairs, separations, i, here + k);
    if (a.distance != b.distance || !alike(b, a)) return false;
  }
  return true;
}

/// Calls add(t) for the first of `lanes` particles at a time; the last turn overlaps the one before where the row does
/// not come out even.
template <class Add>
[[gnu::always_inline]] inline void over_row(std::size_t n, const Add& add) {
  for (std::size_t t = 0; t + lanes <= n; t += lanes) add(t);
  if (n % lanes != 0) add(n - lanes);
}

/// Numbers of a partner, the same for the four particles from l on, 0 for those of a ragged row that lack it.
template <bool ragged>
[[gnu::always_inline]] inline void weigh(double number, const double* has, Doubles& weight) {
  fill(number, weight);
  if (!ragged) return;
  Doubles is;
  load(has, is);
  weight *= is;
}

/// The sums of four particles; two of them at a time keep the machine busy.
struct FourTensors {
  Doubles xx{}, xy{}, yx{}, yy{};

  [[gnu::always_inline]] void add(const Doubles& ax, const Doubles& ay, const Doubles& bx, const Doubles& by) {
    xx += ax * bx;
    xy += ax * by;
    yx += ay * bx;
    yy += ay * by;
  }
  [[gnu::always_inline]] void keep(std::size_t t, RowTensors& sum) const {
    store_pack(xx, sum.xx + t);
    store_pack(xy, sum.xy + t);
    store_pack(yx, sum.yx + t);
    store_pack(yy, sum.yy + t);
  }
};

/// Where numbers of four particles begin, less what is added to all of these.
struct AtVectors {
  AtVectors(const VectorPlanes& a, std::ptrdiff_t i) : x(a.x.data() + i), y(a.y.data() + i) {}
  const double *x, *y;
};
struct AtTensors {
  AtTensors(const TensorPlanes& A, std::ptrdiff_t i)
      : xx(A.xx.data() + i), xy(A.xy.data() + i), yx(A.yx.data() + i), yy(A.yy.data() + i) {}
  const double *xx, *xy, *yx, *yy;
};

/// A b + a of four particles.
[[gnu::always_inline]] inline void apply(const AtTensors& A, std::ptrdiff_t i, const Doubles& bx, const Doubles& by,
                                         Doubles& ax, Doubles& ay) {
  Doubles Axx, Axy, Ayx, Ayy;
  load(A.xx + i, Axx);
  load(A.xy + i, Axy);
  load(A.yx + i, Ayx);
  load(A.yy + i, Ayy);
  ax += Axy * by;
  ax += Axx * bx;
  ay += Ayy * by;
  ay += Ayx * bx;
}

template <bool ragged>
[[gnu::always_inline]] inline void add_gradient(const RowPartner& j, const double* has, const AtVectors& a,
                                                std::ptrdiff_t l, FourTensors& sum) {
  Doubles ax, ay, gx, gy;
  load(a.x + j.distance + l, ax);
  load(a.y + j.distance + l, ay);
  weigh<ragged>(j.grad_x, has + l, gx);
  weigh<ragged>(j.grad_y, has + l, gy);
  sum.add(ax, ay, gx, gy);
}

/// sum_gradient of `lanes` particles from t on.
template <bool ragged>
[[gnu::always_inline]] inline void gradient_of(const RowTerms& terms, const VectorPlanes& a, std::size_t t,
                                               RowTensors& sum) {
  const AtVectors at(a, static_cast<std::ptrdiff_t>(terms.row.begin + t));
  const double* has = terms.has;
  FourTensors low, high;
  for (const RowPartner& j : terms.partners) {
    add_gradient<ragged>(j, has, at, 0, low);
    add_gradient<ragged>(j, has, at, 4, high);
    if (ragged) has += lanes;
  }
  low.keep(t, sum);
  high.keep(t + 4, sum);
}

/// H_j X_ij/2 + u_j of four particles j.
[[gnu::always_inline]] inline void half_way(const RowPartner& j, const AtVectors& u, const AtTensors& H,
                                            std::ptrdiff_t l, Doubles& x, Doubles& y) {
  Doubles X, Y;
  fill(j.half_X, X);
  fill(j.half_Y, Y);
  load(u.x + j.distance + l, x);
  load(u.y + j.distance + l, y);
  apply(H, j.distance + l, X, Y, x, y);
}

/// What sum_hourglass makes for four particles.
struct FourHourglass {
  FourTensors moment;
  Doubles x{}, y{};

  template <bool ragged>
  [[gnu::always_inline]] void add(const RowPartner& j, const double* has, const AtVectors& u, const AtTensors& H,
                                  std::ptrdiff_t l) {
    Doubles X, Y, wx, wy, w;
    half_way(j, u, H, l, X, Y);
    weigh<ragged>(j.w_X, has + l, wx);
    weigh<ragged>(j.w_Y, has + l, wy);
    moment.add(X, Y, wx, wy);
    weigh<ragged>(j.w, has + l, w);
    x += w * X;
    y += w * Y;
  }
  [[gnu::always_inline]] void keep(std::size_t t, RowTensors& of_moment, RowVectors& of_force) const {
    moment.keep(t, of_moment);
    store_pack(x, of_force.x + t);
    store_pack(y, of_force.y + t);
  }
};

/// sum_hourglass of `lanes` particles from t on.
template <bool ragged>
[[gnu::always_inline]] inline void hourglass_of(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H,
                                                std::size_t t, RowTensors& moment, RowVectors& force) {
  for (std::size_t half = t; half < t + lanes; half += pack_size<Doubles>) {
    const auto i = static_cast<std::ptrdiff_t>(terms.row.begin + half);
    const AtVectors at_u(u, i);
    const AtTensors at_H(H, i);
    const double* has = terms.has + (half - t);
    FourHourglass sum;
    for (const RowPartner& j : terms.partners) {
      sum.add<ragged>(j, has, at_u, at_H, 0);
      if (ragged) has += lanes;
    }
    sum.keep(half, moment, force);
  }
}

/// sum_stress of `lanes` particles from t on.
template <bool ragged>
[[gnu::always_inline]] inline void stress_of(const RowTerms& terms, const TensorPlanes& Q, std::size_t t,
                                             RowVectors& sum) {
  const AtTensors at(Q, static_cast<std::ptrdiff_t>(terms.row.begin + t));
  const double* has = terms.has;
  Doubles x_low{}, y_low{}, x_high{}, y_high{};
  for (const RowPartner& j : terms.partners) {
    Doubles gx, gy;
    weigh<ragged>(j.grad_x, has, gx);
    weigh<ragged>(j.grad_y, has, gy);
    apply(at, j.distance, gx, gy, x_low, y_low);
    if (ragged) {
      weigh<ragged>(j.grad_x, has + 4, gx);
      weigh<ragged>(j.grad_y, has + 4, gy);
      has += lanes;
    }
    apply(at, j.distance + 4, gx, gy, x_high, y_high);
  }
  store_pack(x_low, sum.x + t);
  store_pack(x_high, sum.x + t + 4);
  store_pack(y_low, sum.y + t);
  store_pack(y_high, sum.y + t + 4);
}

} // namespace

ParticleRows::ParticleRows(const Adjacency& pairs, const PairSeparations& separations) {
  const auto n = static_cast<std::uint32_t>(pairs.size());
  std::uint32_t left = 0; // particles from here on are in no row yet
  for (std::uint32_t i = 0, end = 0; i < n; i = end) {
    end = i + 1;
    while (end < n && end - i < ParticleRow::longest && like_previous(pairs, separations, end)) ++end;
    if (end - i < lanes && end < n) continue;
    const bool long_enough = end - i >= lanes;
    for (const std::uint32_t stop = long_enough ? i : end; left < stop;) {
      const std::uint32_t count = std::min(static_cast<std::uint32_t>(lanes), stop - left);
      add_ragged(left, count, pairs, separations);
      left += count;
    }
    if (long_enough) add_row(i, end - i, pairs, separations);
    left = end;
  }
}

void ParticleRows::add_row(std::uint32_t begin, std::uint32_t count, const Adjacency& pairs,
                           const PairSeparations& separations) {
  const std::uint32_t first = pairs.first[begin];
  const std::uint32_t end = pairs.first[begin + 1];
  m_rows.push_back({begin, count, static_cast<std::uint32_t>(m_partners.size()), end - first, false});
  for (std::uint32_t k = first; k < end; ++k) m_partners.push_back(partner_at(pairs, separations, begin, k));
  m_has.resize(lanes * m_partners.size(), 1.0);
}

void ParticleRows::add_ragged(std::uint32_t begin, std::uint32_t count, const Adjacency& pairs,
                              const PairSeparations& separations) {
  struct Entry {
    RowPartner partner;
    std::array<double, lanes> has;
  };
  std::vector<Entry> entries;
  for (std::uint32_t l = 0; l < count; ++l)
    for (std::uint32_t k = pairs.first[begin + l]; k < pairs.first[begin + l + 1]; ++k) {
      const RowPartner partner = partner_at(pairs, separations, begin + l, k);
      auto found = std::ranges::find_if(entries, [&](const Entry& entry) {
        return entry.partner.distance == partner.distance && alike(entry.partner, partner);
      });
      if (found == entries.end()) found = entries.insert(entries.end(), {partner, {}});
      found->has[l] = 1.0;
    }
  std::ranges::sort(entries, {}, [](const Entry& entry) {
    return std::tuple(entry.partner.distance, entry.partner.half_X, entry.partner.half_Y);
  });
  m_rows.push_back(
      {begin, count, static_cast<std::uint32_t>(m_partners.size()), static_cast<std::uint32_t>(entries.size()), true});
  for (const Entry& entry : entries) {
    m_partners.push_back(entry.partner);
    m_has.insert(m_has.end(), entry.has.begin(), entry.has.end());
  }
}

void VectorPlanes::resize(std::size_t n) {
  x.resize(n);
  y.resize(n);
}

void TensorPlanes::resize(std::size_t n) {
  xx.resize(n);
  xy.resize(n);
  yx.resize(n);
  yy.resize(n);
}

MATRIGRATE_SIMD
bool all_intact(std::span<const double> f) {
  std::uint64_t damaged = 0;
  for (const double f_i : f) damaged |= f_i == 1.0 ? 0U : 1U;
  return damaged == 0;
}

MATRIGRATE_SIMD
void scale(double by, std::size_t n, RowTensors& A) {
  for (double* a : {A.xx, A.xy, A.yx, A.yy})
    for (std::size_t t = 0; t < n; ++t) a[t] *= by;
}

MATRIGRATE_SIMD
void sum_gradient(const RowTerms& terms, const VectorPlanes& a, RowTensors& sum) {
  if (terms.row.ragged) return gradient_of<true>(terms, a, 0, sum);
  over_row(
      terms.row.count, [&](std::size_t t) __attribute__((always_inline)) { gradient_of<false>(terms, a, t, sum); });
}

MATRIGRATE_SIMD
void sum_hourglass(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H, RowTensors& moment,
                   RowVectors& force) {
  if (terms.row.ragged) return hourglass_of<true>(terms, u, H, 0, moment, force);
  over_row(
      terms.row.count, [&](std::size_t t)
                           __attribute__((always_inline)) { hourglass_of<false>(terms, u, H, t, moment, force); });
}

MATRIGRATE_SIMD
void sum_stress(const RowTerms& terms, const TensorPlanes& Q, RowVectors& sum) {
  if (terms.row.ragged) return stress_of<true>(terms, Q, 0, sum);
  over_row(
      terms.row.count, [&](std::size_t t) __attribute__((always_inline)) { stress_of<false>(terms, Q, t, sum); });
}

} // namespace matrigrate
