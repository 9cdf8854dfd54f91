#include "base/file.hpp"
#include "draw/cell_picture.hpp"
#include "draw/layer_picture.hpp"
#include "run/output/output.hpp"

namespace matrigrate::run {

/// Pictures of the cell and of layers of the matrix; at the end the contact sheet, and where the run failed that
/// moment.
Output snapshots(RunSoFar& run, const State&) {
  Output output{.interval = run.p.output.pictures ? run.p.output.snapshot_interval : 0.0, .when_stopped = false};
  if (run.p.output.pictures) {
    make_output_folder(run.folder / "snapshots", true);
    output.write = [&run](const State& s, const Workspace& w) {
      if (!run.memory.scenes.empty() && run.memory.scenes.back().t == s.t) return;
      observe::CellScene scene = observe::cell_scene(s, run.p, observe::paths_so_far(s, run.memory.rows));
      const std::string file = (run.folder / "snapshots" / time_name(s.t)).string();
      write_file(file + ".svg", draw::cell_picture(scene, observe::whole_disc(scene)));
      if (run.p.output.displacement_layer) write_file(file + "_displacement.svg", draw::displacement_picture(s, run.p));
      if (run.p.output.fibre_stress_layer && !w.fibres.empty())
        write_file(file + "_fibre_stress.svg", draw::fibre_stress_picture(s, run.p, w.fibres));
      scene.matrix.front() = {}; // the contact sheet draws the intact matrix as one area
      run.memory.scenes.push_back(std::move(scene));
    };
  }
  output.finish = [&run](const RunFinish& end) {
    if (run.p.output.pictures) write_file(run.folder / "snapshots.svg", draw::contact_sheet(run.memory.scenes));
    if (!end.failed) return;
    const observe::CellScene scene = observe::cell_scene(end.s, run.p, {});
    write_file(run.folder / "failure.svg",
               draw::cell_picture(scene, observe::surroundings(std::span(&scene, 1), 15.0)));
  };
  return output;
}

} // namespace matrigrate::run
