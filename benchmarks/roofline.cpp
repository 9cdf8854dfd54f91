// What the machine can do on one core: a triad over sizes that fit its caches and its memory, and multiplications with
// additions on numbers in registers.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

MATRIGRATE_SIMD
void add_scaled(const double* a, const double* b, double* __restrict c, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) c[i] = std::fma(3.0, b[i], a[i]);
}

void triad(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0)) * 1024 / (3 * sizeof(double));
  const std::vector<double> a(n, 1.0), b(n, 2.0);
  std::vector<double> c(n);
  for (auto _ : state) {
    add_scaled(a.data(), b.data(), c.data(), n);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * sizeof(double) * n));
}

constexpr int turns = 1000;
constexpr std::size_t chains = 12; // of a few numbers each, enough to hide the latency of an operation

/// `width` numbers of a chain at once.
template <class Number, std::size_t width>
[[gnu::always_inline]] inline void multiply_add_chains(Number* x) {
  Number sum[chains][width];
  std::copy_n(x, chains * width, &sum[0][0]);
  for (int k = 0; k < turns; ++k) {
#pragma GCC unroll 12
    for (std::size_t c = 0; c < chains; ++c) {
#pragma GCC unroll 1
      for (std::size_t l = 0; l < width; ++l) sum[c][l] = std::fma(sum[c][l], Number(0.999), Number(0.001));
    }
  }
  std::copy_n(&sum[0][0], chains * width, x);
}

MATRIGRATE_SIMD void multiply_add(double* x) { multiply_add_chains<double, 4>(x); }
MATRIGRATE_SIMD void multiply_add(float* x) { multiply_add_chains<float, 8>(x); }

template <class Number>
void operations(benchmark::State& state) {
  constexpr std::size_t numbers = chains * 32 / sizeof(Number);
  std::vector<Number> x(numbers, Number(0.5));
  for (auto _ : state) {
    multiply_add(x.data());
    benchmark::ClobberMemory();
  }
  state.counters["flop/s"] = benchmark::Counter(2.0 * numbers * turns, benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK(triad)->ArgName("KiB")->Arg(24)->Arg(512)->Arg(8192)->Arg(262144);
BENCHMARK(operations<double>);
BENCHMARK(operations<float>);

} // namespace
