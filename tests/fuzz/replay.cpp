#include "target.hpp"

#include "base/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using matrigrate::Purpose;
using matrigrate::uniform;

constexpr std::uint64_t seed = 1;

std::size_t below(std::size_t n, std::uint64_t step, std::uint32_t what) {
  return std::min(n - 1, static_cast<std::size_t>(uniform(seed, Purpose::test, step, what) * static_cast<double>(n)));
}

/// One of the corpus with a few bytes changed, left out, doubled, or put together with another one.
std::string variation(const std::vector<std::string>& corpus, std::uint64_t step) {
  std::string text = corpus[below(corpus.size(), step, 0)];
  const std::size_t changes = 1 + below(6, step, 1);
  for (std::uint32_t c = 0; c < changes; ++c) {
    const std::uint32_t what = 10 * (c + 1);
    const std::size_t at = below(text.size() + 1, step, what);
    switch (below(5, step, what + 1)) {
    case 0:
      text.insert(at, 1, static_cast<char>(below(256, step, what + 2)));
      break;
    case 1:
      text.erase(at, 1 + below(8, step, what + 2));
      break;
    case 2:
      text.insert(at, text.substr(at, 1 + below(40, step, what + 2)));
      break;
    case 3:
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8, step, what + 2)));
      break;
    default: {
      const std::string& other = corpus[below(corpus.size(), step, what + 2)];
      text.insert(at, other, below(other.size() + 1, step, what + 3), 1 + below(80, step, what + 4));
    }
    }
  }
  return text;
}

} // namespace

/// Runs a target over its corpus and over variations of it, the same ones every time; for builds without a fuzzer.
/// Arguments: folder of the corpus, number of variations.
int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<std::string> corpus;
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    corpus.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  if (corpus.empty()) return EXIT_FAILURE;
  const auto run = [](const std::string& text) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
  };
  for (const std::string& text : corpus) run(text);
  const std::uint64_t variations = std::strtoull(argv[2], nullptr, 10);
  for (std::uint64_t step = 0; step < variations; ++step) run(variation(corpus, step));
  fmt::print("{} inputs and {} variations of them\n", corpus.size(), variations);
  return EXIT_SUCCESS;
}
