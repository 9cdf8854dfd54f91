#pragma once

#include "observe/frame.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>

/// The whole frames of a run, for its resumption, reports and exports; and the frames that are lost.
/// Test: tests/unit/store/frames_test.cpp
namespace matrigrate::store {

/// Frames as they stand in a log, by their times [s].
using SavedFrames = std::map<double, std::string>;

/// What the frames of a run have in common.
struct FrameShape {
  observe::FrameHead head;
  std::size_t outline = 0; ///< particles of the cortex
  bool fibres = false;     ///< whether the matrix has fibres
};

/// Gives a frame the layers of a shape. Branches turn fibres on and off: where there were none yet their stress is 0,
/// and where there are none any more it is left out.
void follow(observe::Frame& frame, const FrameShape& shape);

/// The frames of given times that a folder still holds whole, in its log or else in its field file. Files that are
/// missing or damaged, and frames of another shape, are passed over.
/// @param times  in ascending order [s]
SavedFrames saved_frames(const std::filesystem::path& folder, const FrameShape& shape, std::span<const double> times);

/// All frames that a folder still holds whole, whether a checkpoint knows of them or not.
/// @param times  of the expected frames; the field file is read only if the log lacks one of these [s]
/// @param trouble  why the field file was refused, if it was
observe::Film saved_film(const std::filesystem::path& folder, const FrameShape& shape, std::span<const double> times,
                         std::string* trouble = nullptr);

/// Frames that were written and are lost.
struct LostFrames {
  std::size_t count = 0;
  std::size_t written = 0; ///< lost or not
  double first = 0.0;      ///< time of the first lost one [s]
  double last = 0.0;       ///< time of the last lost one [s]
};

/// @param written  times of the frames that a run has written, ascending [s]
/// @param there    times of the frames that are still there, ascending [s]
LostFrames lost_frames(std::span<const double> written, std::span<const double> there);

/// "4 of 11 frames (from 30 s to 2 min) are lost: ..."; empty if none is lost.
std::string to_text(const LostFrames& lost);

} // namespace matrigrate::store
