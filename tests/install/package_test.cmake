# Makes the Debian package, takes it apart, and runs its program.
#   cmake -DSOURCE_DIR=... -DBINARY_DIR=... -DFOLDER=... -P package_test.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${FOLDER})
find_program(DPKG_DEB dpkg-deb)
find_program(DPKG_SHLIBDEPS dpkg-shlibdeps)
if(NOT DPKG_DEB OR NOT DPKG_SHLIBDEPS)
  message("skipped: no dpkg-deb or dpkg-shlibdeps (package dpkg-dev)")
  return()
endif()

function(run out)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE error)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${result}:\n${text}${error}")
  endif()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

run(text ${CMAKE_CPACK_COMMAND} --config ${BINARY_DIR}/CPackConfig.cmake -B ${FOLDER}/made)
file(GLOB package ${FOLDER}/made/matrigrate_*.deb)
run(control ${DPKG_DEB} --field ${package} Package Depends Recommends Suggests)
foreach(word "Package: matrigrate" libhdf5 libtbb libfmt libc6 python3-pandas nodejs chromium ffmpeg libmuparser-dev libpng-dev libtiff-dev)
  string(FIND "${control}" "${word}" place)
  if(place EQUAL -1)
    message(SEND_ERROR "the package does not name ${word}:\n${control}")
  endif()
endforeach()
run(text ${DPKG_DEB} -x ${package} ${FOLDER}/unpacked)
foreach(file bin/matrigrate include/matrigrate/simulation/advance.hpp lib/python3/dist-packages/matrigrate/__init__.py
             lib/python3/dist-packages/matrigrate/scenario.schema.json lib/python3/dist-packages/matrigrate/readouts.json lib/python3/dist-packages/matrigrate/colours.json
             lib/python3/dist-packages/matrigrate/scenario/sections.pyi share/man/man1/matrigrate.1
             share/bash-completion/completions/matrigrate share/matrigrate/studies/stiffness.toml
             share/matrigrate/R/matrigrate.R share/matrigrate/R/DESCRIPTION share/matrigrate/R/R/read.R share/matrigrate/R/man/read_tracks.Rd
             share/doc/matrigrate/LICENSE share/doc/matrigrate/CITATION.cff
             share/doc/matrigrate/MODEL.md share/doc/matrigrate/docs/tutorial.md share/doc/matrigrate/examples/04_my_force.cpp)
  if(NOT EXISTS ${FOLDER}/unpacked/usr/${file} AND NOT EXISTS ${FOLDER}/unpacked/usr/${file}.gz)
    message(SEND_ERROR "not in the package: /usr/${file}")
  endif()
endforeach()
file(GLOB_RECURSE caches ${FOLDER}/unpacked/*.pyc)
if(caches)
  message(SEND_ERROR "in the package: ${caches}")
endif()
run(text ${FOLDER}/unpacked/usr/bin/matrigrate check ${FOLDER}/unpacked/usr/share/matrigrate/scenarios/baseline.toml)

# The recipes of containers take their lists of packages from tools/setup.sh, and name files that exist.
foreach(recipe Dockerfile matrigrate.def)
  file(READ ${SOURCE_DIR}/packaging/${recipe} text)
  foreach(word "tools/setup.sh" "install_packages \"$packages_to_build$packages_for_simulation\"" "--preset release" CPackConfig.cmake debian:12)
    string(FIND "${text}" "${word}" place)
    if(place EQUAL -1)
      message(SEND_ERROR "packaging/${recipe} lacks ${word}")
    endif()
  endforeach()
endforeach()
