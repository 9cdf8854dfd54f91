#include "run/own_files.hpp"

#include "base/failure.hpp"
#include "base/file.hpp"
#include "run/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <system_error>
#include <utility>

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

using Patterns = std::vector<std::regex>;

std::regex pattern(std::string_view names) { return std::regex(names.begin(), names.end()); }

/// The folders that a run writes into, within its own, with the names of its files there; first that one itself.
const std::vector<std::pair<std::string_view, Patterns>>& places() {
  static const auto all = [] {
    std::vector<std::pair<std::string_view, Patterns>> found;
    const auto add = [&](std::string_view place, std::string_view names) {
      auto at = std::ranges::find(found, place, [](const auto& one) { return one.first; });
      if (at == found.end()) at = found.insert(at, {place, {}});
      at->second.push_back(pattern(names));
    };
    for (const OutputKind& kind : output_kinds()) add(kind.folder, kind.names);
    for (const ExportKind& kind : kinds) add(exports, kind.names);
    add(exports, earlier_exports);
    return found;
  }();
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
  for (const auto& [place, own] : places()) {
    const fs::path in = folder / place;
    std::error_code error;
    if (!place.empty() && place != exports && fs::is_symlink(fs::symlink_status(in, error)))
      throw InputOutputError(fmt::format(
          "{}: is a symbolic link, and a run writes only into its own folder; remove the link first", in.string()));
  }
}

void remove_run_files(const fs::path& folder) {
  for (const auto& [place, own] : places()) { // the last checkpoints are the first names in the first place
    const fs::path in = folder / place;
    if (fs::is_symlink(fs::symlink_status(in))) continue; // not made by a run
    for (const fs::directory_entry& entry : entries(in))
      if (!is_folder(entry) && have(own, name_of(entry))) remove_file(entry.path());
    std::error_code ignored;
    if (!place.empty()) fs::remove(in, ignored); // if nothing else is in it
  }
}

std::vector<std::string> foreign_entries(const fs::path& folder) {
  std::vector<std::string> foreign;
  for (const auto& [place, own] : places()) {
    for (const fs::directory_entry& entry : entries(folder / place)) {
      const std::string name = name_of(entry);
      const bool is_place = std::ranges::any_of(places(), [&](const auto& one) { return one.first == name; });
      const bool known = is_folder(entry) ? place.empty() && is_place : have(own, name);
      if (!name.starts_with('.') && !known) foreign.push_back((fs::path(place) / name).string());
    }
  }
  return foreign;
}

void remove_temporaries(const fs::path& folder) {
  for (const auto& [place, own] : places()) {
    if (place == exports) continue; // exports are written without a lock
    for (const fs::directory_entry& entry : entries(folder / place)) {
      const std::optional<std::string> file = file_of_temporary(name_of(entry));
      const bool unfinished = name_of(entry) == "checkpoint_next.h5"; // killed before it was renamed
      std::error_code ignored;
      if (!is_folder(entry) && (unfinished || (file && have(own, *file)))) fs::remove(entry.path(), ignored);
    }
  }
}

} // namespace matrigrate::run
