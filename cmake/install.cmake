# What `cmake --install` puts below its prefix: program, libraries, headers, what find_package(Matrigrate) needs,
# scenarios and studies, completions, manual page, licence. Headers keep their folders below include/matrigrate/, which
# is an include directory of every target: #include "simulation/advance.hpp" is right in the tree and outside of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Matrigrate)
set(data ${CMAKE_INSTALL_DATADIR}/matrigrate)

get_property(libraries GLOBAL PROPERTY MATRIGRATE_LIBRARIES)
install(TARGETS matrigrate)
install(TARGETS ${libraries} EXPORT MatrigrateTargets
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/matrigrate)
install(EXPORT MatrigrateTargets NAMESPACE Matrigrate:: DESTINATION ${package})

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/MatrigrateConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/package/MatrigrateConfig.cmake
                              INSTALL_DESTINATION ${package} PATH_VARS data)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/MatrigrateConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/MatrigrateConfig.cmake
              ${PROJECT_BINARY_DIR}/package/MatrigrateConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/plain_libraries.cmake
        DESTINATION ${package})

install(DIRECTORY scenarios studies DESTINATION ${data} FILES_MATCHING PATTERN *.toml PATTERN *.png)
install(FILES docs/scenario.schema.json DESTINATION ${data}/docs) # where the scenarios look for it
# The live page: as web/build.sh makes it; that of a source archive; that of the last release. It holds its own licences.
set(MATRIGRATE_LIVE_PAGE ${PROJECT_SOURCE_DIR}/live/index.html)
foreach(page build/web/live/index.html pages/live.html)
  if(EXISTS ${PROJECT_SOURCE_DIR}/${page})
    set(MATRIGRATE_LIVE_PAGE ${PROJECT_SOURCE_DIR}/${page})
  endif()
endforeach()
install(FILES ${MATRIGRATE_LIVE_PAGE} DESTINATION ${data} RENAME live.html OPTIONAL) # looked for by apps/live.cpp
install(FILES LICENSE NOTICES DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES man/matrigrate.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES completions/matrigrate.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
        RENAME matrigrate)
install(FILES completions/_matrigrate DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES completions/matrigrate.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

# `cpack` in the folder of a build (`cpack --config build/release/CPackConfig.cmake`) makes a Debian package of what
# `cmake --install` installs: program, libraries, headers, Python package, manual page, completions, schema, studies.
install(DIRECTORY python/matrigrate DESTINATION lib/python3/dist-packages # Debian's place for every version of Python 3
        FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed
        PATTERN __pycache__ EXCLUDE)
install(FILES docs/scenario.schema.json docs/readouts.json viewer/src/colours.json DESTINATION lib/python3/dist-packages/matrigrate)
find_program(MATRIGRATE_PYTHON python3) # writes the types of the package, for editors
if(MATRIGRATE_PYTHON)
  install(CODE "execute_process(COMMAND ${MATRIGRATE_PYTHON} -B ${CMAKE_SOURCE_DIR}/tools/stubs.py
    \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages/matrigrate/scenario/sections.pyi COMMAND_ERROR_IS_FATAL ANY)")
endif()
install(DIRECTORY R/ DESTINATION ${data}/R) # R CMD INSTALL /usr/share/matrigrate/R
install(FILES CITATION.cff MODEL.md README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.md)
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN *.cpp PATTERN *.md)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME matrigrate)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of a cell that migrates through a degradable matrix")
set(CPACK_PACKAGE_DESCRIPTION
    "Simulates in two dimensions how a single cell migrates through a degradable viscoelastic extracellular matrix, after
Heck et al. 2020 (PLoS Comput Biol 16(1): e1007250), with studies of many runs and their statistics. Contains the program, a Python package that
reads results and calls the program, an R package, and the libraries with their headers.")
set(CPACK_PACKAGE_CONTACT "The Matrigrate authors") # becomes Maintainer; there is no address
set(CPACK_PACKAGE_FILE_NAME matrigrate_${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT) # matrigrate_0.3.0_amd64.deb
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # the shared libraries that the program needs, by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3, python3-pandas, python3-h5py, python3-matplotlib, python3-xxhash")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS # for movies and figures; for projects that use the libraries
    "nodejs, chromium, ffmpeg, g++, cmake, libeigen3-dev, libfmt-dev, libtbb-dev, libtomlplusplus-dev, nlohmann-json3-dev, libhdf5-dev, libmuparser-dev, libpng-dev, libtiff-dev, libboost-math-dev, libxxhash-dev, zlib1g-dev")

# What a wheel of Python holds beside the package: `cmake --install build/release --component wheel --prefix FOLDER`. Other installations
# leave it out. scikit-build-core installs it so (pyproject.toml).
if(TARGET matrigrate_python)
  find_package(Python3 COMPONENTS Interpreter QUIET)
  install(TARGETS matrigrate RUNTIME DESTINATION matrigrate/bin COMPONENT wheel EXCLUDE_FROM_ALL)
  install(TARGETS matrigrate_python LIBRARY DESTINATION matrigrate COMPONENT wheel EXCLUDE_FROM_ALL)
  install(FILES docs/scenario.schema.json docs/readouts.json viewer/src/colours.json DESTINATION matrigrate COMPONENT wheel EXCLUDE_FROM_ALL)
  install(FILES ${MATRIGRATE_LIVE_PAGE} DESTINATION matrigrate RENAME live.html COMPONENT wheel EXCLUDE_FROM_ALL OPTIONAL)
  install(CODE "execute_process(COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/tools/stubs.py
    \${CMAKE_INSTALL_PREFIX}/matrigrate/scenario/sections.pyi COMMAND_ERROR_IS_FATAL ANY)" COMPONENT wheel EXCLUDE_FROM_ALL)
  if(SKBUILD)
    install(PROGRAMS python/command/matrigrate DESTINATION ${SKBUILD_SCRIPTS_DIR} COMPONENT wheel EXCLUDE_FROM_ALL)
  endif()
elseif(SKBUILD)
  message(FATAL_ERROR "A wheel needs pybind11 and the headers of Python.")
endif()

include(CPack)
