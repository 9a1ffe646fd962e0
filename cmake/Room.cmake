# armtune_room(NAME [WITHOUT FOLDER...]): one static library per room, with every .cpp below its folder but those
# below the folders named, our warnings as errors.
# Dependencies point one way: core <- sim <- tuner.

add_library(armtune_options INTERFACE)
target_compile_options(armtune_options INTERFACE
  # Every operation rounds: one arm alone is, to the bit, the same arm beside others (sim/lanes).
  -ffp-contract=off
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-psabi $<$<BOOL:${ARMTUNE_WERROR}>:-Werror>
  # g++ 12 warns of overlapping copies inside its own std::string (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(ARMTUNE_SANITIZE)
  target_compile_options(armtune_options INTERFACE
    -fsanitize=${ARMTUNE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-error=maybe-uninitialized>)
  target_link_options(armtune_options INTERFACE -fsanitize=${ARMTUNE_SANITIZE})
endif()
if(ARMTUNE_FUZZ)
  target_compile_options(armtune_options INTERFACE
    -fsanitize=fuzzer-no-link -fsanitize-coverage-allowlist=${PROJECT_SOURCE_DIR}/tests/fuzz/readers.txt)
endif()
if(ARMTUNE_COVERAGE)
  target_compile_options(armtune_options INTERFACE --coverage)
  target_link_options(armtune_options INTERFACE --coverage)
endif()

# armtune_precompile(TARGET HEADER...): parses once what nearly every file of the target includes.
function(armtune_precompile TARGET)
  target_precompile_headers(${TARGET} PRIVATE <Eigen/Dense> <functional> <map> <optional> <string> <vector> ${ARGN})
  # So that ccache knows one from another.
  target_compile_options(${TARGET} PRIVATE
    $<$<CXX_COMPILER_ID:Clang>:-Xclang;-fno-pch-timestamp> $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# armtune_together(TARGET): compiles eight of its files as one, which takes a third of the time. So no two files of a room may
# have the same name in an anonymous namespace.
function(armtune_together TARGET)
  if(ARMTUNE_UNITY)
    set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif()
endfunction()

function(armtune_room NAME)
  cmake_parse_arguments(ROOM "" "" "WITHOUT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(folder ${ROOM_WITHOUT})
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
  endforeach()
  add_library(armtune_${NAME} STATIC ${sources})
  add_library(armtune::${NAME} ALIAS armtune_${NAME})
  set_target_properties(armtune_${NAME} PROPERTIES EXPORT_NAME ${NAME})
  target_include_directories(armtune_${NAME} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(armtune_${NAME} PUBLIC cxx_std_20)
  target_link_libraries(armtune_${NAME} PRIVATE $<BUILD_INTERFACE:armtune_options>)
  if(ARMTUNE_PRECOMPILE)
    armtune_precompile(armtune_${NAME})
  endif()
  # Not core and sim: scripts/check-mutants compiles their files one by one.
  if(NOT NAME MATCHES "^(core|sim)$")
    armtune_together(armtune_${NAME})
  endif()
endfunction()
