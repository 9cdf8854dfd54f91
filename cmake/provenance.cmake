# What was built, from which commit, with what: written into build/provenance/build_info.hpp at every build.

set(MATRIGRATE_PROVENANCE_DIR ${PROJECT_BINARY_DIR}/provenance)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type_upper)
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type_upper}}" flags)
add_custom_target(
  matrigrate_build_info
  COMMAND
    ${CMAKE_COMMAND} -DSOURCE_DIR=${PROJECT_SOURCE_DIR} -DOUTPUT=${MATRIGRATE_PROVENANCE_DIR}/build_info.hpp
    -DVERSION=${PROJECT_VERSION} "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    "-DFLAGS=${flags}" -DBUILD_TYPE=${CMAKE_BUILD_TYPE} "-DSANITIZE=${MATRIGRATE_SANITIZE}" -P
    ${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake
  BYPRODUCTS ${MATRIGRATE_PROVENANCE_DIR}/build_info.hpp
  VERBATIM)
