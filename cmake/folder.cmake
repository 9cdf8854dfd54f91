# What every target of this project is compiled with, and how a folder of src/ becomes a library.

# Other compilers warn of other things: who builds a release's archive, which has the file COMMIT, need not mend that.
set(warnings_stop ON)
if(EXISTS ${PROJECT_SOURCE_DIR}/COMMIT)
  set(warnings_stop OFF)
endif()
option(MATRIGRATE_WARNINGS_ARE_ERRORS "Stop at a compiler's warning" ${warnings_stop})

add_library(matrigrate_options INTERFACE)
target_compile_options(
  matrigrate_options
  INTERFACE -Wall -Wextra -Wpedantic $<$<BOOL:${MATRIGRATE_WARNINGS_ARE_ERRORS}>:-Werror> -Wshadow
            -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual
            -ffp-contract=off # the same bits wherever the same additions are made
            -fno-math-errno
            -fno-semantic-interposition # functions may be inlined although libraries are position independent
            $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>) # GCC 12 warns falsely on std::string (GCC bug 105651)
if(CMAKE_UNITY_BUILD) # several sources at a time: names that one hides from the other; the preset dev looks for them
  target_compile_options(matrigrate_options INTERFACE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()

# Mark for hot loops. MATRIGRATE_SIMD: compile this function for newer instruction sets as well; the loader picks the
# best one for the machine, and the bits are the same, since no operations are fused and all keep their order.
set(simd "")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64"
   AND NOT MATRIGRATE_SANITIZE) # sanitizers start later than the choice
  set(simd "__attribute__((target_clones(\"arch=x86-64-v3\",\"default\")))")
endif()
target_compile_definitions(matrigrate_options INTERFACE "MATRIGRATE_SIMD=${simd}")

if(MATRIGRATE_SANITIZE)
  target_compile_options(matrigrate_options INTERFACE -fsanitize=${MATRIGRATE_SANITIZE} -fno-omit-frame-pointer
                                                      -fno-sanitize-recover=all
                                                      $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>) # false with sanitizers
  target_link_options(matrigrate_options INTERFACE -fsanitize=${MATRIGRATE_SANITIZE})
endif()

# Headers that most sources include, compiled once for each level of optimisation. Sources still include what they use:
# presets without precompiled headers (CMAKE_DISABLE_PRECOMPILE_HEADERS) compile them so. The headers of CLI11 and
# nlohmann/json in it make it so large that all else becomes slower.
set(prelude <Eigen/Core> <fmt/format.h> <algorithm> <cmath> <filesystem> <functional> <map> <memory> <numeric> <optional>
            <span> <string> <string_view> <variant> <vector>)
set(optimisation_hot "") # what a step of the simulation runs: -O3
set(optimisation_light $<$<CONFIG:Release>:-O1>) # all else
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/prelude.cpp CONTENT "")
foreach(kind hot light)
  add_library(matrigrate_prelude_${kind} OBJECT ${PROJECT_BINARY_DIR}/prelude.cpp)
  target_link_libraries(matrigrate_prelude_${kind} PRIVATE matrigrate_options Eigen3::Eigen fmt::fmt)
  target_compile_options(matrigrate_prelude_${kind} PRIVATE ${optimisation_${kind}})
  target_precompile_headers(matrigrate_prelude_${kind} PRIVATE ${prelude})
endforeach()

# matrigrate_prelude(TARGET hot|light) compiles a target so.
function(matrigrate_prelude target kind)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "EXECUTABLE") # compiled as the libraries are, or it could not use their precompiled headers
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${target} PRIVATE -fPIC)
  endif()
  target_link_libraries(${target} PRIVATE Eigen3::Eigen fmt::fmt)
  target_compile_options(${target} PRIVATE ${optimisation_${kind}})
  target_precompile_headers(${target} REUSE_FROM matrigrate_prelude_${kind})
endfunction()

# matrigrate_folder(NAME [LIGHT] DEPENDS target...) makes the library matrigrate_NAME of all sources in the subfolder NAME,
# or in the current folder of that name, and in those of its subfolders that have not become libraries before; LIGHT if no
# step of the simulation runs them.
# Headers are included by their path from the folder above: "ecm/loop/stress.hpp" is src/model/ecm/loop/stress.hpp.
# The folders named in DEPENDS are the only ones whose headers it may include (tests/structure checks it).
function(matrigrate_folder name)
  cmake_parse_arguments(arg "LIGHT" "" "DEPENDS" ${ARGN})
  set(folder ${CMAKE_CURRENT_SOURCE_DIR})
  if(IS_DIRECTORY ${folder}/${name})
    cmake_path(APPEND folder ${name})
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*/*.cpp)
  file(GLOB headers CONFIGURE_DEPENDS ${folder}/*.hpp ${folder}/*/*.hpp)
  get_property(libraries GLOBAL PROPERTY MATRIGRATE_FOLDERS)
  foreach(library ${libraries})
    list(FILTER sources EXCLUDE REGEX "^${library}/")
    list(FILTER headers EXCLUDE REGEX "^${library}/")
  endforeach()
  set_property(GLOBAL APPEND PROPERTY MATRIGRATE_FOLDERS ${folder})
  cmake_path(GET folder PARENT_PATH above)
  set(target matrigrate_${name})
  set(scope PUBLIC)
  if(sources)
    add_library(${target} STATIC ${sources})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${above} FILES ${headers})
  target_link_libraries(${target} ${scope} $<BUILD_INTERFACE:matrigrate_options> ${arg_DEPENDS})
  target_compile_features(${target} ${scope} cxx_std_20) # for targets of other projects: cmake/install.cmake
  target_compile_options(${target} INTERFACE $<INSTALL_INTERFACE:-ffp-contract=off>) # laws stand in headers, too
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  add_library(Matrigrate::${name} ALIAS ${target})
  set_property(GLOBAL APPEND PROPERTY MATRIGRATE_LIBRARIES ${target})
  set_property(GLOBAL APPEND PROPERTY MATRIGRATE_HEADERS ${headers})
  if(arg_LIGHT)
    matrigrate_prelude(${target} light)
  elseif(sources)
    matrigrate_prelude(${target} hot)
  endif()
endfunction()
