#pragma once

#include "store/hdf5.hpp"

#include <cstddef>
#include <string>

/// Checks of an array before it is read from an untrusted file.
/// Test: tests/unit/store/frames_test.cpp
namespace matrigrate::store {

/// An array within the file itself: every link on the way to it is hard, and its numbers are in this file.
/// @throws InputOutputError if it is not there, or refers to another place
Handle own_array(const Handle& file, const std::string& name);

/// Refuses an array that takes more memory than its bytes in the file can give: deflate makes at most 1032 bytes of
/// one.
/// @throws InputOutputError also if its numbers are of no common type
void require_stored(const Handle& data, const std::string& name, hsize_t numbers, std::size_t file_size);

/// The numbers of a frame as they lie in memory. They are expanded here: HDF5 reads beyond a frame that is shorter than
/// it says.
/// @param frames  an array of frames, each stored on its own (MemoryFile::require_frames)
/// @param number  bytes of a number
/// @param bytes   of a frame
/// @throws InputOutputError naming the array, if its frame has not as many bytes
std::string frame_bytes(const Handle& frames, const std::string& name, std::size_t frame, std::size_t number,
                        std::size_t bytes, std::size_t file_size);

} // namespace matrigrate::store
