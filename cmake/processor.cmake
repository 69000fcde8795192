# For which processors the programs are built. Sets HANDLENS_CPU_LEVEL (a value of -march, or "baseline": what every processor of
# the architecture runs) and HANDLENS_MARCH (the compiler's flags for it).
set(HANDLENS_CPU "auto" CACHE STRING
  "Value of -march, such as x86-64-v3; baseline: any processor of the architecture; auto: the newest of both that this machine runs")

# The newest of x86-64-v3, x86-64-v2 and baseline that runs on this machine.
function(handlens_detect_level result)
  set(level "baseline")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$" AND NOT CMAKE_CROSSCOMPILING)
    try_run(HANDLENS_LEVEL_EXIT HANDLENS_LEVEL_COMPILED
      SOURCES ${PROJECT_SOURCE_DIR}/cmake/print_level.cpp ${PROJECT_SOURCE_DIR}/core/processor/this_processor.cpp
      CMAKE_FLAGS -DINCLUDE_DIRECTORIES=${PROJECT_SOURCE_DIR}
      RUN_OUTPUT_VARIABLE output)
    if(HANDLENS_LEVEL_COMPILED AND HANDLENS_LEVEL_EXIT EQUAL 0)
      set(level "${output}")
    endif()
  endif()
  set(${result} "${level}" CACHE INTERNAL "What HANDLENS_CPU=auto stands for on this machine")
endfunction()

set(HANDLENS_CPU_LEVEL "${HANDLENS_CPU}")
if(HANDLENS_CPU STREQUAL "auto")
  if(NOT DEFINED CACHE{HANDLENS_DETECTED_LEVEL})
    handlens_detect_level(HANDLENS_DETECTED_LEVEL)
    message(STATUS "Building for ${HANDLENS_DETECTED_LEVEL} processors, as this machine has (HANDLENS_CPU)")
  endif()
  set(HANDLENS_CPU_LEVEL "${HANDLENS_DETECTED_LEVEL}")
elseif(NOT HANDLENS_CPU)
  set(HANDLENS_CPU_LEVEL "baseline")
endif()

set(HANDLENS_MARCH "")
if(NOT HANDLENS_CPU_LEVEL STREQUAL "baseline")
  set(HANDLENS_MARCH -march=${HANDLENS_CPU_LEVEL})
endif()
# A plain char is signed everywhere, as it is on x86.
if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|i.86)$")
  list(APPEND HANDLENS_MARCH -fsigned-char)
endif()
