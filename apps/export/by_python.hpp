#pragma once

#include "run/finished_run.hpp"

#include <filesystem>
#include <optional>
#include <string>

/// Exports that the Python package makes (python/matrigrate/exchange.py).
namespace matrigrate::apps {

struct PythonKinds {
  bool ome_tiff = false, simularium = false;
  std::optional<double> pixel; ///< width of a pixel of the stack [um]; none: the spacing of the particles
  bool any() const { return ome_tiff || simularium; }
};

/// A Python that can make these kinds: $PYTHON, or the first of python3 and /usr/bin/python3 that has what they need;
/// empty if no kind is wanted.
/// @throws InputOutputError naming the Debian packages that are missing
std::string python_for(const PythonKinds& kinds);

/// Writes fields.ome.tif, run.simularium.
/// @param python  as python_for() found it
/// @throws InputOutputError with what Python says, if it fails
void export_by_python(const run::FinishedRun& run, const PythonKinds& kinds, const std::string& python,
                      const std::string& title, const std::filesystem::path& folder);

} // namespace matrigrate::apps
