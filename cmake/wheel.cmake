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
