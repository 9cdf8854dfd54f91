#pragma once

#include "apps/run_record.hpp"
#include "parameters/parameters.hpp"
#include "state/state.hpp"
#include "store/run_memory.hpp"

#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

/// What the verbs run and resume have in common. Test: tests/apps/run_test.cpp, tests/apps/resume_test.cpp
namespace matrigrate::apps {

/// Where a branch leaves its run: up to then the run's own parameters hold.
struct Before {
  Parameters p;
  double until; ///< [s]
};

/// Where a simulation begins, and what has been written of it already.
struct Beginning {
  State s;
  Parameters p;
  io::RunMemory memory{};         ///< empty: a new run
  std::optional<Before> before{}; ///< of a branch
  std::vector<nlohmann::ordered_json> lineage{};
  std::filesystem::path frames_from{};              ///< the folder whose frames a branch takes over
  std::string scenario{};                           ///< its name; empty: that of the command line
  std::vector<std::vector<std::string>> commands{}; ///< that started it, oldest first; none: the command line
  double earlier_wall_time = 0.0;                   ///< of the runs that this one goes on with [s]
};

/// How it is carried out.
struct Manner {
  std::filesystem::path folder; ///< exists
  bool json = false;
  bool quiet = false;
  double wall_time_limit = std::numeric_limits<double>::infinity(); ///< [s]
  std::vector<std::string> command_line;
};

/// Marches to the end, a signal, the limit of wall time or a failure, writes the files of the run and says how it
/// ended.
/// @return the exit code
/// @throws InputOutputError naming what could not be written, and what is safe
int simulate(Beginning beginning, const Manner& manner);

/// Parses "90 s", "2 h", ... @throws UsageError
double wall_time_of(const std::string& text);

} // namespace matrigrate::apps
