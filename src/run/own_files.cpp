#include "run/own_files.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "run/output/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <system_error>

namespace matrigrate::run {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view exports = "export";
constexpr std::string_view earlier_exports = ///< that earlier versions wrote there
    R"((contact_sheet|path)\.svg|(matrix|outline|anchors)(\.pvd|_[0-9]{4,}\.vtp))";

constexpr std::array<ExportKind, 8> kinds{{
    {"--fields", R"(fields\.(h5|xdmf))"},
    {"--tracks", R"(tracks_(celltrackr\.csv|trackmate\.(csv|xml)))"},
    {"--openvt", R"(openvt(\.csv|\.json|_simulator\.json))"},
    {"--simularium", R"(run\.simularium)"},
    {"--ome-tiff", R"(fields\.ome\.tif)"},
    {"--png", R"(frame_[0-9]{4,}\.(svg|png))"},
    {"--movie", R"(movie\.mp4)"},
    {"--panel", R"(panel\.svg)"},
}};

/// The folders that a run writes into, within its own; first that one itself.
std::vector<std::string_view> places() {
  std::vector<std::string_view> all;
  for (const OutputKind& kind : output_kinds())
    if (std::ranges::find(all, kind.folder) == all.end()) all.push_back(kind.folder);
  all.push_back(exports);
  return all;
}

using Patterns = std::vector<std::regex>;

std::regex pattern(std::string_view names) { return std::regex(names.begin(), names.end()); }

/// The names of a run's files in one of these folders.
Patterns names_in(std::string_view place) {
  Patterns all;
  for (const OutputKind& kind : output_kinds())
    if (kind.folder == place) all.push_back(pattern(kind.names));
  if (place != exports) return all;
  for (const ExportKind& kind : kinds) all.push_back(pattern(kind.names));
  all.push_back(pattern(earlier_exports));
  return all;
}

bool have(const Patterns& names, const std::string& name) {
  return std::ranges::any_of(names, [&](const std::regex& one) { return std::regex_match(name, one); });
}

/// The entries of a folder, sorted; none if it is not there.
std::vector<fs::directory_entry> entries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::directory_entry> all;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator(); it.increment(error))
    all.push_back(*it);
  if (error && error != std::errc::no_such_file_or_directory)
    throw InputOutputError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
  std::ranges::sort(all);
  return all;
}

bool is_folder(const fs::directory_entry& entry) { return fs::is_directory(entry.symlink_status()); }

std::string name_of(const fs::directory_entry& entry) { return entry.path().filename().string(); }

} // namespace

std::span<const ExportKind> export_kinds() { return kinds; }

std::vector<fs::path> files_of(const ExportKind& kind, const fs::path& folder) {
  const Patterns names{pattern(kind.names)};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries(folder))
    if (!is_folder(entry) && have(names, name_of(entry))) files.push_back(entry.path());
  return files;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file, error))) return; // a read-only system refuses to remove it all the same
  error.clear();
  fs::remove(file, error);
  if (error) throw InputOutputError(fmt::format("{}: cannot be removed: {}", file.string(), error.message()));
}

void require_no_links(const fs::path& folder) {
  for (const std::string_view place : places()) {
    const fs::path in = folder / place;
    std::error_code error;
    if (!place.empty() && place != exports && fs::is_symlink(fs::symlink_status(in, error)))
      throw InputOutputError(fmt::format(
          "{}: is a symbolic link, and a run writes only into its own folder; remove the link first", in.string()));
  }
}

void remove_run_files(const fs::path& folder) {
  for (const std::string_view place : places()) { // the last checkpoints are the first names in the first place
    const fs::path in = folder / place;
    if (fs::is_symlink(fs::symlink_status(in))) continue; // not made by a run
    const Patterns own = names_in(place);
    for (const fs::directory_entry& entry : entries(in))
      if (!is_folder(entry) && have(own, name_of(entry))) remove_file(entry.path());
    std::error_code ignored;
    if (!place.empty()) fs::remove(in, ignored); // if nothing else is in it
  }
}

std::vector<std::string> foreign_entries(const fs::path& folder) {
  std::vector<std::string> foreign;
  const std::vector<std::string_view> all = places();
  for (const std::string_view place : all) {
    const Patterns own = names_in(place);
    for (const fs::directory_entry& entry : entries(folder / place)) {
      const std::string name = name_of(entry);
      const bool is_place = std::ranges::find(all, name) != all.end();
      const bool known = is_folder(entry) ? place.empty() && is_place : have(own, name);
      if (!name.starts_with('.') && !known) foreign.push_back((fs::path(place) / name).string());
    }
  }
  return foreign;
}

void remove_temporaries(const fs::path& folder) {
  for (const std::string_view place : places()) {
    if (place == exports) continue; // exports are written without a lock
    const Patterns own = names_in(place);
    for (const fs::directory_entry& entry : entries(folder / place)) {
      const std::optional<std::string> file = file_of_temporary(name_of(entry));
      const bool unfinished = name_of(entry) == "checkpoint_next.h5"; // killed before it was renamed
      std::error_code ignored;
      if (!is_folder(entry) && (unfinished || (file && have(own, *file)))) fs::remove(entry.path(), ignored);
    }
  }
}

} // namespace matrigrate::run
