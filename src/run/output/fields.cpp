#include "run/output/output.hpp"
#include "run/run_record.hpp"
#include "state/dof.hpp"
#include "store/field_file.hpp"
#include "store/frame_log.hpp"
#include "store/saved_frames.hpp"
#include "store/trajectory_hash.hpp"

namespace matrigrate::run {

/// The frames: the log fields.part, begun with those of the past that a folder still holds, and at the end fields.h5
/// and fields.xdmf.
Output fields(RunSoFar& run, const State& start) {
  if (run.p.output.field_interval <= 0.0) return {};
  const store::FrameShape shape{.head = observe::frame_head(start, run.p),
                                .outline = cortex_particles(start),
                                .fibres = run.p.fibres.arrangement != FibreArrangement::none};
  std::string text = store::log_head(shape.head);
  if (!run.memory.frames.empty())
    for (const auto& [t, frame] : store::saved_frames(run.frames_from, shape, run.memory.frames)) {
      text += frame;
      run.frame_times.push_back(t);
    }
  const auto log = std::make_shared<store::FrameLog>(run.folder / store::frame_log_name, text);
  Output output{.interval = run.p.output.field_interval};
  output.write = [=, &run](const State& s, const Workspace& w) {
    if (!run.frame_times.empty() && run.frame_times.back() == s.t) return;
    observe::Frame frame = observe::frame(s, run.now, w);
    store::follow(frame, shape); // a branch that has not begun yet has the fibres of its run
    run.behind.add([log, frame = std::move(frame)] { log->add(frame); });
    run.frame_times.push_back(s.t);
    if (run.memory.frames.empty() || run.memory.frames.back() < s.t) run.memory.frames.push_back(s.t);
  };
  output.flush = [=] { log->flush(); };
  output.finish = [&run](const RunFinish&) {
    const std::string hash = store::TrajectoryHash(run.memory.trajectory).text();
    store::write_field_files(run.folder, run.frame_times.size(), field_origin(run.p, hash));
  };
  output.remove_what_resuming_needs = [&run] {
    std::error_code error;
    std::filesystem::remove(run.folder / store::frame_log_name, error); // one that stays does no harm
  };
  return output;
}

} // namespace matrigrate::run
