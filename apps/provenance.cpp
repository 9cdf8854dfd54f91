#include "apps/provenance.hpp"

#include <build_info.hpp>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <boost/version.hpp>
#include <fmt/format.h>
#include <tbb/version.h>
#include <toml++/toml.h>
#include <xxhash.h>

#include <fstream>
#include <thread>
#include <vector>

namespace matrigrate::apps {

namespace {

using Json = nlohmann::ordered_json;

std::string joined(int major, int minor, int patch) { return fmt::format("{}.{}.{}", major, minor, patch); }

Json libraries() {
  return {
      {"Boost", joined(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)},
      {"CLI11", CLI11_VERSION},
      {"Eigen", joined(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"fmt", joined(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann-json", joined(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)},
      {"oneTBB", TBB_runtime_version()},
      {"toml++", joined(TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH)},
      {"xxHash",
       joined(static_cast<int>(XXH_versionNumber() / 10000), static_cast<int>(XXH_versionNumber() / 100 % 100),
              static_cast<int>(XXH_versionNumber() % 100))}};
}

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

std::vector<std::string> simd_features() {
  std::vector<std::string> found;
#if defined(__x86_64__)
  __builtin_cpu_init();
  const auto add = [&](const char* name, bool supported) {
    if (supported) found.emplace_back(name);
  };
  add("sse2", __builtin_cpu_supports("sse2") != 0);
  add("sse4.2", __builtin_cpu_supports("sse4.2") != 0);
  add("avx", __builtin_cpu_supports("avx") != 0);
  add("fma", __builtin_cpu_supports("fma") != 0);
  add("avx2", __builtin_cpu_supports("avx2") != 0);
  add("avx512f", __builtin_cpu_supports("avx512f") != 0);
#elif defined(__aarch64__)
  found.emplace_back("neon"); // part of the architecture
#endif
  return found;
}

} // namespace

std::string version_text() {
  return fmt::format("{} ({}{})", build_info::version, std::string_view(build_info::git_hash).substr(0, 8),
                     build_info::git_dirty ? "+" : "");
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
  add("commit", fmt::format("{}{}", build_info::git_hash, build_info::git_dirty ? ", with changes not committed" : ""));
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

} // namespace matrigrate::apps
