#include "io/vtk_files.hpp"

#include "base/file.hpp"

#include <fmt/format.h>

#include <iterator>

namespace matrigrate::io {

namespace {

constexpr std::string_view xml_head = "<?xml version=\"1.0\"?>\n<VTKFile type=\"{}\" version=\"1.0\" "
                                      "byte_order=\"LittleEndian\">\n";

template <class Numbers>
std::string array(std::string_view name, std::string_view type, std::uint32_t components, const Numbers& values) {
  std::string text = fmt::format("<DataArray Name=\"{}\" type=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
                                 name, type, components == 2 ? 3 : components);
  for (std::size_t i = 0; i < values.size(); ++i)
    fmt::format_to(std::back_inserter(text), "{}{}", values[i], components == 2 && i % 2 == 1 ? " 0\n" : " ");
  return text + "\n</DataArray>\n";
}

/// The fields of one body.
std::string fields_of(std::string_view body, const Frame& frame) {
  std::string text = "<PointData>\n";
  for (const auto& field : float_fields())
    if (field.name.starts_with(body) && !field.name.ends_with("/position") && !field.in(frame).empty())
      text += array(field.name.substr(body.size()), "Float32", field.components, field.in(frame));
  for (const auto& field : byte_fields())
    if (field.name.starts_with(body))
      text += array(field.name.substr(body.size()), "UInt8", field.components, field.in(frame));
  return text + "</PointData>\n";
}

/// Cells: `connectivity` and `offsets` of vertices or lines.
std::string cells(std::string_view kind, const std::vector<std::size_t>& points, const std::vector<std::size_t>& ends) {
  return fmt::format("<{0}>\n{1}{2}</{0}>\n", kind, array("connectivity", "Int64", 1, points),
                     array("offsets", "Int64", 1, ends));
}

std::string vtp(std::size_t points, std::size_t vertices, std::size_t lines, const std::string& content) {
  return fmt::format(xml_head, "PolyData")
         + fmt::format("<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" "
                       "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n{}</Piece>\n</PolyData>\n</VTKFile>\n",
                       points, vertices, lines, content);
}

std::string points_of(const Floats& x) { return "<Points>\n" + array("position", "Float32", 2, x) + "</Points>\n"; }

} // namespace

std::string matrix_vtp(const FrameHead& head, const Frame& frame) {
  Floats x = frame.matrix.displacement;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += head.reference[i];
  const std::size_t n = head.particles();
  std::vector<std::size_t> points(n);
  std::vector<std::size_t> ends(n);
  for (std::size_t i = 0; i < n; ++i) {
    points[i] = i;
    ends[i] = i + 1;
  }
  return vtp(n, n, 0, points_of(x) + cells("Verts", points, ends) + fields_of("matrix/", frame));
}

std::string outline_vtp(const Frame& frame) {
  const std::size_t n = frame.outline.front.size();
  std::vector<std::size_t> points(n + 1, 0); // back to the first
  for (std::size_t i = 0; i < n; ++i) points[i] = i;
  return vtp(n, 0, 1, points_of(frame.outline.x) + cells("Lines", points, {n + 1}) + fields_of("outline/", frame));
}

std::string frame_file_name(const std::string& name, std::size_t k) { return fmt::format("{}_{:04}.vtp", name, k); }

std::string series_pvd(const std::string& name, const Film& film) {
  std::string text = fmt::format(xml_head, "Collection") + "<Collection>\n";
  for (std::size_t k = 0; k < film.frames.size(); ++k)
    text +=
        fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", film.frames[k].t, frame_file_name(name, k));
  return text + "</Collection>\n</VTKFile>\n";
}

void write_vtk(const std::filesystem::path& folder, const Film& film) {
  for (std::size_t k = 0; k < film.frames.size(); ++k) {
    write_file(folder / frame_file_name("matrix", k), matrix_vtp(film.head, film.frames[k]));
    write_file(folder / frame_file_name("outline", k), outline_vtp(film.frames[k]));
  }
  write_file(folder / "matrix.pvd", series_pvd("matrix", film));
  write_file(folder / "outline.pvd", series_pvd("outline", film));
}

} // namespace matrigrate::io
