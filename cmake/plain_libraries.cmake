# Libraries whose packages bring no description for CMake, as targets; the names of those that are not there stand in
# matrigrate_missing. Used by the build, and by find_package(Matrigrate) of other projects.

set(matrigrate_missing "")
macro(matrigrate_plain_library name header libraries)
  string(TOUPPER ${name} upper)
  find_path(${upper}_INCLUDE_DIR ${header} PATH_SUFFIXES hdf5/serial)
  find_library(${upper}_LIBRARY NAMES ${libraries} PATH_SUFFIXES hdf5/serial)
  if(NOT ${upper}_INCLUDE_DIR OR NOT ${upper}_LIBRARY)
    list(APPEND matrigrate_missing ${name})
  elseif(NOT TARGET ${name}::${name})
    add_library(${name}::${name} UNKNOWN IMPORTED)
    set_target_properties(${name}::${name} PROPERTIES IMPORTED_LOCATION ${${upper}_LIBRARY}
                                                      INTERFACE_INCLUDE_DIRECTORIES ${${upper}_INCLUDE_DIR})
  endif()
endmacro()

matrigrate_plain_library(xxhash xxhash.h xxhash)
matrigrate_plain_library(hdf5 hdf5.h "hdf5_serial;hdf5") # CMake's own search would need a C compiler
matrigrate_plain_library(zlib zlib.h z) # likewise
matrigrate_plain_library(png png.h png)
matrigrate_plain_library(tiff tiffio.h tiff)
