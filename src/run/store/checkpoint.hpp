#pragma once

#include "state/state.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// The exact state of a run as one file, checkpoint.h5. It is an HDF5 file with a user block of 512 bytes in front, a
/// line of text that names format, version, length and fingerprint of what follows: HDF5's own tools open the file as
/// it is, and a file that is cut short, or of which one bit has changed, is refused before anything of it is read.
/// Arrays have the names of state/members.hpp: /ecm/x, /cells/0/cortex/x. /state.json has all other members, likewise.
/// Test: tests/unit/store/checkpoint_test.cpp
namespace matrigrate::store {

inline constexpr int checkpoint_version = 9;
inline constexpr std::string_view checkpoint_name = "checkpoint.h5";
inline constexpr std::string_view previous_checkpoint_name = "checkpoint_prev.h5";

/// All that is needed to go on, and to go on writing.
struct Checkpoint {
  State state;
  std::string scenario;           ///< resolved, TOML
  std::string configuration_hash; ///< of the scenario
  std::string program;            ///< version and commit of the program that wrote it
  std::string memory;             ///< of what has been written so far, for the writer of the run's files
};

/// The bytes of the file.
std::string checkpoint_image(const Checkpoint& checkpoint);

/// @param name  stands for the file in messages
/// @throws InputOutputError saying whether the bytes are no checkpoint, one of another version, cut short, or changed
Checkpoint parse_checkpoint(std::string_view image, const std::string& name);

/// The parts of the state that are kept as text: all but the arrays.
/// @throws InputOutputError saying what is wrong
State parse_state_parts(const std::string& text);

/// @throws InputOutputError as parse_checkpoint, or if the file cannot be read
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// Checkpoint::memory alone, which takes less time than all of it.
/// @throws InputOutputError as read_checkpoint
std::string read_checkpoint_memory(const std::filesystem::path& file);

/// Writes folder/checkpoint.h5 whole or not at all; the one before becomes checkpoint_prev.h5.
/// @param kept  a second file with the same content, written first, since a resumed run would not write it again
/// @throws InputOutputError naming the path and the reason
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint,
                      const std::optional<std::filesystem::path>& kept = {});

} // namespace matrigrate::store
