#include "store/own_array.hpp"

#include "base/failure.hpp"

#include <fmt/format.h>

#include <string_view>

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

} // namespace matrigrate::store
