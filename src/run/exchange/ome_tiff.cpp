#include "exchange/ome_tiff.hpp"

#include "base/failure.hpp"
#include "exchange/field_pictures.hpp"
#include "observe/even_times.hpp"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

namespace matrigrate::exchange {

namespace {

constexpr std::uint64_t most_of_a_classic_tiff = 3'500'000'000; // [bytes]

/// A file in memory, as libtiff asks for it.
struct Sink {
  std::string bytes;
  std::size_t at = 0;

  static Sink& of(thandle_t handle) { return *static_cast<Sink*>(handle); }
  static tmsize_t read(thandle_t handle, void* to, tmsize_t size) {
    Sink& sink = of(handle);
    const std::size_t got = sink.at < sink.bytes.size()
                                ? std::min(static_cast<std::size_t>(size), sink.bytes.size() - sink.at)
                                : std::size_t{0};
    std::memcpy(to, sink.bytes.data() + std::min(sink.at, sink.bytes.size()), got);
    sink.at += got;
    return static_cast<tmsize_t>(got);
  }
  static tmsize_t write(thandle_t handle, void* from, tmsize_t size) {
    Sink& sink = of(handle);
    const auto count = static_cast<std::size_t>(size);
    if (sink.at + count > sink.bytes.size()) sink.bytes.resize(sink.at + count);
    std::memcpy(sink.bytes.data() + sink.at, from, count);
    sink.at += count;
    return size;
  }
  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    Sink& sink = of(handle);
    if (whence == SEEK_CUR) offset += sink.at;
    if (whence == SEEK_END) offset += sink.bytes.size();
    sink.at = offset;
    return offset;
  }
  static int close(thandle_t /*handle*/) { return 0; }
  static toff_t size(thandle_t handle) { return of(handle).bytes.size(); }
};

using Tiff = std::unique_ptr<TIFF, void (*)(TIFF*)>;

void require(bool good) {
  if (!good) throw InputOutputError("libtiff cannot write the stack of fields");
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126)
      out += '?';
    else
      out += c;
  }
  return out;
}

/// The interval of the frames; 0 if they are not evenly spaced.
double interval(const observe::Film& film) {
  const observe::EvenTimes times = observe::even_times(observe::times_of(film));
  return times.is_even() ? times.interval : 0.0;
}

std::string ome_xml(const observe::Film& film, const std::vector<Channel>& all, const PixelGrid& grid,
                    const std::string& title, const std::string& version) {
  const double every = interval(film);
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\" "
      "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
      "xsi:schemaLocation=\"http://www.openmicroscopy.org/Schemas/OME/2016-06 "
      "http://www.openmicroscopy.org/Schemas/OME/2016-06/ome.xsd\" Creator=\"Matrigrate {}\">\n"
      "<Image ID=\"Image:0\" Name=\"{}\">\n<Pixels ID=\"Pixels:0\" DimensionOrder=\"XYCZT\" Type=\"float\" "
      "BigEndian=\"false\" SizeX=\"{}\" SizeY=\"{}\" SizeC=\"{}\" SizeZ=\"1\" SizeT=\"{}\" PhysicalSizeX=\"{}\" "
      "PhysicalSizeXUnit=\"&#181;m\" PhysicalSizeY=\"{}\" PhysicalSizeYUnit=\"&#181;m\"{}>\n",
      escaped(version), escaped(title), grid.side, grid.side, all.size(), film.frames.size(), grid.pixel, grid.pixel,
      every > 0.0 ? fmt::format(" TimeIncrement=\"{}\" TimeIncrementUnit=\"s\"", every) : "");
  for (std::size_t c = 0; c < all.size(); ++c)
    text += fmt::format("<Channel ID=\"Channel:0:{}\" Name=\"{}{}\" SamplesPerPixel=\"1\"/>\n", c, all[c].name,
                        all[c].unit == "1" ? "" : fmt::format(" [{}]", all[c].unit));
  text += fmt::format("<TiffData IFD=\"0\" PlaneCount=\"{}\"/>\n", all.size() * film.frames.size());
  for (std::size_t t = 0; t < film.frames.size(); ++t)
    for (std::size_t c = 0; c < all.size(); ++c)
      text += fmt::format("<Plane TheZ=\"0\" TheT=\"{}\" TheC=\"{}\" DeltaT=\"{}\" DeltaTUnit=\"s\"/>\n", t, c,
                          film.frames[t].t);
  return text + "</Pixels>\n</Image>\n</OME>\n";
}

void write_page(TIFF* tiff, const std::vector<float>& pixels, const PixelGrid& grid, const std::string& description) {
  const auto side = static_cast<std::uint32_t>(grid.side);
  const auto set = [&](std::uint32_t tag, auto value) { require(TIFFSetField(tiff, tag, value) != 0); };
  if (!description.empty()) set(TIFFTAG_IMAGEDESCRIPTION, description.c_str());
  set(TIFFTAG_IMAGEWIDTH, side);
  set(TIFFTAG_IMAGELENGTH, side);
  set(TIFFTAG_ROWSPERSTRIP, side);
  set(TIFFTAG_BITSPERSAMPLE, 32);
  set(TIFFTAG_SAMPLESPERPIXEL, 1);
  set(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  set(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  set(TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  set(TIFFTAG_RESOLUTIONUNIT, RESUNIT_CENTIMETER);
  set(TIFFTAG_XRESOLUTION, 1e4 / grid.pixel); // for programs that do not read OME's description
  set(TIFFTAG_YRESOLUTION, 1e4 / grid.pixel);
  std::vector<float> copy = pixels; // libtiff may change what it is given
  const auto bytes = static_cast<tmsize_t>(copy.size() * sizeof(float));
  require(TIFFWriteEncodedStrip(tiff, 0, copy.data(), bytes) == bytes);
  require(TIFFWriteDirectory(tiff) != 0);
}

} // namespace

std::string ome_tiff(const observe::Film& film, double pixel, const std::string& title, const std::string& version) {
  const PixelGrid grid = PixelGrid::over(film.head, pixel);
  const std::vector<Channel> all = channels(film);
  const std::uint64_t size = std::uint64_t{grid.side} * grid.side * sizeof(float) * all.size() * film.frames.size();
  Sink sink;
  {
    const Tiff tiff(TIFFClientOpen("stack", size > most_of_a_classic_tiff ? "w8l" : "wl", &sink, &Sink::read,
                                   &Sink::write, &Sink::seek, &Sink::close, &Sink::size, nullptr, nullptr),
                    TIFFClose);
    require(tiff != nullptr);
    std::string description = ome_xml(film, all, grid, title, version);
    for (const observe::Frame& frame : film.frames) {
      const std::vector<std::size_t> nearest = nearest_particles(film.head, frame, grid);
      for (const Channel& channel : all) {
        write_page(tiff.get(), picture(channel, frame, grid, nearest), grid, description);
        description.clear();
      }
    }
  }
  return std::move(sink.bytes);
}

} // namespace matrigrate::exchange
