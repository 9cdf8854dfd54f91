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
