#include "run/provenance.hpp"

#include "base/parallel.hpp"
#include "base/platform.hpp"
#include "parameters/version.hpp"

#include <nlohmann/json.hpp>

#include <build_info.hpp>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <fmt/format.h>
#include <xxhash.h>

#include <boost/version.hpp>
#include <toml++/toml.h>

#include <array>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace matrigrate::run {

namespace {

using Json = nlohmann::ordered_json;

static_assert(this_version == build_info::version,
              "the version stands in CMakeLists.txt and in parameters/version.hpp");

std::string joined(int major, int minor, int patch) { return fmt::format("{}.{}.{}", major, minor, patch); }

Json libraries() {
  return {
      {"Boost", joined(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"CLI11", CLI11_VERSION},
      {"Eigen", joined(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt", joined(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann-json", joined(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"oneTBB", threading_version()},
      {"toml++", joined(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"xxHash",
       joined(static_cast<int>(XXH_versionNumber() / 10000), static_cast<int>(XXH_versionNumber() / 100 % 100),
              static_cast<int>(XXH_versionNumber() % 100))}};
}

std::string cpu_model() {
  const std::string model = platform::processor("model name");
  return model.empty() ? "unknown" : model;
}

/// Instruction sets that hot loops may use, by their names in /proc/cpuinfo.
std::vector<std::string> simd_features() {
  constexpr auto known = std::to_array<std::pair<std::string_view, std::string_view>>({{"sse2", "sse2"},
                                                                                       {"sse4_2", "sse4.2"},
                                                                                       {"avx", "avx"},
                                                                                       {"fma", "fma"},
                                                                                       {"avx2", "avx2"},
                                                                                       {"avx512f", "avx512f"},
                                                                                       {"asimd", "neon"}});
  std::istringstream words(platform::processor("flags") + ' ' + platform::processor("Features")); // of x86 and of Arm
  const std::set<std::string> has{std::istream_iterator<std::string>(words), {}};
  std::vector<std::string> found;
  for (const auto& [word, name] : known)
    if (has.contains(std::string(word))) found.emplace_back(name);
  return found;
}

} // namespace

std::string version_text() {
  return fmt::format("{} ({}{})", build_info::version, std::string_view(build_info::git_hash).substr(0, 8),
                     build_info::git_dirty ? ", changed sources" : "");
}

std::string version_line() { return "matrigrate " + version_text(); }

Json provenance() {
  return {
      {"version", build_info::version},
      {"git_hash", build_info::git_hash},
      {"git_dirty", build_info::git_dirty},
      {"compiler", build_info::compiler},
      {"flags", build_info::flags},
      {"build_type", build_info::build_type},
      {"sanitizers", build_info::sanitizers},
      {"libraries", libraries()},
      {"cpu", {{"model", cpu_model()}, {"threads", std::thread::hardware_concurrency()}, {"simd", simd_features()}}}};
}

std::string provenance_text() {
  std::string text = version_line() + "\n";
  const auto add = [&text](std::string_view name, std::string_view value) {
    text += fmt::format("{:<15}{}\n", name, value);
  };
  add("commit", fmt::format("{}{}", build_info::git_hash, build_info::git_dirty ? ", with changed sources" : ""));
  add("compiler", build_info::compiler);
  add("build", fmt::format("{}: {}", build_info::build_type, build_info::flags));
  if (*build_info::sanitizers != '\0') add("sanitizers", build_info::sanitizers);
  const Json versions = libraries();
  for (const auto& [name, version] : versions.items()) add(name, version.get<std::string>());
  add("CPU", cpu_model());
  add("SIMD", fmt::format("{}", fmt::join(simd_features(), " ")));
  add("threads", fmt::format("{}", std::thread::hardware_concurrency()));
  return text;
}

} // namespace matrigrate::run
