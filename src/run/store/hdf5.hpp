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
// failures as exceptions. Test: tests/unit/store/checkpoint_test.cpp, tests/unit/store/frames_test.cpp

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

  /// Groups on the way to `name` are made. The array is n x 2 for vectors, n x 4 for matrices (row by row).
  /// @tparam T  double, float, std::uint8_t, std::uint32_t, Vec2 or Mat2
  /// @param columns  of numbers: 1 for a 1-d array, else n x columns
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, std::string_view unit, std::size_t columns = 1);
  void write_text(const std::string& name, std::string_view text);

  /// An attribute of the file as a whole.
  void write_attribute(const std::string& name, const std::string& text);
  void write_attribute(const std::string& name, std::uint64_t number);

  /// Names one frame of a FrameArray as an array of its own, without a copy: what HDF5 calls a virtual dataset.
  void name_frame(const std::string& view, const std::string& name, std::size_t frame, std::string_view unit);
  /// Names rows of a table as an array of their own, likewise.
  /// @param rows  at least 1
  void name_rows(const std::string& view, const std::string& name, std::size_t first, std::size_t rows,
                 std::string_view unit);

  bool has(const std::string& name) const;
  /// @tparam T  double, std::uint8_t, Vec2 or Mat2
  /// @throws InputOutputError naming the array, if it is not there or of another type or shape
  template <class T>
  std::vector<T> array(const std::string& name) const;
  std::string text(const std::string& name) const;
  std::vector<float> floats(const std::string& name) const; ///< of any type and shape, row by row
  /// Refuses an array of frames before its memory is taken.
  /// @param numbers  of a frame; 0: any
  /// @throws InputOutputError if it has another shape, or more numbers than its bytes can hold
  void require_frames(const std::string& name, std::size_t frames, std::size_t numbers) const;
  /// The numbers of one frame of a FrameArray.
  /// @tparam Number  float or std::uint8_t
  template <class Number>
  std::vector<Number> frame(const std::string& name, std::size_t frame) const;

private:
  friend class FrameArray;
  void name_part(const std::string& view, const std::string& name, const Handle& part, std::span<const hsize_t> shape,
                 std::string_view unit);

  std::size_t m_size = 0; ///< of the image that is read [bytes]
  Handle m_file;
};

/// An array of (frames, entries[, components]), compressed frame by frame.
class FrameArray {
public:
  /// @param like  tells the type of the numbers, float or byte, and how many a frame has
  template <class Number>
  FrameArray(MemoryFile& file, const std::string& name, const std::vector<Number>& like, std::size_t frames,
             std::size_t components, std::string_view unit);

  /// A frame as it is written: compressed as by HDF5's own filters.
  /// @throws std::invalid_argument if it has another size than the others
  template <class Number>
  std::string compressed(const std::vector<Number>& values) const {
    require_size(values.size());
    return deflated_fast(byte_planes(std::span<const Number>(values)));
  }

  void write(std::size_t frame, const std::string& compressed);

private:
  void require_size(std::size_t size) const;

  std::vector<hsize_t> m_shape;
  Handle m_data;
};

} // namespace matrigrate::store
