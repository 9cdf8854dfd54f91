#include "base/random.hpp"

#include "statistics/kolmogorov_smirnov.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

using namespace matrigrate;

namespace {

using Stream = std::function<double(std::uint32_t)>;

std::vector<double> draws(std::uint32_t n, const Stream& stream) {
  std::vector<double> u;
  for (std::uint32_t k = 0; k < n; ++k) u.push_back(stream(k));
  return u;
}

double uniformity(const std::vector<double>& u) {
  return kolmogorov_smirnov(u, [](double x) { return x; });
}

/// Correlation of two samples of uniform numbers, times sqrt(n): about normal with variance 1 where they are
/// independent.
double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - 0.5) * (b[k] - 0.5);
  return 12.0 * sum / std::sqrt(static_cast<double>(a.size()));
}

/// The upper 52 bits of a draw.
std::uint64_t bits(double u) { return static_cast<std::uint64_t>(u * 0x1p52); }

const Stream by_entity = [](std::uint32_t k) { return uniform(1, Purpose::test, 7, k); };
const Stream by_step = [](std::uint32_t k) { return uniform(1, Purpose::test, k, 7); };
const Stream by_seed = [](std::uint32_t k) { return uniform(k, Purpose::test, 7, 7); };

} // namespace

// The three known answers of Philox4x32-10 that come with Random123 (Salmon et al. 2011).
TEST(Uniform, KnownAnswersOfPhilox) {
  EXPECT_EQ(bits(uniform(0, Purpose{0}, 0, 0)), 0x6627e8d5e169c58dU >> 12U);
  constexpr std::uint64_t ones = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(bits(uniform(ones, Purpose{0xffffffffU}, ones, 0xffffffffU)), 0x408f276d41c83b0eU >> 12U);
  EXPECT_EQ(bits(uniform(0x299f31d0a4093822U, Purpose{0x03707344U}, 0x85a308d3243f6a88U, 0x13198a2eU)),
            0xd16cfe0994fdccebU >> 12U);
}

// Draws as runs of a single cell have always had them, by an independent implementation of Philox4x32-10.
TEST(Uniform, OfTheFirstCellKeepsItsNumbers) {
  EXPECT_EQ(bits(uniform(1, Purpose::initiation, 7, 5, 0)), 0x3a3fdb838e339f5aU >> 12U);
  EXPECT_EQ(bits(uniform(3, Purpose::disassembly, 4500, 12, 0)), 0x18a9610250fe4897U >> 12U);
}

TEST(Uniform, IsAPureFunctionOfWhatItIsFor) {
  const double u = uniform(3, Purpose::initiation, 11, 5);
  uniform(3, Purpose::initiation, 12, 5);
  EXPECT_EQ(uniform(3, Purpose::initiation, 11, 5), u);
  EXPECT_NE(uniform(4, Purpose::initiation, 11, 5), u);
  EXPECT_NE(uniform(3, Purpose::disassembly, 11, 5), u);
  EXPECT_NE(uniform(3, Purpose::initiation, 12, 5), u);
  EXPECT_NE(uniform(3, Purpose::initiation, 11, 6), u);
  EXPECT_NE(uniform(3, Purpose::initiation, 11, 5, 1), u);
  EXPECT_NE(uniform(3, Purpose::initiation, 11, 5, (1U << 24U) - 1), u);
  EXPECT_NE(uniform(3 + (std::uint64_t{1} << 32U), Purpose::initiation, 11, 5), u);
  EXPECT_NE(uniform(3, Purpose::initiation, 11 + (std::uint64_t{1} << 32U), 5), u);
}

TEST(Uniform, LiesStrictlyBetweenZeroAndOne) {
  for (const double u : draws(200000, by_entity)) {
    ASSERT_GT(u, 0.0);
    ASSERT_LT(u, 1.0);
  }
}

TEST(Uniform, IsUniformAlongEachArgument) {
  for (const Stream& stream : {by_entity, by_step, by_seed})
    EXPECT_LT(uniformity(draws(20000, stream)), one_in_a_hundred);
}

TEST(Uniform, FillsSmallBinsEvenly) { // the events of a run have probabilities of 1e-5 to 1e-3
  constexpr std::size_t bins = 256;
  constexpr std::uint32_t n = 100 * bins;
  std::array<int, bins> count{};
  for (const double u : draws(n, by_step)) ++count[static_cast<std::size_t>(u * bins)];
  double chi2 = 0.0;
  for (const int c : count) chi2 += std::pow(c - 100.0, 2) / 100.0;
  EXPECT_LT(chi2, 311.0); // one in a hundred at 255 degrees of freedom
  EXPECT_GT(chi2, 205.0);
}

TEST(Uniform, LowBitsAreUniformToo) {
  std::vector<double> u = draws(20000, by_entity);
  for (double& x : u) x = x * 0x1p32 - std::floor(x * 0x1p32);
  EXPECT_LT(uniformity(u), one_in_a_hundred);
}

TEST(Uniform, StreamsAreIndependent) {
  constexpr std::uint32_t n = 20000;
  const std::vector<double> u = draws(n, [](std::uint32_t k) { return uniform(1, Purpose::initiation, k, 7); });
  const std::array<Stream, 7> others{
      [](std::uint32_t k) { return uniform(1, Purpose::disassembly, k, 7); },
      [](std::uint32_t k) { return uniform(1, Purpose::initiation, k, 8); },
      [](std::uint32_t k) { return uniform(1, Purpose::initiation, k + 1, 7); },
      [](std::uint32_t k) { return uniform(2, Purpose::initiation, k, 7); },
      [](std::uint32_t k) { return uniform(1, Purpose::initiation, 7, k); },
      [](std::uint32_t k) { return uniform(1, Purpose::initiation, k, 7, 1); },
      [](std::uint32_t k) { return uniform(1, Purpose::initiation, k, 7, 2); },
  };
  for (const Stream& other : others) EXPECT_LT(std::abs(correlation(u, draws(n, other))), 3.3);
  EXPECT_GT(correlation(u, u), 100.0); // the measure sees a dependence
}

TEST(EventProbability, LimitsAndComposition) {
  EXPECT_EQ(event_probability(0.0, 0.4), 0.0);
  EXPECT_EQ(event_probability(0.3, 0.0), 0.0);
  EXPECT_EQ(event_probability(1e4, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(event_probability(1e-18, 1.0), 1e-18); // no cancellation
  EXPECT_NEAR(event_probability(std::log(2.0), 1.0), 0.5, 1e-15);
  const double half = event_probability(0.2, 0.2);
  EXPECT_NEAR(1.0 - (1.0 - half) * (1.0 - half), event_probability(0.2, 0.4), 1e-15);
}
