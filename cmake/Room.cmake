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

# armtune_together(TARGET [PATTERN]): compiles eight of its files, of those that match the pattern, as one, which takes a third of
# the time. So no two files of a room may have the same name in an anonymous namespace. Files with definitions of their own, or with
# SKIP_UNITY_BUILD_INCLUSION because another target has them too, are compiled alone. The files name each other from the top of the
# repository, not by whole paths as CMake's UNITY_BUILD does, so that ccache knows them in another clone.
function(armtune_together TARGET)
  if(ARMTUNE_UNITY)
    # At the end of the folder's CMakeLists.txt, when all its sources and their properties are known.
    cmake_language(EVAL CODE "cmake_language(DEFER CALL armtune_put_together [[${TARGET}]] [[${ARGN}]])")
  endif()
endfunction()

function(armtune_put_together TARGET PATTERN)
  get_target_property(sources ${TARGET} SOURCES)
  list(FILTER sources INCLUDE REGEX "^${PROJECT_SOURCE_DIR}/.*${PATTERN}")
  list(FILTER sources EXCLUDE REGEX "^${PROJECT_BINARY_DIR}/")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/together)
  set(number 0)
  foreach(source ${sources})
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    get_source_file_property(definitions ${source} COMPILE_DEFINITIONS)
    if(alone OR definitions)
      continue()
    endif()
    set_source_files_properties(${source} PROPERTIES HEADER_FILE_ONLY ON)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE path)
    math(EXPR batch "${number} / 8")
    string(APPEND text_${batch} "#include \"${path}\"\n")
    math(EXPR number "${number} + 1")
  endforeach()
  if(number EQUAL 0)
    return()
  endif()
  foreach(part RANGE ${batch})
    file(CONFIGURE OUTPUT ${folder}/${TARGET}_${part}.cpp CONTENT "${text_${part}}" @ONLY)
    target_sources(${TARGET} PRIVATE ${folder}/${TARGET}_${part}.cpp)
  endforeach()
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
