#include "store/hdf5.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace matrigrate::store {

namespace {

template <class... Names>
[[noreturn]] void fail(fmt::format_string<Names...> what, Names&&... names) {
  throw InputOutputError("HDF5: " + fmt::format(what, std::forward<Names>(names)...));
}

void require(herr_t status, std::string_view what) {
  if (status < 0) fail("{}", what);
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
constexpr hsize_t most_expanded = 1032;             // bytes that deflate makes of one

template <class Number>
hid_t type_of() {
  if constexpr (std::is_same_v<Number, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<Number, float>) return H5T_NATIVE_FLOAT;
  if constexpr (std::is_same_v<Number, std::uint32_t>) return H5T_NATIVE_UINT32;
  return H5T_NATIVE_UINT8;
}

/// What HDF5 stores of a T: numbers.
template <class T>
using NumberOf = std::conditional_t<std::is_arithmetic_v<T>, T, double>;
template <class T>
constexpr std::size_t numbers_in = sizeof(T) / sizeof(NumberOf<T>);
static_assert(numbers_in<Vec2> == 2 && numbers_in<Mat2> == 4);

Handle type_in(const Handle& data, const std::string& name) {
  return {H5Dget_type(data.id()), H5Tclose, fmt::format("{} has no type", name)};
}

template <class Number>
void require_type(const Handle& data, const std::string& name) {
  if (H5Tequal(type_in(data, name).id(), type_of<Number>()) <= 0) fail("{} has another type", name);
}

Handle layout_of(const Handle& data, const std::string& name) {
  return {H5Dget_create_plist(data.id()), H5Pclose, fmt::format("{} has no layout", name)};
}

std::vector<hsize_t> shape_of(const Handle& data, const std::string& name) {
  const Handle space(H5Dget_space(data.id()), H5Sclose, fmt::format("{} has no shape", name));
  std::vector<hsize_t> shape(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space.id()))));
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  return shape;
}

hsize_t size_of(std::span<const hsize_t> shape, const std::string& name) {
  hsize_t size = 1;
  for (const hsize_t n : shape) {
    if (n != 0 && size > max_in_array / n) fail("{} is too large", name);
    size *= n;
  }
  return size;
}

/// A part of an array of this file: rows in a stretch.
Handle part_of(const Handle& data, std::span<const hsize_t> shape, std::size_t first, std::size_t rows) {
  Handle space(H5Dget_space(data.id()), H5Sclose, "an array has no shape");
  std::vector<hsize_t> start(shape.size(), 0), count(shape.begin(), shape.end());
  start[0] = first;
  count[0] = rows;
  require(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
          "no frame could be chosen");
  return space;
}

/// Whether a file has an array or group of that name.
/// @throws InputOutputError if it or a group on the way to it is a link to another place
bool is_in(const Handle& file, const std::string& name) {
  for (std::size_t end = 0; end != std::string::npos;) {
    end = name.find('/', end + 1);
    const std::string part = name.substr(0, end);
    H5L_info_t link{};
    if (H5Lexists(file.id(), part.c_str(), H5P_DEFAULT) <= 0
        || H5Lget_info(file.id(), part.c_str(), &link, H5P_DEFAULT) < 0)
      return false;
    if (link.type != H5L_TYPE_HARD) fail("{} is a link to another place", part);
  }
  return true;
}

/// An array within the file itself: every link on the way to it is hard, and its numbers are in this file.
/// @throws InputOutputError if it is not there, or refers to another place
Handle own_array(const Handle& file, const std::string& name) {
  if (!is_in(file, name)) fail("there is no {}", name);
  Handle data(H5Dopen2(file.id(), name.c_str(), H5P_DEFAULT), H5Dclose, fmt::format("{} is no array", name));
  const Handle layout = layout_of(data, name);
  if (H5Pget_external_count(layout.id()) != 0) fail("{} keeps its numbers in another file", name);
  if (H5Pget_layout(layout.id()) == H5D_VIRTUAL) fail("{} is a view of other arrays", name);
  return data;
}

/// Refuses an array that takes more memory than its bytes in the file can give.
/// @throws InputOutputError also if its numbers are of no common type
void require_stored(const Handle& data, const std::string& name, hsize_t numbers, std::size_t file_size) {
  const Handle type = type_in(data, name);
  const H5T_class_t kind = H5Tget_class(type.id());
  const std::size_t bytes = H5Tget_size(type.id());
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || bytes > sizeof(double)) fail("{} has another type", name);
  const hsize_t stored = H5Dget_storage_size(data.id());
  if (stored > file_size) fail("{} is longer than the file", name);
  if (numbers > most_expanded * stored / bytes) fail("{} is not written: it holds too few bytes", name);
}

/// How the frames of an array are compressed. @throws InputOutputError if in another way than FrameArray does
struct Filters {
  bool shuffled = false, deflated = false;

  Filters(const Handle& data, const std::string& name) {
    const Handle layout = layout_of(data, name);
    const int filters = H5Pget_nfilters(layout.id());
    for (int i = 0; i < filters; ++i) {
      unsigned flags = 0;
      std::size_t values = 0;
      const H5Z_filter_t filter =
          H5Pget_filter2(layout.id(), static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, nullptr);
      bool& used = filter == H5Z_FILTER_SHUFFLE ? shuffled : deflated;
      if (deflated || used || (filter != H5Z_FILTER_SHUFFLE && filter != H5Z_FILTER_DEFLATE))
        fail("{} is compressed in another way", name);
      used = true;
    }
  }
};

/// The numbers of a frame as they lie in memory. They are expanded here: HDF5 reads beyond a frame that is shorter than
/// it says.
/// @param data    an array of frames, each stored on its own (MemoryFile::require_frames)
/// @param offset  of the frame
/// @throws InputOutputError naming the array, if its frame has not as many bytes
template <class Number>
void read_frame(const Handle& data, const std::string& name, const std::vector<hsize_t>& offset, std::size_t file_size,
                std::vector<Number>& numbers) {
  const std::size_t bytes = numbers.size() * sizeof(Number);
  hsize_t size = 0;
  if (H5Dget_chunk_storage_size(data.id(), offset.data(), &size) < 0 || size == 0 || size > file_size
      || bytes / most_expanded > size)
    fail("{} is not written", name);
  std::string stored(size, '\0');
  std::uint32_t skipped = 0; // filters that were not used
  if (H5Dread_chunk(data.id(), H5P_DEFAULT, offset.data(), &skipped, stored.data()) < 0 || skipped != 0)
    fail("{} not read", name);
  const Filters filters(data, name);
  if (filters.deflated) stored = inflated(stored, bytes);
  if (stored.size() != bytes) fail("{} is shorter than its stated length", name);
  if (filters.shuffled)
    from_byte_planes(stored, std::span(numbers));
  else
    std::memcpy(numbers.data(), stored.data(), bytes);
}

} // namespace

Handle::Handle(hid_t id, Close close, std::string_view what) : m_id(id), m_close(close) {
  if (id < 0) fail("{}", what);
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

template <class T>
void MemoryFile::write(const std::string& name, const std::vector<T>& values, std::string_view unit,
                       std::size_t columns) {
  std::vector<T> rows;
  if constexpr (std::is_same_v<T, Mat2>) // matrices lie column by column in memory
    for (const Mat2& A : values) rows.emplace_back(A.transpose());
  columns *= numbers_in<T>;
  const std::array<hsize_t, 2> shape{values.size() * numbers_in<T> / columns, columns};
  const hid_t type = type_of<NumberOf<T>>();
  const Handle data = new_array(m_file, name, type, std::span(shape).first(columns == 1 ? 1 : 2), undated().id());
  const void* numbers = rows.empty() ? values.data() : rows.data();
  require(H5Dwrite(data.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), fmt::format("{} not written", name));
  if (!unit.empty()) add_unit(data, unit);
}

template void MemoryFile::write(const std::string&, const std::vector<double>&, std::string_view, std::size_t);
template void MemoryFile::write(const std::string&, const std::vector<float>&, std::string_view, std::size_t);
template void MemoryFile::write(const std::string&, const std::vector<std::uint8_t>&, std::string_view, std::size_t);
template void MemoryFile::write(const std::string&, const std::vector<std::uint32_t>&, std::string_view, std::size_t);
template void MemoryFile::write(const std::string&, const std::vector<Vec2>&, std::string_view, std::size_t);
template void MemoryFile::write(const std::string&, const std::vector<Mat2>&, std::string_view, std::size_t);

void MemoryFile::write_text(const std::string& name, std::string_view text) {
  write(name, std::vector<std::uint8_t>(text.begin(), text.end()), "");
}

void MemoryFile::write_attribute(const std::string& name, const std::string& text) {
  const char* start = text.c_str();
  add_attribute(m_file, name.c_str(), text_type().id(), &start);
}

void MemoryFile::write_attribute(const std::string& name, std::uint64_t number) {
  add_attribute(m_file, name.c_str(), H5T_NATIVE_UINT64, &number);
}

/// @param part  of the array, which the view shows
void MemoryFile::name_part(const std::string& view, const std::string& name, const Handle& part,
                           std::span<const hsize_t> shape, std::string_view unit) {
  const Handle type = type_in(own_array(m_file, name), name);
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, "no space");
  const Handle creation = undated();
  require(H5Pset_virtual(creation.id(), space.id(), ".", name.c_str(), part.id()), "no view of an array");
  add_unit(new_array(m_file, view, type.id(), shape, creation.id()), unit);
}

void MemoryFile::name_frame(const std::string& view, const std::string& name, std::size_t frame,
                            std::string_view unit) {
  const Handle data = own_array(m_file, name);
  const std::vector<hsize_t> shape = shape_of(data, name);
  name_part(view, name, part_of(data, shape, frame, 1), std::span(shape).subspan(1), unit);
}

void MemoryFile::name_rows(const std::string& view, const std::string& name, std::size_t first, std::size_t rows,
                           std::string_view unit) {
  const Handle data = own_array(m_file, name);
  std::vector<hsize_t> shape = shape_of(data, name);
  const Handle part = part_of(data, shape, first, rows);
  shape[0] = rows;
  name_part(view, name, part, shape, unit);
}

bool MemoryFile::has(const std::string& name) const { return is_in(m_file, name); }

template <class T>
std::vector<T> MemoryFile::array(const std::string& name) const {
  using Number = NumberOf<T>;
  const Handle data = own_array(m_file, name);
  require_type<Number>(data, name);
  std::vector<hsize_t> shape = shape_of(data, name);
  if (numbers_in<T> == 1) shape.push_back(1);
  if (shape.size() != 2 || shape[1] != numbers_in<T>) fail("{} has another shape", name);
  if (shape[0] > m_size / sizeof(T)) fail("{} is longer than the file", name);
  std::vector<T> values(shape[0]);
  require(H5Dread(data.id(), type_of<Number>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          fmt::format("{} not read", name));
  if constexpr (std::is_same_v<T, Mat2>)
    for (Mat2& A : values) A.transposeInPlace();
  return values;
}

template std::vector<double> MemoryFile::array(const std::string&) const;
template std::vector<std::uint8_t> MemoryFile::array(const std::string&) const;
template std::vector<Vec2> MemoryFile::array(const std::string&) const;
template std::vector<Mat2> MemoryFile::array(const std::string&) const;

std::string MemoryFile::text(const std::string& name) const {
  const std::vector<std::uint8_t> values = array<std::uint8_t>(name);
  return {values.begin(), values.end()};
}

std::vector<float> MemoryFile::floats(const std::string& name) const {
  const Handle data = own_array(m_file, name);
  const hsize_t size = size_of(shape_of(data, name), name);
  require_stored(data, name, size, m_size);
  if (size > m_size / sizeof(float)) fail("{} is longer than the file", name);
  std::vector<float> values(size);
  require(H5Dread(data.id(), H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
          fmt::format("{} not read", name));
  return values;
}

void MemoryFile::require_frames(const std::string& name, std::size_t frames, std::size_t numbers) const {
  const Handle data = own_array(m_file, name);
  const std::vector<hsize_t> shape = shape_of(data, name);
  if (shape.empty()) fail("{} holds no frames", name);
  const hsize_t size = size_of(shape, name);
  if (shape[0] != frames) fail("{} has {} frames instead of {}", name, shape[0], frames);
  const hsize_t in_frame = frames == 0 ? 0 : size / frames;
  if (numbers > 0 && in_frame != numbers) fail("{} has {} numbers a frame instead of {}", name, in_frame, numbers);
  const Handle layout = layout_of(data, name);
  const int dimensions = static_cast<int>(shape.size());
  std::vector<hsize_t> chunk(shape.size(), 0), expected = shape;
  expected[0] = 1;
  if (H5Pget_layout(layout.id()) != H5D_CHUNKED || H5Pget_chunk(layout.id(), dimensions, chunk.data()) != dimensions
      || chunk != expected)
    fail("{} is not stored frame by frame", name);
  require_stored(data, name, size, m_size);
}

template <class Number>
std::vector<Number> MemoryFile::frame(const std::string& name, std::size_t frame) const {
  const Handle data = own_array(m_file, name);
  const std::vector<hsize_t> shape = shape_of(data, name);
  if (shape.empty() || frame >= shape[0]) fail("{} has fewer frames", name);
  const hsize_t size = size_of(std::span(shape).subspan(1), name);
  if (size > max_numbers) fail("{} has another shape", name);
  require_type<Number>(data, name);
  std::vector<hsize_t> offset(shape.size(), 0);
  offset[0] = frame;
  std::vector<Number> values(size);
  read_frame(data, name, offset, m_size, values);
  return values;
}

template std::vector<float> MemoryFile::frame(const std::string&, std::size_t) const;
template std::vector<std::uint8_t> MemoryFile::frame(const std::string&, std::size_t) const;

template <class Number>
FrameArray::FrameArray(MemoryFile& file, const std::string& name, const std::vector<Number>& like, std::size_t frames,
                       std::size_t components, std::string_view unit)
    : m_shape(components == 1 ? std::vector<hsize_t>{frames, like.size()}
                              : std::vector<hsize_t>{frames, like.size() / components, components}),
      m_data(new_array(file.m_file, name, type_of<Number>(), m_shape, frame_by_frame(m_shape).id(),
                       without_cache().id())) {
  add_unit(m_data, unit);
}

template FrameArray::FrameArray(MemoryFile&, const std::string&, const std::vector<float>&, std::size_t, std::size_t,
                                std::string_view);
template FrameArray::FrameArray(MemoryFile&, const std::string&, const std::vector<std::uint8_t>&, std::size_t,
                                std::size_t, std::string_view);

void FrameArray::require_size(std::size_t size) const {
  if (size != size_of(std::span(m_shape).subspan(1), "a frame"))
    throw std::invalid_argument("a frame is larger or smaller than the others");
}

void FrameArray::write(std::size_t frame, const std::string& compressed) {
  std::vector<hsize_t> offset(m_shape.size(), 0);
  offset[0] = frame;
  require(H5Dwrite_chunk(m_data.id(), H5P_DEFAULT, 0, offset.data(), compressed.size(), compressed.data()),
          "a frame was not written");
}

} // namespace matrigrate::store
