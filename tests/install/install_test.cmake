# Installs into a prefix of its own; builds examples/04_my_force.cpp against it outside of the tree, by the lines of
# examples/README.md, and a program that includes every installed header; runs both.
#   cmake -DSOURCE_DIR=... -DBINARY_DIR=... -DFOLDER=... -DCOMPILER=... -DGENERATOR=... -P install_test.cmake
cmake_minimum_required(VERSION 3.25)
set(prefix ${FOLDER}/prefix)
set(project ${FOLDER}/project)
file(REMOVE_RECURSE ${FOLDER})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${text}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BINARY_DIR} --prefix ${prefix})

# A build of the program alone, as ./demo makes it, can be installed: the module of Python may be missing.
file(READ ${BINARY_DIR}/python/core/cmake_install.cmake rule)
if(rule MATCHES "TYPE MODULE" AND NOT rule MATCHES "TYPE MODULE OPTIONAL FILES")
  message(SEND_ERROR "the module of Python is not optional: a build of the program alone could not be installed")
endif()

# The live page is installed, and found by the program, also by the one that was built in a clone.
foreach(way "${prefix}/bin/matrigrate=${prefix}/share/matrigrate/live.html" "${BINARY_DIR}/bin/matrigrate=${SOURCE_DIR}")
  string(REPLACE "=" ";" way "${way}")
  list(GET way 0 program)
  list(GET way 1 there)
  execute_process(COMMAND ${program} live --print RESULT_VARIABLE result OUTPUT_VARIABLE page OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(FIND "${page}" "${there}" begin)
  if(NOT result EQUAL 0 OR NOT begin EQUAL 0)
    message(SEND_ERROR "${program} has no live page: ${page}")
  endif()
endforeach()

# All files are there; those of the package name no folder of this build.
set(expected bin/matrigrate share/matrigrate/docs/scenario.schema.json share/man/man1/matrigrate.1
             share/doc/matrigrate/LICENSE share/doc/matrigrate/NOTICES share/bash-completion/completions/matrigrate
             share/zsh/site-functions/_matrigrate share/fish/vendor_completions.d/matrigrate.fish)
file(GLOB_RECURSE headers RELATIVE ${SOURCE_DIR}/src ${SOURCE_DIR}/src/*.hpp)
file(GLOB_RECURSE inputs RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/scenarios/*.toml ${SOURCE_DIR}/studies/*.toml)
foreach(library model/ run/observe/ run/tables/ run/store/ run/exchange/ run/draw/ run/report/ study/study_plan/ study/study_results/ study/study_runs/ study/claims/ study/study_report/)
  string(REGEX MATCH "^[a-z]+/" wing ${library}) # headers are installed by the path that includes them
  string(LENGTH ${wing} length)
  string(SUBSTRING ${library} ${length} -1 name)
  list(TRANSFORM headers REPLACE "^${wing}${name}" "${name}")
endforeach()
list(TRANSFORM headers PREPEND include/matrigrate/ OUTPUT_VARIABLE installed_headers)
list(TRANSFORM inputs PREPEND share/matrigrate/)
foreach(file ${expected} ${installed_headers} ${inputs})
  if(NOT EXISTS ${prefix}/${file})
    message(SEND_ERROR "not installed: ${file}")
  endif()
endforeach()
file(GLOB_RECURSE package ${prefix}/*.cmake)
foreach(file ${package})
  file(READ ${file} text)
  foreach(word ${SOURCE_DIR} ${BINARY_DIR} matrigrate_options -Werror)
    string(FIND "${text}" "${word}" place)
    if(NOT place EQUAL -1)
      message(SEND_ERROR "${file} names ${word}")
    endif()
  endforeach()
endforeach()
run(${prefix}/bin/matrigrate check ${prefix}/share/matrigrate/scenarios/baseline.toml)

# The other project.
file(READ ${SOURCE_DIR}/examples/README.md page)
if(NOT page MATCHES "```cmake\n([^`]*)```")
  message(FATAL_ERROR "examples/README.md has no lines for CMake")
endif()
set(lines "${CMAKE_MATCH_1}")
list(TRANSFORM headers REPLACE "(.+)" "#include \"\\1\"" OUTPUT_VARIABLE includes)
list(JOIN includes "\n" includes)
file(WRITE ${project}/all_headers.cpp "${includes}
int main() { return matrigrate::run::provenance().contains(\"git_hash\") ? 0 : 1; }
")
file(WRITE ${project}/CMakeLists.txt "${lines}
add_executable(all_headers all_headers.cpp)
target_link_libraries(all_headers PRIVATE Matrigrate::validation Matrigrate::study_report)
")
file(COPY ${SOURCE_DIR}/examples/04_my_force.cpp DESTINATION ${project})
run(${CMAKE_COMMAND} -S ${project} -B ${project}/build -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${project}/build)
run(${project}/build/my_force)
run(${project}/build/all_headers)
file(REMOVE_RECURSE ${FOLDER})
