#include "exchange/vtk_files.hpp"

#include "base/file.hpp"
#include "store/anchors.hpp"
#include "store/base64.hpp"
#include "store/deflate.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <numeric>
#include <vector>

namespace matrigrate::exchange {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

constexpr std::string_view xml_head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" "
                                      "byte_order=\"LittleEndian\" header_type=\"UInt32\" "
                                      "compressor=\"vtkZLibDataCompressor\">\n";

template <class Number>
std::string_view bytes_of(const std::vector<Number>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)};
}

/// VTK's inline binary form: the number of blocks, their size, that of a shorter last one, and the compressed size of
/// each, then the blocks; both in base64. Here all is one block.
std::string coded(std::string_view bytes) {
  if (bytes.empty()) return store::base64(bytes_of(std::vector<std::uint32_t>{0, 0, 0}));
  const std::string block = store::deflated(bytes, 6);
  const std::vector<std::uint32_t> head{1, static_cast<std::uint32_t>(bytes.size()), 0,
                                        static_cast<std::uint32_t>(block.size())};
  return store::base64(bytes_of(head)) + store::base64(block);
}

/// Vectors in the plane get a third component, 0.
template <class Number>
std::string array(std::string_view name, std::string_view type, std::uint32_t components,
                  const std::vector<Number>& values) {
  std::vector<Number> in_space;
  if (components == 2)
    for (std::size_t i = 0; i + 1 < values.size(); i += 2)
      in_space.insert(in_space.end(), {values[i], values[i + 1], Number{0}});
  return fmt::format("<DataArray Name=\"{}\" type=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">\n{}\n"
                     "</DataArray>\n",
                     name, type, components == 2 ? 3 : components,
                     coded(bytes_of(components == 2 ? in_space : values)));
}

/// The fields of one body. @param more  that no frame holds
std::string fields_of(std::string_view body, const observe::Frame& frame, const std::string& more = "") {
  std::string text = "<PointData>\n" + more;
  for (const auto& field : observe::float_fields())
    if (field.name.starts_with(body) && !field.name.ends_with("/position") && !field.in(frame).empty())
      text += array(field.name.substr(body.size()), "Float32", field.components, field.in(frame));
  for (const auto& field : observe::count_fields())
    if (field.name.starts_with(body) && !field.in(frame).empty())
      text += array(field.name.substr(body.size()), "UInt32", field.components, field.in(frame));
  for (const auto& field : observe::byte_fields())
    if (field.name.starts_with(body))
      text += array(field.name.substr(body.size()), "UInt8", field.components, field.in(frame));
  return text + "</PointData>\n";
}

/// Cells: `connectivity` and `offsets` of vertices or lines.
std::string cells(std::string_view kind, const std::vector<std::int64_t>& points,
                  const std::vector<std::int64_t>& ends) {
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", kind, array("connectivity", "Int64", 1, points),
                     array("offsets", "Int64", 1, ends));
}

std::string vtp(std::size_t points, std::size_t vertices, std::size_t lines, const std::string& content) {
  return fmt::format(xml_head, "PolyData")
         + fmt::format("<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                       "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n{}</Piece>\n</PolyData>\n</VTKFile>\n",
                       points, vertices, lines, content);
}

/// Each point a cell of its own.
std::string vertices(std::size_t n) {
  std::vector<std::int64_t> points(n);
  std::iota(points.begin(), points.end(), std::int64_t{0});
  std::vector<std::int64_t> ends(n);
  std::iota(ends.begin(), ends.end(), std::int64_t{1});
  return cells("Verts", points, ends);
}

std::string points_of(const observe::Floats& x) {
  return "<Points>\n" + array("position", "Float32", 2, x) + "</Points>\n";
}

} // namespace

std::string matrix_vtp(const observe::FrameHead& head, const observe::Frame& frame) {
  observe::Floats x = frame.matrix.displacement;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += head.reference[i];
  observe::Bytes solid;
  for (const float f : frame.matrix.f_degr) solid.push_back(f > 0.0F ? 1 : 0);
  const std::size_t n = head.particles();
  return vtp(n, n, 0, points_of(x) + vertices(n) + fields_of("matrix/", frame, array("solid", "UInt8", 1, solid)));
}

std::string outline_vtp(const observe::Frame& frame) {
  const std::size_t n = frame.outline.front.size();
  std::vector<std::int64_t> points;
  std::vector<std::int64_t> ends;
  std::size_t first = 0;
  for (const std::size_t end : observe::outline_ends(frame.outline)) {
    for (std::size_t i = first; i < end; ++i) points.push_back(static_cast<std::int64_t>(i));
    points.push_back(static_cast<std::int64_t>(first)); // back to the first
    ends.push_back(static_cast<std::int64_t>(points.size()));
    first = end;
  }
  return vtp(n, 0, ends.size(),
             points_of(frame.outline.x) + cells("Lines", points, ends) + fields_of("outline/", frame));
}

std::string anchors_vtp(const observe::Frame& frame) {
  const store::Anchors a = store::anchors(frame);
  return vtp(a.size(), a.size(), 0,
             points_of(a.x) + vertices(a.size()) + "<PointData>\n" + array("id", "UInt32", 1, a.id)
                 + array("f_mat", "Float32", 1, a.f_mat) + array("force", "Float32", 1, a.force) + "</PointData>\n");
}

std::string frame_file_name(const std::string& name, std::size_t k) { return fmt::format("{}_{:04}.vtp", name, k); }

std::string series_pvd(const std::string& name, const observe::Film& film) {
  std::string text = fmt::format(xml_head, "Collection") + "<Collection>\n";
  for (std::size_t k = 0; k < film.frames.size(); ++k)
    text +=
        fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", film.frames[k].t, frame_file_name(name, k));
  return text + "</Collection>\n</VTKFile>\n";
}

void write_vtk(const std::filesystem::path& folder, const observe::Film& film) {
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    write_file(folder / frame_file_name("matrix", k), matrix_vtp(film.head, film.frames[k]));
    write_file(folder / frame_file_name("outline", k), outline_vtp(film.frames[k]));
    write_file(folder / frame_file_name("anchors", k), anchors_vtp(film.frames[k]));
  }
  for (const char* name : {"matrix", "outline", "anchors"})
    write_file(folder / fmt::format("{}.pvd", name), series_pvd(name, film));
}

} // namespace matrigrate::exchange
