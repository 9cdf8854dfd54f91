# The study files of studies/ go into the program: written into build/studies/shipped_studies.cpp.

file(GLOB study_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/studies/*.toml)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${study_files})
set(entries "")
foreach(file ${study_files})
  get_filename_component(name ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND entries "      {\"${name}\", R\"study(${text})study\"},\n")
endforeach()
set(MATRIGRATE_SHIPPED_STUDIES ${PROJECT_BINARY_DIR}/studies/shipped_studies.cpp)
file(
  CONFIGURE
  OUTPUT ${MATRIGRATE_SHIPPED_STUDIES}
  CONTENT
    "#include \"claims/shipped_studies.hpp\"\n
namespace matrigrate::study {\n
std::span<const ShippedStudy> shipped_studies() {
  static const std::vector<ShippedStudy> all{
@entries@  };
  return all;
}\n
} // namespace matrigrate::study\n"
  @ONLY)
