#include "study/cell_tracks.hpp"

#include "base/file.hpp"
#include "store/csv.hpp"
#include "store/naming.hpp"

#include <algorithm>

namespace matrigrate::study {

std::vector<CellTrack> cell_tracks(const std::filesystem::path& run_folder) {
  const std::filesystem::path file = run_folder / "tracks.csv";
  const std::string table = read_file(file, std::size_t{1} << 28);
  const std::vector<double> cell = store::csv_column(table, "track");
  const auto columns = store::naming(file, [&] { return store::csv_columns(table, {"t_s", "x_um", "y_um"}); });
  const std::vector<double>&t = columns[0], &x = columns[1], &y = columns[2];
  std::vector<CellTrack> tracks;
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double number = cell.empty() ? 1.0 : cell[i];
    auto own = std::ranges::find(tracks, number, &CellTrack::cell);
    if (own == tracks.end()) own = tracks.insert(own, CellTrack{.cell = number, .t = {}, .x = {}, .y = {}});
    own->t.push_back(t[i]);
    own->x.push_back(x[i]);
    own->y.push_back(y[i]);
  }
  return tracks;
}

} // namespace matrigrate::study
