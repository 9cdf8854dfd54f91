# The pages of viewer/ become part of the program: built by npm below build/viewer, or ready-made ones are taken. The archive of
# a release (tools/release.sh) holds them in its folder pages/; a clone has no such folder.

set(MATRIGRATE_PAGES "" CACHE PATH "Folder with run.html, study.html and verdicts.html, where npm cannot be used")
if(NOT MATRIGRATE_PAGES AND EXISTS ${PROJECT_SOURCE_DIR}/pages/run.html)
  set(MATRIGRATE_PAGES ${PROJECT_SOURCE_DIR}/pages)
endif()
set(viewer ${PROJECT_BINARY_DIR}/viewer)
set(pages ${MATRIGRATE_PAGES})
if(NOT pages)
  set(pages ${viewer}/dist)
endif()
set(MATRIGRATE_PAGE_FILES ${pages}/run.html ${pages}/study.html ${pages}/verdicts.html)
if(NOT MATRIGRATE_PAGES)
  find_program(NPM npm)
  if(NOT NPM)
    message(FATAL_ERROR "npm is needed to build the report's pages (Debian: apt-get install nodejs npm). Without it, "
                        "build viewer/ elsewhere and pass -DMATRIGRATE_PAGES=<its folder dist>.")
  endif()
  file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/viewer
       ${PROJECT_SOURCE_DIR}/viewer/src/* ${PROJECT_SOURCE_DIR}/viewer/sample/* ${PROJECT_SOURCE_DIR}/viewer/tests/*)
  list(APPEND viewer_sources run.html study.html verdicts.html package.json package-lock.json tsconfig.json vite.config.ts)
  file(GLOB_RECURSE stale RELATIVE ${viewer} ${viewer}/src/* ${viewer}/sample/* ${viewer}/tests/*)
  list(REMOVE_ITEM stale ${viewer_sources}) # copies of files that have moved
  if(stale)
    list(TRANSFORM stale PREPEND ${viewer}/)
    file(REMOVE ${stale})
  endif()
  set(viewer_files ${viewer_sources})
  list(TRANSFORM viewer_files PREPEND ${PROJECT_SOURCE_DIR}/viewer/)
  set(packages ${PROJECT_SOURCE_DIR}/viewer/package.json ${PROJECT_SOURCE_DIR}/viewer/package-lock.json)
  add_custom_command(
    OUTPUT ${viewer}/copied
    DEPENDS ${viewer_files} ${PROJECT_SOURCE_DIR}/cmake/copy_files.cmake
    COMMAND ${CMAKE_COMMAND} -DFROM=${PROJECT_SOURCE_DIR}/viewer -DTO=${viewer} "-DFILES=${viewer_sources}" -P
            ${PROJECT_SOURCE_DIR}/cmake/copy_files.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${viewer}/copied
    COMMENT "Copying the sources of the report's pages" VERBATIM)
  add_custom_command(
    OUTPUT ${viewer}/installed
    DEPENDS ${packages}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${viewer}
    COMMAND ${CMAKE_COMMAND} -E copy ${packages} ${viewer}
    COMMAND ${CMAKE_COMMAND} -E chdir ${viewer} ${NPM} ci --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${viewer}/installed
    COMMENT "Getting what builds the report's pages" VERBATIM)
  add_custom_command(
    OUTPUT ${MATRIGRATE_PAGE_FILES}
    DEPENDS ${viewer}/installed ${viewer}/copied
    WORKING_DIRECTORY ${viewer}
    COMMAND ${NPM} run build --silent
    COMMAND ${CMAKE_COMMAND} -E touch ${MATRIGRATE_PAGE_FILES}
    COMMENT "Building the report's pages" VERBATIM)
endif()
add_custom_target(matrigrate_pages DEPENDS ${MATRIGRATE_PAGE_FILES})

# The assembler takes the files in as they are: string literals of this length are more than compilers promise.
set(MATRIGRATE_SHIPPED_PAGES ${PROJECT_BINARY_DIR}/pages/shipped_pages.cpp)
list(APPEND MATRIGRATE_PAGE_FILES ${PROJECT_SOURCE_DIR}/viewer/drive.mjs)
set(shipped_names run_page_template study_page_template verdicts_page_template drive_script)
foreach(name file IN ZIP_LISTS shipped_names MATRIGRATE_PAGE_FILES)
  string(APPEND taken "    \"shipped_${name}: .incbin \\\"${file}\\\"\\nshipped_${name}_end:\\n\"\n")
  string(APPEND bounds "extern \"C\" const char shipped_${name}[], shipped_${name}_end[];\n")
  string(APPEND functions "std::string_view ${name}() { return {shipped_${name}, shipped_${name}_end}; }\n")
endforeach()
file(
  CONFIGURE
  OUTPUT ${MATRIGRATE_SHIPPED_PAGES}
  CONTENT
    "#include \"apps/shipped_pages.hpp\"\n
asm(\".section .rodata\\n\"
@taken@    \".text\\n\");\n
@bounds@
namespace matrigrate::apps {\n
@functions@
} // namespace matrigrate::apps\n"
  @ONLY)
