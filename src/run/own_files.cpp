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

/// The folders that a run writes into, within its own.
constexpr std::string_view exports = "export";
constexpr std::array<std::string_view, 4> places{"", "checkpoints", "snapshots", exports};

constexpr std::array<ExportKind, 7> kinds{{
    {"--vtk", R"((matrix|outline|anchors)(\.pvd|_[0-9]{4,}\.vtp))"},
    {"--fields", R"(fields\.(h5|xdmf))"},
    {"--tracks", R"(tracks_(celltrackr\.csv|trackmate\.(csv|xml)))"},
    {"--svg", R"((contact_sheet|path)\.svg)"},
    {"--png", R"(frame_[0-9]{4,}\.(svg|png))"},
    {"--movie", R"(movie\.mp4)"},
    {"--panel", R"(panel\.svg)"},
}};

/// Tells whether a name is one of a list.
class Names {
public:
  explicit Names(std::string_view names) { add(names); }

  /// Those of a run's files in one of its places.
  static Names of_place(std::string_view place) {
    Names all;
    for (const OutputKind& kind : output_kinds())
      if (kind.folder == place) all.add(kind.names);
    if (place == exports)
      for (const ExportKind& kind : kinds) all.add(kind.names);
    return all;
  }
  bool have(const std::string& name) const {
    return std::ranges::any_of(m_patterns, [&](const std::regex& one) { return std::regex_match(name, one); });
  }

private:
  Names() = default;
  void add(std::string_view names) { m_patterns.emplace_back(names.begin(), names.end()); }

  std::vector<std::regex> m_patterns;
};

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
  const Names names(kind.names);
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : entries(folder))
    if (!is_folder(entry) && names.have(name_of(entry))) files.push_back(entry.path());
  return files;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw InputOutputError(fmt::format("{}: cannot be removed: {}", file.string(), error.message()));
}

void require_no_links(const fs::path& folder) {
  for (const std::string_view place : places) {
    const fs::path in = folder / place;
    std::error_code error;
    if (!place.empty() && place != exports && fs::is_symlink(fs::symlink_status(in, error)))
      throw InputOutputError(fmt::format(
          "{}: is a symbolic link, and a run writes only into its own folder; remove the link first", in.string()));
  }
}

void remove_run_files(const fs::path& folder) {
  for (const std::string_view place : places) { // the last checkpoints are the first names in the first place
    const fs::path in = folder / place;
    if (fs::is_symlink(fs::symlink_status(in))) continue; // not made by a run
    const Names own = Names::of_place(place);
    for (const fs::directory_entry& entry : entries(in))
      if (!is_folder(entry) && own.have(name_of(entry))) remove_file(entry.path());
    std::error_code ignored;
    if (!place.empty()) fs::remove(in, ignored); // if nothing else is in it
  }
}

std::vector<std::string> foreign_entries(const fs::path& folder) {
  std::vector<std::string> foreign;
  for (const std::string_view place : places) {
    const Names own = Names::of_place(place);
    for (const fs::directory_entry& entry : entries(folder / place)) {
      const std::string name = name_of(entry);
      const bool is_place = std::ranges::find(places, name) != places.end();
      const bool known = is_folder(entry) ? place.empty() && is_place : own.have(name);
      if (!name.starts_with('.') && !known) foreign.push_back((fs::path(place) / name).string());
    }
  }
  return foreign;
}

void remove_temporaries(const fs::path& folder) {
  for (const std::string_view place : places) {
    if (place == exports) continue; // exports are written without a lock
    const Names own = Names::of_place(place);
    for (const fs::directory_entry& entry : entries(folder / place)) {
      const std::optional<std::string> file = file_of_temporary(name_of(entry));
      const bool unfinished = name_of(entry) == "checkpoint_next.h5"; // killed before it was renamed
      std::error_code ignored;
      if (!is_folder(entry) && (unfinished || (file && own.have(*file)))) fs::remove(entry.path(), ignored);
    }
  }
}

} // namespace matrigrate::run
