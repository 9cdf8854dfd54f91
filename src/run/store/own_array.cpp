#include "store/hdf5.hpp"

#include "base/failure.hpp"
#include "store/deflate.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace matrigrate::store {

namespace {

[[noreturn]] void refuse_array(std::string_view what) { throw InputOutputError(fmt::format("HDF5: {}", what)); }

} // namespace

Handle own_array(const Handle& file, const std::string& name) {
  for (std::size_t end = name.find('/', 1);; end = name.find('/', end + 1)) {
    const std::string part = name.substr(0, end);
    H5L_info_t link{};
    if (H5Lexists(file.id(), part.c_str(), H5P_DEFAULT) <= 0
        || H5Lget_info(file.id(), part.c_str(), &link, H5P_DEFAULT) < 0)
      refuse_array(fmt::format("there is no {}", name));
    if (link.type != H5L_TYPE_HARD) refuse_array(fmt::format("{} is a link to another place", part));
    if (end == std::string::npos) break;
  }
  Handle data(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose, fmt::format("{} is no array", name));
  const Handle creation(H5Dget_create_plist(data.id()), H5Pclose, fmt::format("{} has no layout", name));
  if (H5Pget_external_count(creation.id()) != 0)
    refuse_array(fmt::format("{} keeps its numbers in another file", name));
  if (H5Pget_layout(creation.id()) == H5D_VIRTUAL) refuse_array(fmt::format("{} is a view of other arrays", name));
  return data;
}

void require_stored(const Handle& data, const std::string& name, hsize_t numbers, std::size_t file_size) {
  constexpr hsize_t most_expanded = 1032;
  const Handle type(H5Dget_type(data.id()), H5Tclose, fmt::format("{} has no type", name));
  const H5T_class_t kind = H5Tget_class(type.id());
  const std::size_t bytes = H5Tget_size(type.id());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || bytes > sizeof(double))
    refuse_array(fmt::format("{} has another type", name));
  const hsize_t stored = H5Dget_storage_size(data.id());
  if (stored > file_size) refuse_array(fmt::format("{} is longer than the file", name));
  if (numbers > most_expanded * stored / bytes)
    refuse_array(fmt::format("{} is not written: it holds too few bytes", name));
}

std::string frame_bytes(const Handle& frames, const std::string& name, std::size_t frame, std::size_t number,
                        std::size_t bytes, std::size_t file_size) {
  const Handle creation(H5Dget_create_plist(frames.id()), H5Pclose, fmt::format("{} has no layout", name));
  const Handle space(H5Dget_space(frames.id()), H5Sclose, fmt::format("{} has no shape", name));
  std::vector<hsize_t> offset(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.id())), 0);
  offset[0] = frame;
  constexpr std::size_t most_expanded = 1032; // by a byte of deflate
  hsize_t size = 0;
  if (H5Dget_chunk_storage_size(frames.id(), offset.data(), &size) < 0 || size == 0 || size > file_size
      || bytes / most_expanded > size)
    refuse_array(fmt::format("{} is not written", name));
  std::string stored(size, '\0');
  std::uint32_t skipped = 0; // filters that were not used
  if (H5Dread_chunk(frames.id(), H5P_DEFAULT, offset.data(), &skipped, stored.data()) < 0 || skipped != 0)
    refuse_array(fmt::format("{} not read", name));
  bool shuffled = false;
  bool deflated = false;
  const int filters = H5Pget_nfilters(creation.id());
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(creation.id(), static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, nullptr);
    bool& used = filter == H5Z_FILTER_SHUFFLE ? shuffled : deflated;
    if (deflated || used || (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_DEFLATE))
      refuse_array(fmt::format("{} is compressed in another way", name));
    used = true;
  }
  std::string numbers = deflated ? inflated(stored, bytes) : stored;
  if (numbers.size() != bytes) refuse_array(fmt::format("{} is shorter than its stated length", name));
  if (!shuffled) return numbers;
  std::string ordered(bytes, '\0');
  const std::size_t n = bytes / number;
  for (std::size_t plane = 0; plane < number; ++plane)
    for (std::size_t i = 0; i < n; ++i) ordered[i * number + plane] = numbers[plane * n + i];
  return ordered;
}

bool MemoryFile::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1)) {
    const std::string group = name.substr(0, end);
    H5L_info_t link{};
    if (H5Lexists(m_file.id(), group.c_str(), H5P_DEFAULT) <= 0
        || H5Lget_info(m_file.id(), group.c_str(), &link, H5P_DEFAULT) < 0)
      return false;
    if (link.type != H5L_TYPE_HARD) refuse_array(fmt::format("{} is a link to another place", group));
  }
  return H5Lexists(m_file.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<float> MemoryFile::floats(const std::string& name) const {
  const Handle data = own_array(m_file, name);
  const Handle space(H5Dget_space(data.id()), H5Sclose, fmt::format("{} has no shape", name));
  const hssize_t size = H5Sget_simple_extent_npoints(space.id());
  if (size < 0) refuse_array(fmt::format("{} has another shape", name));
  require_stored(data, name, static_cast<hsize_t>(size), m_size);
  if (static_cast<hsize_t>(size) * sizeof(float) > m_size)
    refuse_array(fmt::format("{} is longer than the file", name));
  std::vector<float> values(static_cast<std::size_t>(size));
  if (H5Dread(data.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    refuse_array(fmt::format("{} not read", name));
  return values;
}

void MemoryFile::require_frames(const std::string& name, std::size_t frames, std::size_t numbers) const {
  const Handle data = own_array(m_file, name);
  const Handle space(H5Dget_space(data.id()), H5Sclose, fmt::format("{} has no shape", name));
  const int dimensions = H5Sget_simple_extent_ndims(space.id());
  if (dimensions < 1) refuse_array(fmt::format("{} holds no frames", name));
  std::vector<hsize_t> shape(static_cast<std::size_t>(dimensions));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  constexpr hsize_t most = hsize_t{1} << 40U;
  hsize_t size = 1;
  for (const hsize_t n : shape) {
    if (n != 0 && size > most / n) refuse_array(fmt::format("{} is too large", name));
    size *= n;
  }
  if (shape[0] != frames) refuse_array(fmt::format("{} has {} frames instead of {}", name, shape[0], frames));
  const hsize_t in_frame = frames == 0 ? 0 : size / frames;
  if (numbers > 0 && in_frame != numbers)
    refuse_array(fmt::format("{} has {} numbers a frame instead of {}", name, in_frame, numbers));
  const Handle creation(H5Dget_create_plist(data.id()), H5Pclose, fmt::format("{} has no layout", name));
  std::vector<hsize_t> chunk(shape.size(), 0), expected = shape;
  expected[0] = 1;
  if (H5Pget_layout(creation.id()) != H5D_CHUNKED || H5Pget_chunk(creation.id(), dimensions, chunk.data()) != dimensions
      || chunk != expected)
    refuse_array(fmt::format("{} is not stored frame by frame", name));
  require_stored(data, name, size, m_size);
}

} // namespace matrigrate::store
