#include "apps/export_pictures.hpp"
#include "apps/finished_run.hpp"
#include "apps/terminal.hpp"
#include "apps/verbs.hpp"
#include "base/failure.hpp"
#include "base/file.hpp"
#include "io/track_files.hpp"
#include "io/vtk_files.hpp"

#include <fmt/format.h>

#include <memory>

namespace matrigrate::apps {

namespace {

struct Options {
  std::string folder;
  std::string output;
  std::string layer = "displacement";
  bool vtk = false, tracks = false, svg = false, png = false, movie = false;
  bool force = false;
};

void require_frames(const FinishedRun& run, const std::string& folder) {
  if (run.film.frames.empty())
    throw InputOutputError(fmt::format("{}: holds no frames; output.field_interval was 0", folder));
}

void export_tracks(const FinishedRun& run, const std::filesystem::path& to) {
  write_file(to / "tracks_celltrackr.csv", io::celltrackr_csv(run.memory.rows));
  write_file(to / "tracks_trackmate.csv", io::trackmate_csv(run.memory.rows));
  write_file(to / "tracks_trackmate.xml", io::trackmate_xml(run.memory.rows));
}

int export_run(const Options& options) {
  if (!(options.vtk || options.tracks || options.svg || options.png || options.movie))
    throw UsageError("say what to export: --vtk, --tracks, --svg, --png or --movie");
  const Layer layer = layer_of(options.layer);
  const FinishedRun run = read_run(options.folder);
  if (options.vtk || options.png || options.movie) require_frames(run, options.folder);
  if (options.png || options.movie) {
    require_layer(run, layer);
    require_tools(options.movie);
  }
  const std::filesystem::path to =
      options.output.empty() ? std::filesystem::path(options.folder) / "export" : std::filesystem::path(options.output);
  make_output_folder(to, options.force);
  if (options.vtk) io::write_vtk(to, run.film);
  if (options.tracks) export_tracks(run, to);
  if (options.svg) export_svg(run, to);
  if (options.png || options.movie) export_film(run, layer, to, options.movie);
  print(fmt::format("exported to {}\n", to.string()));
  return done;
}

} // namespace

void add_export(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("export", "Write a run in other formats: VTK, tracks, pictures, a movie");
  verb->footer("fields.h5 with fields.xdmf opens in ParaView as it is; --vtk is for programs that read neither.\n"
               "celltrackR: read.tracks.csv(\"tracks_celltrackr.csv\", sep = \",\", pos.columns = 3:4).\n"
               "--png and --movie call rsvg-convert and ffmpeg, which have to be installed.");
  const auto options = std::make_shared<Options>();
  verb->add_option("DIR", options->folder, "Folder of a run")->required();
  verb->add_flag("--vtk", options->vtk, "A .vtp file a frame of matrix and outline, and .pvd files with their times");
  verb->add_flag("--tracks", options->tracks, "The path for celltrackR (CSV) and TrackMate (CSV, XML)");
  verb->add_flag("--svg", options->svg, "The contact sheet and the path, for a publication");
  verb->add_flag("--png", options->png, "A picture a frame");
  verb->add_flag("--movie", options->movie, "movie.mp4 of these pictures");
  verb->add_option("--layer", options->layer,
                   "Of --png and --movie: displacement, von_mises, pressure or fibre_von_mises");
  verb->add_option("-o,--output", options->output, "Folder to write into (default: DIR/export)");
  verb->add_flag("--force", options->force, "Write into a folder that is not empty");
  verb->callback([options, &chosen] { chosen = [options] { return export_run(*options); }; });
}

} // namespace matrigrate::apps
