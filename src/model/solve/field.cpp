#include "solve/field.hpp"

#include "base/pack.hpp"

#include <array>
#include <numeric>

namespace matrigrate {

namespace {

using Partial = std::array<double, 4>;

constexpr std::size_t half = pack_size<HalfFloats>;

/// Values begin .. end - 1, a multiple of eight, of a sum of products a b: four by four, in pairs, in double precision.
/// at(k, a, b) gives the factors from value k on.
template <class At>
[[gnu::always_inline]] inline void add_up(std::size_t begin, std::size_t end, const At& at, Partial& partial) {
  Doubles sum{};
  for (std::size_t k = begin; k < end; k += 2 * half) {
    HalfFloats a, b, c, d;
    at(k, a, b);
    at(k + half, c, d);
    Doubles product;
    widen(a * b + c * d, product);
    sum += product;
  }
  store_pack(sum, partial.data());
}

MATRIGRATE_SIMD
void dot_of(std::size_t begin, std::size_t end, const float* p, const float* q, Partial& partial) {
  add_up(
      begin, end,
      [=](std::size_t k, HalfFloats & a, HalfFloats & b) __attribute__((always_inline)) {
        load(p + k, a);
        load(q + k, b);
      },
      partial);
}

MATRIGRATE_SIMD
void scale(std::size_t begin, std::size_t end, double factor, const double* from, float* to, Partial& partial) {
  add_up(
      begin, end,
      [=](std::size_t k, HalfFloats & a, HalfFloats & b) __attribute__((always_inline)) {
        Doubles value;
        load(from + k, value);
        a = b = __builtin_convertvector(factor * value, HalfFloats);
        store_pack(a, to + k);
      },
      partial);
}

MATRIGRATE_SIMD
void add_products(std::size_t begin, std::size_t end, const float* d, const float* r, float* z, const float* of_b,
                  Partial& partial) {
  add_up(
      begin, end,
      [=](std::size_t k, HalfFloats & a, HalfFloats & b) __attribute__((always_inline)) {
        HalfFloats of_d, of_r;
        load(d + k, of_d);
        load(r + k, of_r);
        load(z + k, a);
        load(of_b + k, b);
        a += of_d * of_r;
        store_pack(a, z + k);
      },
      partial);
}

MATRIGRATE_SIMD
void update_both(std::size_t begin, std::size_t end, float alpha, const float* p, const float* q, float* x, float* r,
                 Partial& partial) {
  add_up(
      begin, end,
      [=](std::size_t k, HalfFloats & a, HalfFloats & b) __attribute__((always_inline)) {
        HalfFloats of_p, of_q, of_x;
        load(p + k, of_p);
        load(q + k, of_q);
        load(x + k, of_x);
        load(r + k, a);
        store_pack(of_x + alpha * of_p, x + k);
        a -= alpha * of_q;
        store_pack(a, r + k);
        b = a;
      },
      partial);
}

/// Sum over all values, to the same bits for any number of threads. part(begin, end, partial) sums some of them.
template <class Part>
double sum_of_parts(std::size_t values, const Part& part) {
  constexpr std::size_t length = 8 * parallel_block;
  std::vector<Partial> partial((values + length - 1) / length);
  std::vector<std::size_t> by_node(partial.size()); // parts of x and y of the same nodes for the same thread
  std::iota(by_node.begin(), by_node.end(), 0);
  std::ranges::sort(by_node, {}, [&](std::size_t b) { return b * length % (values / 2); });
  parallel_parts(partial.size(), [&](std::size_t k) {
    const std::size_t b = by_node[k];
    part(b * length, std::min(values, (b + 1) * length), partial[b]);
  });
  Partial sum{};
  for (const Partial& s : partial)
    for (std::size_t l = 0; l < sum.size(); ++l) sum[l] += s[l];
  return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

} // namespace

double dot(const Field& a, const Field& b) {
  return sum_of_parts(a.values().size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    dot_of(begin, end, a.values().data(), b.values().data(), partial);
  });
}

double assign_scaled(double factor, const DoubleField& a, Field& b) {
  return sum_of_parts(a.values().size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    scale(begin, end, factor, a.values().data(), b.values().data(), partial);
  });
}

double add_product_and_dot(const Field& d, const Field& r, Field& z, const Field& b) {
  return sum_of_parts(z.values().size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    add_products(begin, end, d.values().data(), r.values().data(), z.values().data(), b.values().data(), partial);
  });
}

double conjugate_gradient_step(float alpha, const Field& p, const Field& q, Field& x, Field& r) {
  return sum_of_parts(x.values().size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    update_both(begin, end, alpha, p.values().data(), q.values().data(), x.values().data(), r.values().data(), partial);
  });
}

} // namespace matrigrate
