#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/pack.hpp"
#include "base/parallel.hpp"
#include "base/points_in.hpp"
#include "base/random.hpp"
#include "base/text.hpp"
#include "base/vector.hpp"
#include "statistics/distributions.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace matrigrate;

namespace matrigrate {
namespace {

namespace fs = std::filesystem;

/// A new folder for each test.
class File : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "matrigrate-file-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }

  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  fs::path folder;
};

/// The reason with which a call fails.
template <class Call>
std::string reason(const Call& call) {
  try {
    call();
  } catch (const InputOutputError& error) {
    return error.what();
  }
  return "no failure";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_F(File, WhatIsWrittenIsReadBack) {
  const std::string content("a\0b\r\n\xff", 6);
  write_file(folder / "f", content);
  EXPECT_EQ(read_file(folder / "f", 6), content);
  write_file(folder / "f", "");
  EXPECT_EQ(read_file(folder / "f", 0), "");
  EXPECT_EQ(entries(), 1u) << "a temporary file is left";
}

TEST_F(File, ManyBytesAreReadBack) {
  std::string content(1 << 20, 'x');
  content.back() = 'y';
  write_file(folder / "f", content);
  EXPECT_EQ(read_file(folder / "f", 1 << 20), content);
}

TEST_F(File, AFailedWriteLeavesTheOldFile) {
  const std::string in_nowhere = reason([&] { write_file(folder / "nowhere" / "f", "x"); });
  EXPECT_TRUE(contains(in_nowhere, "nowhere/f: cannot be written: No such file or directory")) << in_nowhere;
  fs::create_directory(folder / "d");
  EXPECT_TRUE(contains(reason([&] { write_file(folder / "d", "x"); }), "is a folder"));
  EXPECT_TRUE(contains(reason([] { write_file("/dev/null", "x"); }), "not a regular file"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(File, NamesOfTemporaryFilesAreKnown) {
  EXPECT_EQ(file_of_temporary(".fields.h5.a1B2c3"), "fields.h5");
  for (const char* name : {"", ".", ".lock", "fields.h5", ".fields.h5.a1B2c", ".fields.h5.a1B2c34", "fields.h5.a1B2c3",
                           ".fields.h5.a1B-c3", "..a1B2c3"})
    EXPECT_FALSE(file_of_temporary(name)) << name;
}

TEST_F(File, WrittenFilesHaveTheUsualPermissions) {
  write_file(folder / "f", "x");
  std::ofstream(folder / "g") << "x";
  EXPECT_EQ(fs::status(folder / "f").permissions(), fs::status(folder / "g").permissions());
}

TEST_F(File, RefusesToReadWhatIsNoFile) {
  EXPECT_TRUE(contains(reason([&] { read_file(folder, 10); }), "is a folder"));
  EXPECT_TRUE(contains(reason([&] { read_file(folder / "none", 10); }), "No such file"));
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_TRUE(contains(reason([&] { read_file(folder / "pipe", 10); }), "not a regular file")) << "and does not wait";
}

TEST_F(File, RefusesToReadWhatIsTooLarge) {
  std::ofstream(folder / "f") << "12345";
  EXPECT_EQ(read_file(folder / "f", 5), "12345");
  const std::string message = reason([&] { read_file(folder / "f", 4); });
  EXPECT_TRUE(contains(message, "has 5 bytes, more than the 4 allowed")) << message;
}

TEST_F(File, MakesFolders) {
  make_folder(folder / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder / "a" / "b"));
  write_file(folder / "a" / "b" / "f", "x");
  make_folder(folder / "a" / "b");
  EXPECT_EQ(read_file(folder / "a" / "b" / "f", 1), "x") << "nothing is deleted";
  EXPECT_TRUE(contains(reason([&] { make_folder(folder / "a" / "b" / "f"); }), "not a folder"));
}

TEST_F(File, Grows) {
  GrowingFile file(folder / "f", "head\n");
  EXPECT_EQ(read_file(folder / "f", 99), "head\n");
  file.append("a\n");
  file.append("b\n");
  file.flush();
  EXPECT_EQ(read_file(folder / "f", 99), "head\na\nb\n");
  EXPECT_TRUE(contains(reason([&] { GrowingFile(folder / "none" / "f", ""); }), "none/f: cannot be written"));
}

TEST_F(File, TakesBackAPieceThatDoesNotFit) {
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old_limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  GrowingFile file(folder / "f", "head\n");
  rlimit limit = old_limit;
  limit.rlim_cur = 10;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message = reason([&] { file.append("too long\n"); });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &old_limit), 0);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_TRUE(contains(message, "f: cannot be written: File too large")) << message;
  EXPECT_EQ(read_file(folder / "f", 99), "head\n");
  file.append("fits\n");
  EXPECT_EQ(read_file(folder / "f", 99), "head\nfits\n");
}

TEST_F(File, RenamesOverAnother) {
  write_file(folder / "a", "new");
  write_file(folder / "b", "old");
  rename_file(folder / "a", folder / "b");
  EXPECT_EQ(read_file(folder / "b", 10), "new");
  EXPECT_EQ(entries(), 1u);
  EXPECT_TRUE(contains(reason([&] { rename_file(folder / "none", folder / "b"); }), "No such file"));
}

} // namespace
} // namespace matrigrate

TEST(Pack, IsReadFromAndWrittenToAnyPlace) {
  std::vector<double> numbers(11);
  std::iota(numbers.begin(), numbers.end(), 0.5);
  for (std::size_t at = 0; at + pack_size<Doubles> <= numbers.size(); ++at) {
    Doubles a;
    load(numbers.data() + at, a);
    std::vector<double> copy(numbers.size(), -1.0);
    store_pack(a, copy.data() + at);
    for (std::size_t i = 0; i < copy.size(); ++i)
      EXPECT_EQ(copy[i], i >= at && i < at + pack_size<Doubles> ? numbers[i] : -1.0);
  }
}

TEST(Pack, HasOneNumberThroughoutWhenFilled) {
  Floats a;
  fill(0.1F, a);
  for (std::size_t l = 0; l < pack_size<Floats>; ++l) EXPECT_EQ(a[l], 0.1F);
  EXPECT_EQ(pack_size<Doubles>, 4U);
  EXPECT_EQ(pack_size<Floats>, 8U);
}

TEST(Pack, KnowsWhetherAnyNumberIsNotZero) {
  HalfFloats a{};
  EXPECT_FALSE(any(a));
  for (std::size_t l = 0; l < pack_size<HalfFloats>; ++l) {
    HalfFloats b{};
    b[l] = std::numeric_limits<float>::denorm_min();
    EXPECT_TRUE(any(b)) << l;
  }
}

namespace matrigrate {
namespace {

/// Terms whose sum depends on the order of the additions.
double rough(std::size_t i) {
  const double sign = i % 3 == 0 ? -1.0 : 1.0;
  return sign * std::pow(10.0, static_cast<double>((i * 7919) % 17)) / static_cast<double>(i + 1);
}

template <class F>
auto with_threads(int threads, const F& f) {
  const ThreadLimit limit(threads);
  tbb::task_arena arena(threads);
  return arena.execute(f);
}

TEST(Parallel, TheTermsOfTheseTestsTellOrdersApart) {
  double up = 0.0;
  double down = 0.0;
  for (std::size_t i = 0; i < 10'000; ++i) up += rough(i);
  for (std::size_t i = 10'000; i-- > 0;) down += rough(i);
  EXPECT_NE(up, down);
}

TEST(Parallel, OrderedSumHasTheSameBitsForAnyNumberOfThreads) {
  for (const std::size_t n : {std::size_t{100'003}, std::size_t{512}, std::size_t{513}, std::size_t{7}}) {
    const double reference = with_threads(1, [&] { return ordered_sum(n, 0.0, rough); });
    for (const int threads : {2, 4, 7})
      for (int repeat = 0; repeat < 20; ++repeat) {
        const double sum = with_threads(threads, [&] { return ordered_sum(n, 0.0, rough); });
        ASSERT_EQ(std::bit_cast<std::uint64_t>(sum), std::bit_cast<std::uint64_t>(reference)) << n << ' ' << threads;
      }
  }
}

TEST(Parallel, OrderedSumOfVectorsAddsEveryTermOnce) {
  const Vec2 sum = ordered_sum(2'001, Vec2(0.0, 0.0), [](std::size_t i) { return Vec2(static_cast<double>(i), 1.0); });
  EXPECT_EQ(sum, Vec2(2'001'000.0, 2'001.0));
}

TEST(Parallel, TheEmptySumIsZeroAndDoesNotCallTheTerm) {
  EXPECT_EQ(ordered_sum(0, 3.0, [](std::size_t) -> double { throw std::runtime_error("called"); }), 3.0);
}

TEST(Parallel, LoopVisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 4, 7}) {
    std::vector<std::atomic<int>> visits(5'000);
    with_threads(threads, [&] {
      parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
      return 0;
    });
    for (const auto& n : visits) ASSERT_EQ(n.load(), 1);
  }
}

TEST(Parallel, AnyFindsOneIndexWhereverItIs) {
  for (const int threads : {1, 2, 5})
    with_threads(threads, [&] {
      const auto found = [](std::size_t n, std::size_t wanted) {
        return parallel_any(
            n, [=](std::size_t begin, std::size_t end) { return begin <= wanted && wanted < end; }, 16);
      };
      for (const std::size_t wanted : {0U, 15U, 16U, 500U, 999U}) EXPECT_TRUE(found(1000, wanted));
      EXPECT_FALSE(found(1000, 1000));
      EXPECT_FALSE(found(0, 0));
      return 0;
    });
}

TEST(Parallel, BlocksThatPassATestAreVisitedInOrder) {
  for (const int threads : {1, 3})
    with_threads(threads, [&] {
      const std::size_t n = 20 * parallel_block + 7;
      std::vector<std::size_t> visited;
      each_block_with(
          n, [](std::size_t begin, std::size_t) { return begin / parallel_block % 10 == 0; },
          [&](std::size_t begin, std::size_t end) {
            visited.insert(visited.end(), {begin, end});
          });
      EXPECT_EQ(visited, (std::vector<std::size_t>{0, parallel_block, 10 * parallel_block, 11 * parallel_block,
                                                   20 * parallel_block, n}));
      return 0;
    });
}

TEST(Parallel, ACopyIsTheWhole) {
  with_threads(3, [] {
    std::vector<int> from(10'001), to(3);
    std::iota(from.begin(), from.end(), 0);
    parallel_copy(std::span<const int>(from), to);
    EXPECT_EQ(from, to);
    return 0;
  });
}

TEST(Parallel, LoopUsesSeveralThreads) {
  // Each body waits until a second thread has come, so that the test fails (after its deadline) if none does.
  std::atomic<std::thread::id> first{};
  std::atomic<bool> second{false};
  with_threads(2, [&] {
    parallel_for(64 * parallel_block, [&](std::size_t i) {
      if (i % parallel_block != 0 || second) return;
      std::thread::id nobody{};
      if (first.compare_exchange_strong(nobody, std::this_thread::get_id())) {
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
        while (!second && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
      } else if (first.load() != std::this_thread::get_id()) {
        second = true;
      }
    });
    return 0;
  });
  EXPECT_TRUE(second);
}

TEST(Parallel, WorkSideBySideIsDoneOnce) {
  for (const int threads : {1, 2, 5}) {
    const ThreadLimit limit(threads);
    std::vector<int> first(3 * parallel_block), second(2 * parallel_block);
    int third = 0;
    side_by_side({[&] { parallel_for(first.size(), [&](std::size_t i) { ++first[i]; }); },
                  [&] { parallel_for(second.size(), [&](std::size_t i) { ++second[i]; }); }, [&] { ++third; }});
    EXPECT_EQ(std::ranges::count(first, 1), std::ssize(first));
    EXPECT_EQ(std::ranges::count(second, 1), std::ssize(second));
    EXPECT_EQ(third, 1);
  }
}

TEST(Parallel, IdleThreadsAreSomeOfTheMachines) {
  EXPECT_GE(idle_threads(), 1);
  EXPECT_LE(idle_threads(), hardware_threads());
}

TEST(Parallel, AFailureBesideOtherWorkReachesTheCaller) {
  const ThreadLimit limit(2);
  EXPECT_THROW(side_by_side({[] { throw std::runtime_error("no"); }, [] {}}), std::runtime_error);
}

TEST(Behind, DoesAllInTheirOrder) {
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    std::vector<int> done;
    Behind behind(2);
    for (int k = 0; k < 9; ++k)
      behind.add([&done, k] {
        std::this_thread::sleep_for(std::chrono::microseconds(10 * (k % 3)));
        done.push_back(k);
      });
    behind.wait();
    EXPECT_EQ(done, (std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8})) << threads;
  }
}

TEST(Behind, IsDoneBesideLoops) {
  const ThreadLimit limit(2);
  std::vector<int> sums(100);
  Behind behind;
  for (int& sum : sums) {
    behind.add([&sum] { sum = 1; });
    std::vector<int> n(3'000);
    parallel_for(n.size(), [&](std::size_t i) { ++n[i]; });
    EXPECT_EQ(std::ranges::count(n, 1), std::ssize(n));
  }
  behind.wait();
  EXPECT_EQ(std::ranges::count(sums, 1), std::ssize(sums));
}

TEST(Behind, TellsAFailureOnceAndDropsWhatWaitedBehindIt) {
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    Behind behind;
    std::atomic<bool> may_fail = threads == 1;
    std::atomic<int> after = 0;
    const auto fail = [&] {
      while (!may_fail) std::this_thread::yield();
      throw std::runtime_error("full");
    };
    if (threads == 1) {
      EXPECT_THROW(behind.add(fail), std::runtime_error);
    } else {
      behind.add(fail);
      behind.add([&] { ++after; });
      may_fail = true;
      behind.settle();
      EXPECT_THROW(behind.add([&] { ++after; }), std::runtime_error);
    }
    EXPECT_EQ(after, 0);
    behind.add([&] { ++after; });
    behind.wait();
    EXPECT_EQ(after, 1) << threads;
  }
}

TEST(Parallel, AFailureInALoopReachesTheCaller) {
  const auto body = [](std::size_t i) {
    if (i == 3'000) throw std::runtime_error("3000");
  };
  EXPECT_THROW(parallel_for(5'000, body), std::runtime_error);
}

} // namespace
} // namespace matrigrate

namespace {

/// n points in the square of 100 um around the origin.
std::vector<Vec2> scattered(std::uint32_t n) {
  std::vector<Vec2> points;
  for (std::uint32_t k = 0; k < n; ++k)
    points.emplace_back(100.0 * std::sin(12.9 * k) * std::cos(0.3 * k), 100.0 * std::sin(7.7 * k + 1.0));
  return points;
}

} // namespace

TEST(PointsIn, AreThoseThatEachPointAloneWouldName) {
  for (const std::uint32_t n : {0U, 1U, 7U, 255U, 256U, 257U, 3000U}) {
    const std::vector<Vec2> points = scattered(n);
    const Box box{{-30.0, 10.0}, {25.0, 70.0}};
    std::vector<std::uint32_t> expected;
    for (std::uint32_t k = 0; k < n; ++k)
      if (points[k].x() >= -30.0 && points[k].x() <= 25.0 && points[k].y() >= 10.0 && points[k].y() <= 70.0)
        expected.push_back(k);
    EXPECT_EQ(points_in(box, points), expected) << n;
  }
}

TEST(PointsIn, TakeThoseOnTheEdgeAndNoneThatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 2.0}, {1.1, 1.0}, {nan, 1.0}, {0.5, nan}, {0.5, 2.0}};
  EXPECT_EQ(points_in({{0.0, 0.0}, {1.0, 2.0}}, points), (std::vector<std::uint32_t>{0, 1, 5}));
  EXPECT_EQ(points_in(unbounded_along_x({{0.0, 0.5}, {1.0, 1.5}}), points), (std::vector<std::uint32_t>{2}));
}

TEST(PointsIn, AroundAPointAreAllWithinReach) {
  const std::vector<Vec2> points = scattered(3000);
  for (const Vec2& centre : {Vec2(1e-9, 0.0), Vec2(37.1, -80.3)}) {
    const std::vector<std::uint32_t> found = points_in(around(centre, 5.2), points);
    for (std::uint32_t k = 0; k < points.size(); ++k)
      EXPECT_TRUE((points[k] - centre).norm() > 5.2 || std::ranges::binary_search(found, k));
  }
}

TEST(Marks, AreFoundOneAfterTheOther) {
  const std::vector<std::uint8_t> marks{0, 1, 0, 0, 1, 1, 0};
  EXPECT_EQ(next_marked(marks, 0), 1U);
  EXPECT_EQ(next_marked(marks, 2), 4U);
  EXPECT_EQ(next_marked(marks, 5), 5U);
  EXPECT_EQ(next_marked(marks, 6), 7U) << "none";
  EXPECT_EQ(next_marked(marks, 7), 7U);
}

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

namespace {

std::vector<std::pair<std::size_t, std::size_t>> stretches(const std::vector<std::uint8_t>& flags) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  each_unflagged_stretch(flags, [&](std::size_t begin, std::size_t end) { found.emplace_back(begin, end); });
  return found;
}

} // namespace

TEST(Stretches, AreThoseWithoutFlags) {
  using Found = std::vector<std::pair<std::size_t, std::size_t>>;
  EXPECT_EQ(stretches({1, 0, 0, 1, 1, 0}), (Found{{1, 3}, {5, 6}}));
  EXPECT_EQ(stretches({0, 0, 7, 0}), (Found{{0, 2}, {3, 4}}));
  EXPECT_EQ(stretches({0, 0}), (Found{{0, 2}}));
  EXPECT_TRUE(stretches({1, 1}).empty());
  EXPECT_TRUE(stretches({}).empty());
}

namespace matrigrate {
namespace {

TEST(TimeText, IsForPeople) {
  EXPECT_EQ(time_text(0.0), "0 s");
  EXPECT_EQ(time_text(36.0), "36 s");
  EXPECT_EQ(time_text(90.0), "1 min 30 s");
  EXPECT_EQ(time_text(1800.0), "30 min");
  EXPECT_EQ(time_text(7200.0), "2 h");
  EXPECT_EQ(time_text(9000.0000001), "2 h 30 min");
}

TEST(WallTimeText, HasOneUnit) {
  EXPECT_EQ(wall_time_text(89.0), "89 s");
  EXPECT_EQ(wall_time_text(5340.0), "89 min");
  EXPECT_EQ(wall_time_text(5400.0), "1.5 h");
}

} // namespace
} // namespace matrigrate
