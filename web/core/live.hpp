#pragma once

#include "observe/frame.hpp"
#include "observe/tracks.hpp"
#include "parameters/parameters.hpp"
#include "run/cadence.hpp"
#include "simulation/simulation.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// A simulation that a page follows, with the rows of its tracks; its state can be kept and taken up again. Test:
/// web/tests/core.mjs
namespace matrigrate::live {

class Followed {
public:
  /// From the beginning.
  explicit Followed(const Parameters& p);
  /// From a state kept by image(), with the parameters that it then had.
  /// @throws std::invalid_argument if the bytes are no such state, or one of another size
  Followed(const Parameters& p, std::string_view image);

  /// Advances until t_end [s], run.duration, or `enough`, which is asked after each step.
  /// @throws NumericalFailure
  void march(double t_end, const std::function<bool()>& enough);

  /// Advances to the next multiple of run.time_step, where a branch of the program can begin, and goes on with other
  /// parameters from there.
  /// @param overrides  "key=value"
  /// @throws ConfigurationError naming what cannot change, or is wrong; nothing has happened then
  /// @throws NumericalFailure
  void change(const std::vector<std::string>& overrides);

  /// True if run.duration is reached.
  bool done() const;

  const State& state() const { return m_simulation.s; }
  const Parameters& parameters() const { return m_simulation.p; }
  observe::Frame frame() const { return observe::frame(m_simulation.s, m_simulation.p, m_simulation.w); }

  /// Rows at the multiples of output.track_interval that were passed since the last call.
  std::vector<TrackRow> take_tracks();

  /// All of the state, to be read by this build of the program alone.
  std::string image() const;

private:
  void keep_track();

  Simulation m_simulation;
  std::vector<TrackRow> m_tracks;
  run::Cadence m_rows; ///< of the tracks
};

} // namespace matrigrate::live
