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
include(CPack)
