#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// What the tests of the structure know about C++ and CMake text: just enough, line by line.
namespace matrigrate::structure {

/// A file of src/.
struct Source {
  std::string path; ///< as it is included: "draw/text_plot.hpp"
  std::string text;
  std::string wing{}; ///< the folder of src/ that holds the library, "run", or nothing where that is src/ itself
  std::string folder() const { return path.substr(0, path.find('/')); }
};

/// For each folder the folders that it names, or that it may include.
using Graph = std::map<std::string, std::set<std::string>>;

/// The folders that are libraries, as the wings' CMakeLists.txt declare them: src/base, src/model/ecm, ...
/// @throws std::runtime_error if one has neither the name of its wing nor a folder in it
std::map<std::string, std::filesystem::path> libraries(const std::filesystem::path& src);

/// All .hpp and .cpp files below `src`, in alphabetical order; below a library, paths begin with its name.
/// @throws std::runtime_error if one cannot be read
std::vector<Source> sources(const std::filesystem::path& src);

/// The edges declared by matrigrate_folder(NAME DEPENDS matrigrate_OTHER ...) in the wings' CMakeLists.txt.
Graph declared_edges(const std::filesystem::path& src);

/// The folders of src/ in the order of its CMakeLists.txt.
std::vector<std::string> wings(const std::filesystem::path& src);

/// The folders that a CMakeLists.txt declares, and those that they name.
Graph declared_folders(std::string_view cmake);

/// Each folder with all that it reaches; a folder on a cycle reaches itself.
Graph closure(const Graph& edges);

/// The text with comments blanked out and, unless `keep_strings`, the inside of string and character literals too; line
/// numbers stay.
std::string code_only(std::string_view text, bool keep_strings = false);

/// A place that breaks a rule: "draw/text_plot.cpp:12: what is wrong".
using Findings = std::vector<std::string>;

/// Includes of headers in folders that are not allowed, or not named by their path from src/.
Findings forbidden_includes(const Source& source, const Graph& allowed);

/// For each file what it includes, itself or through headers of ours: these by their paths, those of libraries in angle
/// brackets.
Graph reached_includes(const std::vector<Source>& all);

/// Functions of more lines than so many, from the line of their name or type to the brace that ends them. Only those
/// that begin at the left edge count; what a class defines inside is short.
Findings long_functions(const Source& source, int most_lines);

/// Common names of libraries (std::vector, fmt::) that a file uses without including, itself or through headers of
/// ours, what declares them.   @param reached  of reached_includes()
Findings undeclared_names(const Source& source, const Graph& reached);

/// Calls that end the program: only apps/ may.
Findings process_exits(const Source& source);

/// Preprocessor lines other than #include and #pragma once.
Findings preprocessor_use(const Source& source);

/// Variables that outlive a call and can be changed.
Findings mutable_globals(const Source& source);

} // namespace matrigrate::structure
