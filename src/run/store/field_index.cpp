#include "store/field_file.hpp"

#include <fmt/format.h>

namespace matrigrate::store {

namespace {

/// An array at frame k.
std::string item(std::string_view name, std::string_view type, std::size_t k, std::size_t n, int components) {
  return fmt::format("<DataItem Dimensions=\"{}{}\" {} Format=\"HDF\">{}:{}</DataItem>", n, components == 3 ? " 3" : "",
                     type, field_file_name, frame_path(k, fmt::format("/{}", name)));
}

constexpr std::string_view floating = "NumberType=\"Float\" Precision=\"4\"";
constexpr std::string_view bytes = "NumberType=\"UChar\" Precision=\"1\"";
constexpr std::string_view whole_numbers = "NumberType=\"UInt\" Precision=\"4\"";

std::string attribute(std::string_view name, std::string_view type, std::size_t k, std::size_t n, int components) {
  return fmt::format("        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"Node\">{}</Attribute>\n",
                     name.substr(name.find('/') + 1), components == 3 ? "Vector" : "Scalar",
                     item(name, type, k, n, components));
}

/// All fields of one body; all frames have the same.
std::string attributes(std::string_view body, const observe::Frame& frame, std::size_t k, std::size_t n) {
  std::string text;
  for (const auto& field : observe::float_fields())
    if (field.name.starts_with(body) && field.name != "outline/position" && !field.in(frame).empty())
      text += attribute(field.name, floating, k, n, field.components == 2 ? 3 : 1);
  for (const auto& field : observe::byte_fields())
    if (field.name.starts_with(body)) text += attribute(field.name, bytes, k, n, 1);
  return text;
}

/// @param fields  its attributes
std::string grid(std::string_view name, const std::string& topology, double t, std::size_t k, std::size_t n,
                 const std::string& fields) {
  return fmt::format("      <Grid Name=\"{0}\" GridType=\"Uniform\">\n        <Time Value=\"{1}\"/>\n        {2}\n"
                     "        <Geometry GeometryType=\"XYZ\">{3}</Geometry>\n{4}      </Grid>\n",
                     name, t, topology, item(fmt::format("{}/position", name), floating, k, n, 3), fields);
}

std::string points(std::size_t n) {
  return fmt::format("<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{}\" NodesPerElement=\"1\"/>", n);
}

/// A line around each cell. All cells have as many particles.
std::string closed_lines(const observe::OutlineFrame& outline) {
  const std::vector<std::size_t> ends = observe::outline_ends(outline);
  std::string points;
  std::size_t first = 0;
  for (const std::size_t end : ends) {
    for (std::size_t i = first; i <= end; ++i) points += fmt::format("{} ", i == end ? first : i);
    first = end;
  }
  return fmt::format("<Topology TopologyType=\"Polyline\" NumberOfElements=\"{0}\" NodesPerElement=\"{1}\">"
                     "<DataItem Dimensions=\"{0} {1}\" NumberType=\"Int\" Format=\"XML\">{2}</DataItem></Topology>",
                     ends.size(), ends.front() + 1, points);
}

std::string collection(std::string_view name, const std::string& grids) {
  return fmt::format("    <Grid Name=\"{}\" GridType=\"Collection\" CollectionType=\"Temporal\">\n{}    </Grid>\n",
                     name, grids);
}

/// Readers find none at a time that is left out, and some of them stumble over a grid of no points.
std::string anchor_grids(std::span<const double> times, std::span<const std::size_t> anchors) {
  std::string text;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const std::size_t n = anchors[k];
    if (n == 0) continue;
    text += grid("anchors", points(n), times[k], k, n,
                 attribute("anchors/id", whole_numbers, k, n, 1) + attribute("anchors/f_mat", floating, k, n, 1)
                     + attribute("anchors/force", floating, k, n, 1));
  }
  return text;
}

} // namespace

std::string field_index(const observe::Frame* first, std::span<const double> times,
                        std::span<const std::size_t> anchors) {
  std::string text = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"2.0\">\n  <Domain>\n";
  if (first != nullptr) {
    const std::size_t n = first->matrix.f_degr.size();
    const std::size_t m = first->outline.front.size();
    const std::string lines = m > 0 ? closed_lines(first->outline) : std::string();
    std::string matrix;
    std::string outline;
    for (std::size_t k = 0; k < times.size(); ++k) {
      matrix += grid("matrix", points(n), times[k], k, n,
                     attributes("matrix/", *first, k, n) + attribute("matrix/solid", bytes, k, n, 1));
      if (m > 0) outline += grid("outline", lines, times[k], k, m, attributes("outline/", *first, k, m));
    }
    text += collection("matrix", matrix);
    if (m > 0) text += collection("outline", outline);
    if (const std::string adhesions = anchor_grids(times, anchors); !adhesions.empty())
      text += collection("anchors", adhesions);
  }
  return text + "  </Domain>\n</Xdmf>\n";
}

} // namespace matrigrate::store
