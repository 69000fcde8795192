# One interface target holds the warnings and the code generation that every part of the project shares.
include(cmake/processor.cmake)

set(HANDLENS_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Woverloaded-virtual)
# GCC 12 sees loads past the end in Eigen's vectorised code paths that are never taken, and overlaps and overflows in joined strings.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND HANDLENS_WARNINGS -Wno-array-bounds -Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overflow
    -Wno-stringop-overread -Wno-error=invalid-pch)
endif()
# GCC looks for memory to give back each time its use has doubled, a sixth of the time it takes for Eigen's templates.
set(HANDLENS_COMPILER_MEMORY "")
cmake_host_system_information(RESULT memory_mib QUERY TOTAL_PHYSICAL_MEMORY)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND memory_mib GREATER 7000)
  set(HANDLENS_COMPILER_MEMORY "SHELL:--param ggc-min-expand=1000" "SHELL:--param ggc-min-heapsize=4000000")
endif()
if(HANDLENS_WARNINGS_AS_ERRORS)
  list(APPEND HANDLENS_WARNINGS -Werror)
endif()

add_library(handlens_compiler INTERFACE)
target_compile_options(handlens_compiler INTERFACE ${HANDLENS_WARNINGS} ${HANDLENS_MARCH} ${HANDLENS_COMPILER_MEMORY})
# Eigen's alignment stays that of the system's libraries, whatever the processor.
target_compile_definitions(handlens_compiler INTERFACE EIGEN_MAX_ALIGN_BYTES=16)
if(HANDLENS_SANITIZE)
  # A finding ends the program: code that could go on after it takes a fifth longer to compile and twice the space. Null pointers
  # end it anyway; checks for them before every use of an object are the dearest part of what is compiled.
  target_compile_options(handlens_compiler INTERFACE -fsanitize=${HANDLENS_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer -fno-sanitize=null,vptr,object-size,nonnull-attribute,returns-nonnull-attribute)
  target_link_options(handlens_compiler INTERFACE -fsanitize=${HANDLENS_SANITIZE})
endif()
if(HANDLENS_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "HANDLENS_FUZZ needs Clang: CXX=clang++-14 (Debian packages clang-14, libclang-rt-14-dev)")
  endif()
  # Most of the time is spent in the libraries that are read with: ours compiles in half the time with fewer optimisations.
  target_compile_options(handlens_compiler INTERFACE -O1 -fsanitize=fuzzer-no-link,address,undefined
    -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(handlens_compiler INTERFACE -fsanitize=address,undefined)
endif()
target_include_directories(handlens_compiler INTERFACE ${PROJECT_SOURCE_DIR})

# The other linker of binutils needs a fifth of the time for programs that draw in hundreds of libraries.
find_program(HANDLENS_GOLD ld.gold)
if(HANDLENS_GOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT HANDLENS_SANITIZE)
  target_link_options(handlens_compiler INTERFACE -fuse-ld=gold)
endif()

# For code that waits for files and people: it compiles a quarter faster with fewer optimisations. A precompiled header brings
# the optimisations that it was made with, so such code has precompiled headers of its own.
add_library(handlens_light INTERFACE)
if(NOT HANDLENS_SANITIZE)
  target_compile_options(handlens_light INTERFACE $<$<CONFIG:Release>:-O1>)
endif()
