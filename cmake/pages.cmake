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
  set(viewer_copies "")
  foreach(file ${viewer_sources})
    add_custom_command(OUTPUT ${viewer}/${file} DEPENDS ${PROJECT_SOURCE_DIR}/viewer/${file}
                       COMMAND ${CMAKE_COMMAND} -E copy ${PROJECT_SOURCE_DIR}/viewer/${file} ${viewer}/${file}
                       COMMENT "" VERBATIM)
    list(APPEND viewer_copies ${viewer}/${file})
  endforeach()
  add_custom_command(
    OUTPUT ${viewer}/installed
    DEPENDS ${viewer}/package.json ${viewer}/package-lock.json
    WORKING_DIRECTORY ${viewer}
    COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error
    COMMAND ${CMAKE_COMMAND} -E touch ${viewer}/installed
    COMMENT "Getting what builds the report's pages" VERBATIM)
  add_custom_command(
    OUTPUT ${MATRIGRATE_PAGE_FILES}
    DEPENDS ${viewer}/installed ${viewer_copies}
    WORKING_DIRECTORY ${viewer}
    COMMAND ${NPM} run build --silent
    COMMAND ${CMAKE_COMMAND} -E touch ${MATRIGRATE_PAGE_FILES}
    COMMENT "Building the report's pages" VERBATIM)
endif()
add_custom_target(matrigrate_pages DEPENDS ${MATRIGRATE_PAGE_FILES})

# The assembler takes the files in as they are: string literals of this length are more than compilers promise.
set(MATRIGRATE_SHIPPED_PAGES ${PROJECT_BINARY_DIR}/pages/shipped_pages.cpp)
file(
  CONFIGURE
  OUTPUT ${MATRIGRATE_SHIPPED_PAGES}
  CONTENT
    "#include \"apps/shipped_pages.hpp\"\n
asm(\".section .rodata\\n\"
    \"matrigrate_run_page: .incbin \\\"@pages@/run.html\\\"\\n\"
    \"matrigrate_run_page_end:\\n\"
    \"matrigrate_study_page: .incbin \\\"@pages@/study.html\\\"\\n\"
    \"matrigrate_study_page_end:\\n\"
    \"matrigrate_verdicts_page: .incbin \\\"@pages@/verdicts.html\\\"\\n\"
    \"matrigrate_verdicts_page_end:\\n\"
    \".text\\n\");
extern \"C\" {
extern const char matrigrate_run_page[], matrigrate_run_page_end[];
extern const char matrigrate_study_page[], matrigrate_study_page_end[];
extern const char matrigrate_verdicts_page[], matrigrate_verdicts_page_end[];
}\n
namespace matrigrate::apps {\n
std::string_view run_page_template() { return {matrigrate_run_page, matrigrate_run_page_end}; }
std::string_view study_page_template() { return {matrigrate_study_page, matrigrate_study_page_end}; }
std::string_view verdicts_page_template() { return {matrigrate_verdicts_page, matrigrate_verdicts_page_end}; }\n
} // namespace matrigrate::apps\n"
  @ONLY)
