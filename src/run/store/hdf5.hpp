#pragma once

#include "base/vector.hpp"
#include "store/deflate.hpp"

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::store {

// A thin layer over the C interface of HDF5: handles that close themselves, arrays of numbers with their unit, and
// failures as exceptions. Test: tests/unit/store/checkpoint_test.cpp

/// Any identifier of HDF5, closed at the end of its scope.
class Handle {
public:
  using Close = herr_t (*)(hid_t);

  /// @throws InputOutputError saying what could not be done, if HDF5 has returned no identifier
  Handle(hid_t id, Close close, std::string_view what);
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) = delete;
  ~Handle();

  hid_t id() const { return m_id; }

private:
  hid_t m_id;
  Close m_close;
};

/// A file held in memory, written as a whole. A file that is read is not trusted: arrays that are links, views, kept in
/// another file, or larger than the file are refused.
class MemoryFile {
public:
  /// An empty file to be filled.
  MemoryFile();

  /// A file to be read.
  /// @throws InputOutputError if it is no HDF5 file
  explicit MemoryFile(std::string_view image);
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() = default;

  /// The bytes of the file, valid until the next write or the end of this object.
  std::string_view view() const;

  /// Groups on the way to `name` are made. The array is 1-d, or n x 2 for vectors, n x 4 for matrices (row by row).
  void write(const std::string& name, std::span<const double> values, std::string_view unit);
  void write(const std::string& name, std::span<const Vec2> values, std::string_view unit);
  void write(const std::string& name, std::span<const Mat2> values, std::string_view unit);
  void write(const std::string& name, std::span<const std::uint8_t> values, std::string_view unit = "");
  void write(const std::string& name, std::span<const std::uint32_t> values, std::string_view unit);
  void write_text(const std::string& name, std::string_view text);
  /// @param columns  1 for a 1-d array, else n x columns
  void write_rows(const std::string& name, std::span<const float> values, std::size_t columns, std::string_view unit);

  /// An attribute of the file as a whole.
  void write_attribute(const std::string& name, const std::string& text);
  void write_attribute(const std::string& name, std::uint64_t number);

  /// Names one frame of a FrameArray as an array of its own, without a copy: what HDF5 calls a virtual dataset.
  void name_frame(const std::string& view, const std::string& name, std::size_t frame, std::string_view unit);
  /// Names rows of a table as an array of their own, likewise.
  /// @param rows  at least 1
  void name_rows(const std::string& view, const std::string& name, std::size_t first, std::size_t rows,
                 std::string_view unit);

  /// @throws InputOutputError naming the array, if it is not there or of another type or shape
  std::vector<double> doubles(const std::string& name) const;
  std::vector<Vec2> vectors(const std::string& name) const;
  std::vector<Mat2> matrices(const std::string& name) const;
  std::vector<std::uint8_t> bytes(const std::string& name) const;
  std::string text(const std::string& name) const;
  bool has(const std::string& name) const;
  std::vector<float> floats(const std::string& name) const; ///< of any shape, row by row
  /// Refuses an array of frames before its memory is taken.
  /// @param numbers  of a frame; 0: any
  /// @throws InputOutputError if it has another shape, or more numbers than its bytes can hold
  void require_frames(const std::string& name, std::size_t frames, std::size_t numbers) const;
  /// The numbers of one frame of a FrameArray.
  std::vector<float> float_frame(const std::string& name, std::size_t frame) const;
  std::vector<std::uint8_t> byte_frame(const std::string& name, std::size_t frame) const;

private:
  friend class FrameArray;
  void write(const std::string& name, const void* values, hid_t type, std::span<const hsize_t> shape,
             std::string_view unit);
  void name_part(const std::string& view, const std::string& name, hid_t part, std::span<const hsize_t> shape,
                 std::string_view unit);
  Handle open(const std::string& name, hid_t type, std::size_t columns, std::size_t& rows) const;
  template <class Number>
  std::vector<Number> read(const std::string& name, hid_t type, std::size_t columns) const;

  template <class Number>
  std::vector<Number> read_frame(const std::string& name, hid_t type, std::size_t frame) const;

  std::size_t m_size = 0; ///< of the image that is read [bytes]
  Handle m_file;
};

/// An array of (frames, entries[, components]), compressed frame by frame.
class FrameArray {
public:
  /// @param like  tells the type of the numbers: float or byte
  template <class Number>
  FrameArray(MemoryFile& file, const std::string& name, const std::vector<Number>& like, std::size_t frames,
             std::size_t entries, std::size_t components, std::string_view unit)
      : FrameArray(file, name, type_of(like), shape_of(frames, entries, components), unit) {}

  /// A frame as it is written: compressed as by HDF5's own filters.
  /// @throws std::invalid_argument if it has another size than the others
  template <class Number>
  std::string compressed(const std::vector<Number>& values) const {
    require_size(values.size());
    return deflated_fast(byte_planes(std::span<const Number>(values)));
  }

  void write(std::size_t frame, const std::string& compressed);

private:
  static hid_t type_of(const std::vector<float>&) { return H5T_NATIVE_FLOAT; }
  static hid_t type_of(const std::vector<std::uint8_t>&) { return H5T_NATIVE_UINT8; }
  static std::vector<hsize_t> shape_of(std::size_t frames, std::size_t entries, std::size_t components);
  FrameArray(MemoryFile& file, const std::string& name, hid_t type, std::vector<hsize_t> shape, std::string_view unit);
  void require_size(std::size_t size) const;

  std::vector<hsize_t> m_shape;
  Handle m_data;
};

// Checks of an array before it is read from an untrusted file.
// Test: tests/unit/store/frames_test.cpp

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
