#include "ecm/rows.hpp"

#include <algorithm>

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

/// Calls add(t) for the particles of a row; those at the edge of a body are alone in theirs.
template <class Add>
[[gnu::always_inline]] inline void each_of_row(std::size_t n, const Add& add) {
  if (n == 1) return add(0);
  MATRIGRATE_INDEPENDENT
  for (std::size_t t = 0; t < n; ++t) add(t);
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
  const std::size_t i = terms.row.begin;
  const std::size_t n = terms.row.count;
  std::fill_n(sum.xx, n, 0.0);
  std::fill_n(sum.xy, n, 0.0);
  std::fill_n(sum.yx, n, 0.0);
  std::fill_n(sum.yy, n, 0.0);
  const double* ax = a.x.data() + i;
  const double* ay = a.y.data() + i;
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const std::size_t j = terms.index[k];
    const double* f = terms.f + j;
    const double* bx = a.x.data() + j;
    const double* by = a.y.data() + j;
    const double gx = terms.grad_W[k].x();
    const double gy = terms.grad_W[k].y();
    const auto add = [&](std::size_t t) {
      const double wx = f[t] * (bx[t] - ax[t]);
      const double wy = f[t] * (by[t] - ay[t]);
      sum.xx[t] += wx * gx;
      sum.xy[t] += wx * gy;
      sum.yx[t] += wy * gx;
      sum.yy[t] += wy * gy;
    };
    each_of_row(n, add);
  }
}

MATRIGRATE_SIMD
void sum_hourglass_moment(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& F, RowTensors& sum) {
  const std::size_t i = terms.row.begin;
  const std::size_t n = terms.row.count;
  std::fill_n(sum.xx, n, 0.0);
  std::fill_n(sum.xy, n, 0.0);
  std::fill_n(sum.yx, n, 0.0);
  std::fill_n(sum.yy, n, 0.0);
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const std::size_t j = terms.index[k];
    const double X = terms.X_ij[k].x();
    const double Y = terms.X_ij[k].y();
    const double w = terms.W_over_r2[k];
    const double* f = terms.f + j;
    const double *ux_i = u.x.data() + i, *ux_j = u.x.data() + j, *uy_i = u.y.data() + i, *uy_j = u.y.data() + j;
    const double *xx_i = F.xx.data() + i, *xx_j = F.xx.data() + j, *xy_i = F.xy.data() + i, *xy_j = F.xy.data() + j;
    const double *yx_i = F.yx.data() + i, *yx_j = F.yx.data() + j, *yy_i = F.yy.data() + i, *yy_j = F.yy.data() + j;
    const auto add = [&](std::size_t t) {
      const double ex = (0.5 * (xx_i[t] + xx_j[t]) - 1.0) * X + 0.5 * (xy_i[t] + xy_j[t]) * Y - (ux_i[t] - ux_j[t]);
      const double ey = 0.5 * (yx_i[t] + yx_j[t]) * X + (0.5 * (yy_i[t] + yy_j[t]) - 1.0) * Y - (uy_i[t] - uy_j[t]);
      const double fw = f[t] * w;
      sum.xx[t] += fw * ex * X;
      sum.xy[t] += fw * ex * Y;
      sum.yx[t] += fw * ey * X;
      sum.yy[t] += fw * ey * Y;
    };
    each_of_row(n, add);
  }
}

MATRIGRATE_SIMD
void sum_forces(const RowTerms& terms, const VectorPlanes& u, const TensorPlanes& F, const TensorPlanes& Q, double a,
                double b, RowVectors& sum) {
  const std::size_t i = terms.row.begin;
  const std::size_t n = terms.row.count;
  std::fill_n(sum.x, n, 0.0);
  std::fill_n(sum.y, n, 0.0);
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const std::size_t j = terms.index[k];
    const double X = terms.X_ij[k].x();
    const double Y = terms.X_ij[k].y();
    const double bw = b * terms.W_over_r2[k];
    const double agx = a * terms.grad_W[k].x();
    const double agy = a * terms.grad_W[k].y();
    const double* f = terms.f + j;
    const double *ux_i = u.x.data() + i, *ux_j = u.x.data() + j, *uy_i = u.y.data() + i, *uy_j = u.y.data() + j;
    const double *xx_i = F.xx.data() + i, *xx_j = F.xx.data() + j, *xy_i = F.xy.data() + i, *xy_j = F.xy.data() + j;
    const double *yx_i = F.yx.data() + i, *yx_j = F.yx.data() + j, *yy_i = F.yy.data() + i, *yy_j = F.yy.data() + j;
    const double *Qxx_i = Q.xx.data() + i, *Qxx_j = Q.xx.data() + j, *Qxy_i = Q.xy.data() + i, *Qxy_j = Q.xy.data() + j;
    const double *Qyx_i = Q.yx.data() + i, *Qyx_j = Q.yx.data() + j, *Qyy_i = Q.yy.data() + i, *Qyy_j = Q.yy.data() + j;
    const auto add = [&](std::size_t t) {
      const double ex = (0.5 * (xx_i[t] + xx_j[t]) - 1.0) * X + 0.5 * (xy_i[t] + xy_j[t]) * Y - (ux_i[t] - ux_j[t]);
      const double ey = 0.5 * (yx_i[t] + yx_j[t]) * X + (0.5 * (yy_i[t] + yy_j[t]) - 1.0) * Y - (uy_i[t] - uy_j[t]);
      const double sx = (Qxx_i[t] + Qxx_j[t]) * agx + (Qxy_i[t] + Qxy_j[t]) * agy;
      const double sy = (Qyx_i[t] + Qyx_j[t]) * agx + (Qyy_i[t] + Qyy_j[t]) * agy;
      sum.x[t] += f[t] * (sx + bw * ex);
      sum.y[t] += f[t] * (sy + bw * ey);
    };
    each_of_row(n, add);
  }
}

} // namespace matrigrate
