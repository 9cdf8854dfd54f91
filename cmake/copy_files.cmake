# Copies FILES, a list, from the folder FROM to TO: cmake -DFROM=... -DTO=... "-DFILES=a;b/c" -P copy_files.cmake
cmake_minimum_required(VERSION 3.25)
foreach(file ${FILES})
  cmake_path(GET file PARENT_PATH folder)
  file(MAKE_DIRECTORY ${TO}/${folder})
  file(COPY_FILE ${FROM}/${file} ${TO}/${file} ONLY_IF_DIFFERENT)
endforeach()
