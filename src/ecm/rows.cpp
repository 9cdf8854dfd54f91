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

/// e_ij = (F_i + F_j)/2 X_ij - x_ij of the particles of a row, i = begin + t, and one of their neighbours each.
class PairErrors {
public:
  PairErrors(const VectorPlanes& u, const TensorPlanes& F, std::size_t i, std::size_t j, const Vec2& X_ij)
      : m_X(X_ij.x()), m_Y(X_ij.y()), m_ux_i(&u.x[i]), m_ux_j(&u.x[j]), m_uy_i(&u.y[i]), m_uy_j(&u.y[j]),
        m_xx_i(&F.xx[i]), m_xx_j(&F.xx[j]), m_xy_i(&F.xy[i]), m_xy_j(&F.xy[j]), m_yx_i(&F.yx[i]), m_yx_j(&F.yx[j]),
        m_yy_i(&F.yy[i]), m_yy_j(&F.yy[j]) {}

  double x(std::size_t t) const {
    return (0.5 * (m_xx_i[t] + m_xx_j[t]) - 1.0) * m_X + 0.5 * (m_xy_i[t] + m_xy_j[t]) * m_Y - (m_ux_i[t] - m_ux_j[t]);
  }
  double y(std::size_t t) const {
    return 0.5 * (m_yx_i[t] + m_yx_j[t]) * m_X + (0.5 * (m_yy_i[t] + m_yy_j[t]) - 1.0) * m_Y - (m_uy_i[t] - m_uy_j[t]);
  }

private:
  double m_X, m_Y;
  const double *m_ux_i, *m_ux_j, *m_uy_i, *m_uy_j;
  const double *m_xx_i, *m_xx_j, *m_xy_i, *m_xy_j, *m_yx_i, *m_yx_j, *m_yy_i, *m_yy_j;
};

void clear(RowTensors& sum, std::size_t n) {
  for (double* values : {sum.xx, sum.xy, sum.yx, sum.yy}) std::fill_n(values, n, 0.0);
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
  clear(sum, n);
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
  clear(sum, n);
  for (std::size_t k = terms.row.entry; k < terms.row.entry + terms.row.partners; ++k) {
    const std::size_t j = terms.index[k];
    const double X = terms.X_ij[k].x();
    const double Y = terms.X_ij[k].y();
    const double w = terms.W_over_r2[k];
    const double* f = terms.f + j;
    const PairErrors e(u, F, i, j, terms.X_ij[k]);
    const auto add = [&](std::size_t t) {
      const double ex = e.x(t);
      const double ey = e.y(t);
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
    const double bw = b * terms.W_over_r2[k];
    const double agx = a * terms.grad_W[k].x();
    const double agy = a * terms.grad_W[k].y();
    const double* f = terms.f + j;
    const PairErrors e(u, F, i, j, terms.X_ij[k]);
    const double *Qxx_i = Q.xx.data() + i, *Qxx_j = Q.xx.data() + j, *Qxy_i = Q.xy.data() + i, *Qxy_j = Q.xy.data() + j;
    const double *Qyx_i = Q.yx.data() + i, *Qyx_j = Q.yx.data() + j, *Qyy_i = Q.yy.data() + i, *Qyy_j = Q.yy.data() + j;
    const auto add = [&](std::size_t t) {
      const double ex = e.x(t);
      const double ey = e.y(t);
      const double sx = (Qxx_i[t] + Qxx_j[t]) * agx + (Qxy_i[t] + Qxy_j[t]) * agy;
      const double sy = (Qyx_i[t] + Qyx_j[t]) * agx + (Qyy_i[t] + Qyy_j[t]) * agy;
      sum.x[t] += f[t] * (sx + bw * ex);
      sum.y[t] += f[t] * (sy + bw * ey);
    };
    each_of_row(n, add);
  }
}

} // namespace matrigrate
