cmake_minimum_required(VERSION 3.25)
find_package(Git QUIET)
set(HASH "unknown")
set(DIRTY "false")
if(EXISTS ${SOURCE_DIR}/COMMIT) # the archive of a release, which may lie in somebody else's repository
  file(STRINGS ${SOURCE_DIR}/COMMIT HASH LIMIT_COUNT 1)
elseif(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE_DIR} rev-parse HEAD OUTPUT_VARIABLE out RESULT_VARIABLE rc
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(rc EQUAL 0)
    set(HASH ${out})
    execute_process(COMMAND ${GIT_EXECUTABLE} -C ${SOURCE_DIR} status --porcelain --untracked-files=no
                    OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      set(DIRTY "true")
    endif()
  endif()
endif()
file(
  CONFIGURE
  OUTPUT
  ${OUTPUT}
  CONTENT
  "#pragma once
// Written by the build.
namespace matrigrate::build_info {
inline constexpr const char* version = \"@VERSION@\";
inline constexpr const char* git_hash = \"@HASH@\";
inline constexpr bool git_dirty = @DIRTY@;
inline constexpr const char* compiler = \"@COMPILER@\";
inline constexpr const char* flags = \"@FLAGS@\";
inline constexpr const char* build_type = \"@BUILD_TYPE@\";
inline constexpr const char* sanitizers = \"@SANITIZE@\";
} // namespace matrigrate::build_info
"
  @ONLY)
