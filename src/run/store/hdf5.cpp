#include "store/hdf5.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace matrigrate::store {

namespace {

[[noreturn]] void fail(std::string_view what) { throw InputOutputError(fmt::format("HDF5: {}", what)); }

void require(herr_t status, std::string_view what) {
  if (status < 0) fail(what);
}

/// Starts HDF5, once: where it has got no memory for that, using it again would end the process. So would its work at
/// exit, which files in memory do not need.
herr_t start_library() {
  H5dont_atexit();
  if (H5open() < 0) return -1;
  return H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // it would print its own errors; here they become exceptions
}

Handle access_in_memory() {
  static const herr_t started = start_library();
  require(started, "it could not be started");
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "no access list");
  require(H5Pset_fapl_core(access.id(), std::size_t{1} << 20U, 0), "no file in memory");
  H5AC_cache_config_t cache{}; // of what is in memory anyway; names of frames take twenty times their size in it
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  require(H5Pget_mdc_config(access.id(), &cache), "no cache");
  cache.initial_size = cache.min_size = cache.max_size = std::size_t{1} << 17U;
  require(H5Pset_mdc_config(access.id(), &cache), "no smaller cache");
  return access;
}

/// HDF5 takes files in memory of one name for one file, so each has one of its own.
std::string name_of(const void* owner) { return fmt::format("memory-{}", owner); }

/// HDF5 would keep the memory that a file has used.
herr_t close_file(hid_t file) {
  const herr_t status = H5Fclose(file);
  H5garbage_collect();
  return status;
}

Handle new_file(const void* owner) {
  const Handle access = access_in_memory();
  return {H5Fcreate(name_of(owner).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), close_file,
          "no file could be made"};
}

Handle file_of(const void* owner, std::string_view image) {
  const Handle access = access_in_memory();
  void* bytes = const_cast<char*>(image.data()); // they are copied
  require(H5Pset_file_image(access.id(), bytes, image.size()), "the image could not be taken");
  return {H5Fopen(name_of(owner).c_str(), H5F_ACC_RDONLY, access.id()), close_file, "not an HDF5 file"};
}

void add_attribute(const Handle& owner, const char* name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "no space");
  const Handle attribute(H5Acreate2(owner.id(), name, type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "no attribute could be made");
  require(H5Awrite(attribute.id(), type, value), "an attribute could not be written");
}

void add_unit(const Handle& data, std::string_view unit) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "no type");
  require(H5Tset_size(type.id(), unit.size()), "no type for a unit");
  add_attribute(data, "units", type.id(), unit.data());
}

/// Texts of any length.
Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "no type");
  require(H5Tset_size(type.id(), H5T_VARIABLE), "no type for a text");
  require(H5Tset_cset(type.id(), H5T_CSET_UTF8), "no type for a text");
  return type;
}

/// An array of a file; groups on the way to it are made.
Handle new_array(const Handle& file, const std::string& name, hid_t type, std::span<const hsize_t> shape,
                 hid_t creation, hid_t access = H5P_DEFAULT) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "no link list");
  require(H5Pset_create_intermediate_group(links.id(), 1), "no groups");
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, "no space");
  return {H5Dcreate2(file.id(), name.c_str(), type, space.id(), links.id(), creation, access), H5Dclose,
          fmt::format("{} could not be made", name)};
}

/// Without a date of writing: the same numbers give the same bytes.
Handle undated() {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "no creation list");
  require(H5Pset_obj_track_times(creation.id(), 0), "no array without dates");
  return creation;
}

/// One chunk a frame, compressed.
Handle frame_by_frame(std::vector<hsize_t> shape) {
  constexpr unsigned level = 1; // the least: the chunks are compressed here, and any reader expands them
  Handle creation = undated();
  shape[0] = 1;
  require(H5Pset_chunk(creation.id(), static_cast<int>(shape.size()), shape.data()), "no chunks");
  require(H5Pset_shuffle(creation.id()), "no shuffling");
  require(H5Pset_deflate(creation.id(), level), "no compression");
  return creation;
}

/// Chunks are written whole, so none is kept.
Handle without_cache() {
  Handle access(H5Pcreate(H5P_DATASET_ACCESS), H5Pclose, "no access list");
  require(H5Pset_chunk_cache(access.id(), 0, 0, 0.0), "no array without a cache");
  return access;
}

constexpr hsize_t max_numbers = hsize_t{1} << 30U;  // of a frame or a table
constexpr hsize_t max_in_array = hsize_t{1} << 40U; // of all frames

/// The shape of an array, and a part of it: frames or rows in a stretch.
struct Slab {
  Handle space;
  std::vector<hsize_t> shape;
  hsize_t size = 1; ///< numbers in it
};

Slab slab_of(const Handle& data, std::size_t first, std::size_t rows) {
  Slab slab{{H5Dget_space(data.id()), H5Sclose, "an array has no shape"}, {}};
  const int dimensions = H5Sget_simple_extent_ndims(slab.space.id());
  if (dimensions < 1) fail("an array holds no frames");
  slab.shape.resize(static_cast<std::size_t>(dimensions));
  H5Sget_simple_extent_dims(slab.space.id(), slab.shape.data(), nullptr);
  if (rows > slab.shape[0] || first > slab.shape[0] - rows) fail("an array has fewer frames");
  std::vector<hsize_t> start(slab.shape.size(), 0);
  std::vector<hsize_t> count = slab.shape;
  start[0] = first;
  count[0] = rows;
  for (const hsize_t n : count) {
    if (n != 0 && slab.size > max_in_array / n) fail("an array is too large");
    slab.size *= n;
  }
  require(H5Sselect_hyperslab(slab.space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
          "no frame could be chosen");
  return slab;
}

} // namespace

Handle::Handle(hid_t id, Close close, std::string_view what) : m_id(id), m_close(close) {
  if (id < 0) fail(what);
}
Handle::Handle(Handle&& other) noexcept : m_id(std::exchange(other.m_id, -1)), m_close(other.m_close) {}
Handle::~Handle() {
  if (m_id >= 0) m_close(m_id);
}

MemoryFile::MemoryFile() : m_file(new_file(this)) {}

MemoryFile::MemoryFile(std::string_view image) : m_size(image.size()), m_file(file_of(this, image)) {}

std::string_view MemoryFile::view() const {
  require(H5Fflush(m_file.id(), H5F_SCOPE_GLOBAL), "the file could not be flushed");
  const ssize_t size = H5Fget_file_image(m_file.id(), nullptr, 0);
  void* memory = nullptr; // of a file in memory: where its address is kept
  if (size < 0 || H5Fget_vfd_handle(m_file.id(), H5P_DEFAULT, &memory) < 0) fail("the file has no image");
  return {*static_cast<const char**>(memory), static_cast<std::size_t>(size)};
}

void MemoryFile::write(const std::string& name, const void* values, hid_t type, std::span<const hsize_t> shape,
                       std::string_view unit) {
  const Handle data = new_array(m_file, name, type, shape, undated().id());
  require(H5Dwrite(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), fmt::format("{} not written", name));
  if (!unit.empty()) add_unit(data, unit);
}

void MemoryFile::write(const std::string& name, std::span<const double> values, std::string_view unit) {
  write(name, values.data(), H5T_NATIVE_DOUBLE, std::array<hsize_t, 1>{values.size()}, unit);
}

void MemoryFile::write(const std::string& name, std::span<const Vec2> values, std::string_view unit) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  write(name, values.data(), H5T_NATIVE_DOUBLE, std::array<hsize_t, 2>{values.size(), 2}, unit);
}

void MemoryFile::write(const std::string& name, std::span<const Mat2> values, std::string_view unit) {
  std::vector<double> rows;
  rows.reserve(4 * values.size());
  for (const Mat2& A : values) rows.insert(rows.end(), {A(0, 0), A(0, 1), A(1, 0), A(1, 1)});
  write(name, rows.data(), H5T_NATIVE_DOUBLE, std::array<hsize_t, 2>{values.size(), 4}, unit);
}

void MemoryFile::write(const std::string& name, std::span<const std::uint8_t> values, std::string_view unit) {
  write(name, values.data(), H5T_NATIVE_UINT8, std::array<hsize_t, 1>{values.size()}, unit);
}

void MemoryFile::write(const std::string& name, std::span<const std::uint32_t> values, std::string_view unit) {
  write(name, values.data(), H5T_NATIVE_UINT32, std::array<hsize_t, 1>{values.size()}, unit);
}

void MemoryFile::write_attribute(const std::string& name, const std::string& text) {
  const char* start = text.c_str();
  add_attribute(m_file, name.c_str(), text_type().id(), &start);
}

void MemoryFile::write_attribute(const std::string& name, std::uint64_t number) {
  add_attribute(m_file, name.c_str(), H5T_NATIVE_UINT64, &number);
}

void MemoryFile::write_rows(const std::string& name, std::span<const float> values, std::size_t columns,
                            std::string_view unit) {
  const std::array<hsize_t, 2> shape{values.size() / columns, columns};
  write(name, values.data(), H5T_NATIVE_FLOAT, std::span(shape).first(columns == 1 ? 1 : 2), unit);
}

void MemoryFile::write_text(const std::string& name, std::string_view text) {
  write(name, text.data(), H5T_NATIVE_UINT8, std::array<hsize_t, 1>{text.size()}, "");
}

/// @param part  of the array, which the view shows
void MemoryFile::name_part(const std::string& view, const std::string& name, hid_t part, std::span<const hsize_t> shape,
                           std::string_view unit) {
  const Handle data = own_array(m_file, name);
  const Handle type(H5Dget_type(data.id()), H5Tclose, fmt::format("{} has no type", name));
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, "no space");
  const Handle creation = undated();
  require(H5Pset_virtual(creation.id(), space.id(), ".", name.c_str(), part), "no view of an array");
  add_unit(new_array(m_file, view, type.id(), shape, creation.id()), unit);
}

void MemoryFile::name_frame(const std::string& view, const std::string& name, std::size_t frame,
                            std::string_view unit) {
  const Handle data = own_array(m_file, name);
  const Slab slab = slab_of(data, frame, 1);
  name_part(view, name, slab.space.id(), std::span(slab.shape).subspan(1), unit);
}

void MemoryFile::name_rows(const std::string& view, const std::string& name, std::size_t first, std::size_t rows,
                           std::string_view unit) {
  const Handle data = own_array(m_file, name);
  Slab slab = slab_of(data, first, rows);
  slab.shape[0] = rows;
  name_part(view, name, slab.space.id(), slab.shape, unit);
}

/// The array of that name. @param columns  1 for a 1-d array   @param rows  its length out
Handle MemoryFile::open(const std::string& name, hid_t type, std::size_t columns, std::size_t& rows) const {
  Handle data = own_array(m_file, name);
  const Handle stored(H5Dget_type(data.id()), H5Tclose, fmt::format("{} has no type", name));
  if (H5Tequal(stored.id(), type) <= 0) fail(fmt::format("{} has another type", name));
  const Handle space(H5Dget_space(data.id()), H5Sclose, fmt::format("{} has no shape", name));
  std::array<hsize_t, 2> shape{0, 1};
  const int dimensions = columns == 1 ? 1 : 2;
  if (H5Sget_simple_extent_ndims(space.id()) != dimensions) fail(fmt::format("{} has another shape", name));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  if (shape[1] != columns) fail(fmt::format("{} has another shape", name));
  rows = shape[0];
  return data;
}

template <class Number>
std::vector<Number> MemoryFile::read(const std::string& name, hid_t type, std::size_t columns) const {
  std::size_t rows = 0;
  const Handle data = open(name, type, columns, rows);
  if (rows * columns * sizeof(Number) > m_size) fail(fmt::format("{} is longer than the file", name));
  std::vector<Number> values(rows * columns);
  require(H5Dread(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), fmt::format("{} not read", name));
  return values;
}

std::vector<double> MemoryFile::doubles(const std::string& name) const {
  return read<double>(name, H5T_NATIVE_DOUBLE, 1);
}

std::vector<Vec2> MemoryFile::vectors(const std::string& name) const {
  const std::vector<double> values = read<double>(name, H5T_NATIVE_DOUBLE, 2);
  std::vector<Vec2> result(values.size() / 2);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = {values[2 * i], values[2 * i + 1]};
  return result;
}

std::vector<Mat2> MemoryFile::matrices(const std::string& name) const {
  const std::vector<double> values = read<double>(name, H5T_NATIVE_DOUBLE, 4);
  std::vector<Mat2> result(values.size() / 4);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] << values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3];
  return result;
}

std::vector<std::uint8_t> MemoryFile::bytes(const std::string& name) const {
  return read<std::uint8_t>(name, H5T_NATIVE_UINT8, 1);
}

std::string MemoryFile::text(const std::string& name) const {
  const std::vector<std::uint8_t> values = bytes(name);
  return {values.begin(), values.end()};
}

template <class Number>
std::vector<Number> MemoryFile::read_frame(const std::string& name, hid_t type, std::size_t frame) const {
  const Handle data = own_array(m_file, name);
  const Slab slab = slab_of(data, frame, 1);
  if (slab.size > max_numbers) fail(fmt::format("{} has another shape", name));
  const Handle stored(H5Dget_type(data.id()), H5Tclose, fmt::format("{} has no type", name));
  if (H5Tequal(stored.id(), type) <= 0) fail(fmt::format("{} has another type", name));
  const std::string bytes = frame_bytes(data, name, frame, sizeof(Number), slab.size * sizeof(Number), m_size);
  std::vector<Number> values(slab.size);
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

std::vector<float> MemoryFile::float_frame(const std::string& name, std::size_t frame) const {
  return read_frame<float>(name, H5T_NATIVE_FLOAT, frame);
}

std::vector<std::uint8_t> MemoryFile::byte_frame(const std::string& name, std::size_t frame) const {
  return read_frame<std::uint8_t>(name, H5T_NATIVE_UINT8, frame);
}

std::vector<hsize_t> FrameArray::shape_of(std::size_t frames, std::size_t entries, std::size_t components) {
  return components == 1 ? std::vector<hsize_t>{frames, entries} : std::vector<hsize_t>{frames, entries, components};
}

FrameArray::FrameArray(MemoryFile& file, const std::string& name, hid_t type, std::vector<hsize_t> shape,
                       std::string_view unit)
    : m_shape(std::move(shape)),
      m_data(new_array(file.m_file, name, type, m_shape, frame_by_frame(m_shape).id(), without_cache().id())) {
  add_unit(m_data, unit);
}

void FrameArray::require_size(std::size_t size) const {
  hsize_t of_frame = 1;
  for (std::size_t d = 1; d < m_shape.size(); ++d) of_frame *= m_shape[d];
  if (size != of_frame) throw std::invalid_argument("a frame is larger or smaller than the others");
}

void FrameArray::write(std::size_t frame, const std::string& compressed) {
  std::vector<hsize_t> offset(m_shape.size(), 0);
  offset[0] = frame;
  require(H5Dwrite_chunk(m_data.id(), H5P_DEFAULT, 0, offset.data(), compressed.size(), compressed.data()),
          "a frame was not written");
}

} // namespace matrigrate::store
