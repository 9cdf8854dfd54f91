#pragma once

#include "observe/frame.hpp"

#include <filesystem>
#include <string>

/// Frames as files of VTK, in its XML form with compressed binary numbers, for programs that do not read fields.xdmf.
/// Test: tests/unit/exchange/vtk_files_test.cpp, tests/readers/vtp_reads.py
namespace matrigrate::exchange {

/// Particles of the matrix as points, with their fields and `solid` (1 or 0): a .vtp file.
std::string matrix_vtp(const observe::FrameHead& head, const observe::Frame& frame);

/// The cells as closed lines, with the fields of their particles: a .vtp file.
std::string outline_vtp(const observe::Frame& frame);

/// Where protrusions adhere as points, with `id`, `f_mat` and `force` [nN]: a .vtp file; without points where none
/// does.
std::string anchors_vtp(const observe::Frame& frame);

/// Names and times of a series of files: a .pvd file. File k is "<name>_0000.vtp", counted from 0; times in seconds.
std::string series_pvd(const std::string& name, const observe::Film& film);

/// "<name>_0007.vtp"
std::string frame_file_name(const std::string& name, std::size_t k);

/// Writes matrix.pvd, outline.pvd, anchors.pvd and their files.
/// @throws InputOutputError naming the path and the reason
void write_vtk(const std::filesystem::path& folder, const observe::Film& film);

} // namespace matrigrate::exchange
