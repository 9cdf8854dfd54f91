# TOML files that the program carries with it: studies, templates of cells and gels.

# matrigrate_shipped(TARGET FOLDER HEADER NAMESPACE TYPE FUNCTION) adds to a library what its HEADER declares as
# NAMESPACE::FUNCTION: the name, without its ending, and the text of each file in FOLDER, as a span of TYPE.
function(matrigrate_shipped target folder header namespace type function)
  file(GLOB files CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../${folder}/*.toml)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files})
  set(entries "")
  foreach(file ${files})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND entries "      {\"${name}\", R\"toml(${text})toml\"},\n")
  endforeach()
  set(source ${PROJECT_BINARY_DIR}/shipped/${function}.cpp)
  file(
    CONFIGURE
    OUTPUT ${source}
    CONTENT
      "#include \"@header@\"\n
namespace @namespace@ {\n
std::span<const @type@> @function@() {
  static const std::vector<@type@> all{
@entries@  };
  return all;
}\n
} // namespace @namespace@\n"
    @ONLY)
  target_sources(${target} PRIVATE ${source})
endfunction()
