#pragma once

#include "base/vector.hpp"

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A thin layer over the C interface of HDF5: handles that close themselves, arrays of numbers with their unit, and
/// failures as exceptions. Test: tests/unit/io/checkpoint_test.cpp
namespace matrigrate::io {

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

/// A file held in memory: written as a whole, and read only from bytes that are known to be whole.
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

  /// Its bytes.
  std::string image() const;

  /// Groups on the way to `name` are made. The array is 1-d, or n x 2 for vectors, n x 4 for matrices (row by row).
  void write(const std::string& name, std::span<const double> values, std::string_view unit);
  void write(const std::string& name, std::span<const Vec2> values, std::string_view unit);
  void write(const std::string& name, std::span<const Mat2> values, std::string_view unit);
  void write(const std::string& name, std::span<const std::uint8_t> values);
  void write_text(const std::string& name, std::string_view text);

  /// @throws InputOutputError naming the array, if it is not there or of another type or shape
  std::vector<double> doubles(const std::string& name) const;
  std::vector<Vec2> vectors(const std::string& name) const;
  std::vector<Mat2> matrices(const std::string& name) const;
  std::vector<std::uint8_t> bytes(const std::string& name) const;
  std::string text(const std::string& name) const;

private:
  void write(const std::string& name, const void* values, hid_t type, std::span<const hsize_t> shape,
             std::string_view unit);
  Handle open(const std::string& name, hid_t type, std::size_t columns, std::size_t& rows) const;
  template <class Number>
  std::vector<Number> read(const std::string& name, hid_t type, std::size_t columns) const;

  std::string m_image; ///< what the file is read from
  Handle m_file;
};

} // namespace matrigrate::io
