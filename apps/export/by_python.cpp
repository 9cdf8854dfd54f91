#include "apps/export/exports.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "base/platform.hpp"
#include "run/provenance.hpp"
#include "run/run_record.hpp"
#include "store/field_file.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace matrigrate::apps {

namespace {

namespace fs = std::filesystem;

/// Where the package lies beside this program: in a clone, in the package itself, in an installed tree; empty if it
/// does not.
std::string package_place() {
  std::error_code error;
  const fs::path folder = fs::canonical(platform::this_program(), error).parent_path();
  for (const char* way :
       {"../../../python", "../..", "../lib/python3/dist-packages", "../../lib/python3/dist-packages"})
    if (fs::exists(folder / way / "matrigrate" / "exchange.py", error))
      return (folder / way).lexically_normal().string();
  return {};
}

} // namespace

std::string python_for(const PythonKinds& kinds) {
  if (!kinds.any()) return {};
  if (const std::string place = package_place(); !place.empty()) {
    const char* given = std::getenv("PYTHONPATH");
    const std::string known = given != nullptr && *given != '\0' ? std::string(":") + given : std::string();
    ::setenv("PYTHONPATH", (place + known).c_str(), 1);
  }
  const char* named = std::getenv("PYTHON");
  const std::vector<std::string> candidates = named != nullptr && *named != '\0'
                                                  ? std::vector<std::string>{named}
                                                  : std::vector<std::string>{"python3", "/usr/bin/python3"};
  const std::string needed = fmt::format("import matrigrate.exchange, h5py{}", kinds.ome_tiff ? ", tifffile" : "");
  for (const std::string& python : candidates)
    if (exit_code_of({python, "-P", "-B", "-c", needed}, "/dev/null") == 0) return python;
  throw InputOutputError(fmt::format(
      "{0} by Python, which needs the package matrigrate and its libraries; Debian: apt-get install "
      "python3-pandas python3-h5py python3-xxhash{1}; PYTHON names another Python",
      kinds.ome_tiff ? "--ome-tiff is made" : "--simularium is made", kinds.ome_tiff ? " python3-tifffile" : ""));
}

void export_by_python(const run::FinishedRun& run, const PythonKinds& kinds, const std::string& python,
                      const std::string& title, const std::filesystem::path& folder) {
  if (!kinds.any()) return;
  const Scratch scratch(folder);
  store::write_field_files(scratch.path, run.film, run::field_origin(run.p, {}));
  constexpr const char* script = "import sys; from matrigrate import exchange; sys.exit(exchange.main(sys.argv[1:]))";
  const std::string made = (scratch.path / "made").string();
  std::vector<std::string> command{python, "-P", "-B", "-c", script}; // -P: nothing from the working directory
  command.insert(command.end(), {fmt::format("--fields={}", (scratch.path / "fields.h5").string()),
                                 fmt::format("--title={}", title), fmt::format("--program={}", run::version_text())});
  if (kinds.pixel) command.push_back(fmt::format("--pixel={}", *kinds.pixel));
  if (kinds.ome_tiff) command.push_back(fmt::format("--ome-tiff={}/fields.ome.tif", made));
  if (kinds.simularium) command.push_back(fmt::format("--simularium={}/run.simularium", made));
  command.insert(command.end(), {"--", run.folder.string()});
  call(command, scratch);
  move_made(scratch, folder);
}

} // namespace matrigrate::apps
