#include "ecm/rows.hpp"

#include <algorithm>
#include <cmath>

namespace matrigrate {

namespace {

/// Whether the neighbours of particle i lie like those of particle i - 1.
bool like_previous(const Adjacency& pairs, const std::vector<Vec2>& X_ij, std::size_t i) {
  const std::uint32_t before = pairs.first[i - 1];
  const std::uint32_t here = pairs.first[i];
  const std::uint32_t count = pairs.first[i + 1] - here;
  if (here - before != count) return false;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (pairs.index[here + k] != pairs.index[before + k] + 1) return false;
    if ((X_ij[here + k] - X_ij[before + k]).squaredNorm() > 1e-18 * X_ij[here + k].squaredNorm()) return false;
  }
  return true;
}

/// Particles whose sums are made at once, in registers.
constexpr std::size_t lanes = 8;

/// Calls add(t) for t = 0, lanes, 2 lanes, ...; the last turn overlaps the one before where the row does not come out
/// even. Rows that are too short are for single(t).
template <class Packed, class Single>
[[gnu::always_inline]] inline void over_row(std::size_t n, const Packed& packed, const Single& single) {
  if (n < lanes) {
    for (std::size_t t = 0; t < n; ++t) single(t);
    return;
  }
  for (std::size_t t = 0; t + lanes <= n; t += lanes) packed(t);
  if (n % lanes != 0) packed(n - lanes);
}

/// The sums of `width` particles from t on.
template <std::size_t width>
[[gnu::always_inline]] inline void keep(const double (&xx)[width], const double (&xy)[width], const double (&yx)[width],
                                        const double (&yy)[width], std::size_t t, RowTensors& sum) {
  std::copy_n(xx, width, sum.xx + t);
  std::copy_n(xy, width, sum.xy + t);
  std::copy_n(yx, width, sum.yx + t);
  std::copy_n(yy, width, sum.yy + t);
}

/// sum_gradient of `width` particles from t on.
template <std::size_t width>
[[gnu::always_inline]] inline void gradient_of(const RowTerms& terms, const VectorPlanes& a, std::size_t t,
                                               RowTensors& sum) {
  double xx[width] = {}, xy[width] = {}, yx[width] = {}, yy[width] = {};
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const double* ax = a.x.data() + terms.index[k] + t;
    const double* ay = a.y.data() + terms.index[k] + t;
    const double gx = terms.grad_W[k].x();
    const double gy = terms.grad_W[k].y();
    MATRIGRATE_LANES
    for (std::size_t l = 0; l < width; ++l) {
      xx[l] = std::fma(ax[l], gx, xx[l]);
      xy[l] = std::fma(ax[l], gy, xy[l]);
      yx[l] = std::fma(ay[l], gx, yx[l]);
      yy[l] = std::fma(ay[l], gy, yy[l]);
    }
  }
  keep(xx, xy, yx, yy, t, sum);
}

/// sum_hourglass_moment of `width` particles from t on.
template <std::size_t width>
[[gnu::always_inline]] inline void moment_of(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H,
                                             std::size_t t, RowTensors& sum) {
  double xx[width] = {}, xy[width] = {}, yx[width] = {}, yy[width] = {};
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const std::size_t j = terms.index[k] + t;
    const double X = 0.5 * terms.X_ij[k].x();
    const double Y = 0.5 * terms.X_ij[k].y();
    const double wx = terms.W_over_r2[k] * terms.X_ij[k].x();
    const double wy = terms.W_over_r2[k] * terms.X_ij[k].y();
    const double *ux = &u.x[j], *uy = &u.y[j], *hxx = &H.xx[j], *hxy = &H.xy[j], *hyx = &H.yx[j], *hyy = &H.yy[j];
    MATRIGRATE_LANES
    for (std::size_t l = 0; l < width; ++l) {
      const double x = std::fma(hxx[l], X, std::fma(hxy[l], Y, ux[l]));
      const double y = std::fma(hyx[l], X, std::fma(hyy[l], Y, uy[l]));
      xx[l] = std::fma(x, wx, xx[l]);
      xy[l] = std::fma(x, wy, xy[l]);
      yx[l] = std::fma(y, wx, yx[l]);
      yy[l] = std::fma(y, wy, yy[l]);
    }
  }
  keep(xx, xy, yx, yy, t, sum);
}

/// sum_forces of `width` particles from t on.
template <std::size_t width>
[[gnu::always_inline]] inline void forces_of(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H,
                                             const TensorPlanes& Q, std::size_t t, RowVectors& stress,
                                             RowVectors& hourglass) {
  double sx[width] = {}, sy[width] = {}, ex[width] = {}, ey[width] = {};
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const std::size_t j = terms.index[k] + t;
    const double X = 0.5 * terms.X_ij[k].x();
    const double Y = 0.5 * terms.X_ij[k].y();
    const double w = terms.W_over_r2[k];
    const double gx = terms.grad_W[k].x();
    const double gy = terms.grad_W[k].y();
    const double *ux = &u.x[j], *uy = &u.y[j], *hxx = &H.xx[j], *hxy = &H.xy[j], *hyx = &H.yx[j], *hyy = &H.yy[j];
    const double *qxx = &Q.xx[j], *qxy = &Q.xy[j], *qyx = &Q.yx[j], *qyy = &Q.yy[j];
    MATRIGRATE_LANES
    for (std::size_t l = 0; l < width; ++l) {
      sx[l] = std::fma(qxx[l], gx, std::fma(qxy[l], gy, sx[l]));
      sy[l] = std::fma(qyx[l], gx, std::fma(qyy[l], gy, sy[l]));
      ex[l] = std::fma(w, std::fma(hxx[l], X, std::fma(hxy[l], Y, ux[l])), ex[l]);
      ey[l] = std::fma(w, std::fma(hyx[l], X, std::fma(hyy[l], Y, uy[l])), ey[l]);
    }
  }
  std::copy_n(sx, width, stress.x + t);
  std::copy_n(sy, width, stress.y + t);
  std::copy_n(ex, width, hourglass.x + t);
  std::copy_n(ey, width, hourglass.y + t);
}

} // namespace

std::vector<ParticleRow> find_rows(const Adjacency& pairs, const std::vector<Vec2>& X_ij) {
  std::vector<ParticleRow> rows;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!rows.empty() && rows.back().count < ParticleRow::longest && like_previous(pairs, X_ij, i)) {
      ++rows.back().count;
      continue;
    }
    rows.push_back({static_cast<std::uint32_t>(i), 1, pairs.first[i], pairs.first[i + 1] - pairs.first[i]});
  }
  return rows;
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
void sum_gradient(const RowTerms& terms, const VectorPlanes& a, RowTensors& sum) {
  over_row(
      terms.row.count, [&](std::size_t t) __attribute__((always_inline)) { gradient_of<lanes>(terms, a, t, sum); },
      [&](std::size_t t) __attribute__((always_inline)) { gradient_of<1>(terms, a, t, sum); });
}

MATRIGRATE_SIMD
void sum_hourglass_moment(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H, RowTensors& sum) {
  over_row(
      terms.row.count, [&](std::size_t t) __attribute__((always_inline)) { moment_of<lanes>(terms, u, H, t, sum); },
      [&](std::size_t t) __attribute__((always_inline)) { moment_of<1>(terms, u, H, t, sum); });
}

MATRIGRATE_SIMD
void sum_forces(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& H, const TensorPlanes& Q,
                RowVectors& stress, RowVectors& hourglass) {
  over_row(
      terms.row.count,
      [&](std::size_t t) __attribute__((always_inline)) { forces_of<lanes>(terms, u, H, Q, t, stress, hourglass); },
      [&](std::size_t t) __attribute__((always_inline)) { forces_of<1>(terms, u, H, Q, t, stress, hourglass); });
}

} // namespace matrigrate
