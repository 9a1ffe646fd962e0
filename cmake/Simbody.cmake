# Simbody: Debian's, or another below Simbody_ROOT (scripts/build-simbody). Sets SIMBODY_BUILD, how the library was built,
# and SIMBODY_COMPILE_OPTIONS, of the files that include its headers: these do not compile as C++20, and change class
# layouts with NDEBUG, which such a file has to have exactly if the library had it. Debian's has not.

find_package(Simbody 3.7 REQUIRED)
if(Simbody_ROOT)
  file(REAL_PATH ${Simbody_ROOT} wanted)
  file(REAL_PATH ${Simbody_DIR} found)
  cmake_path(IS_PREFIX wanted ${found} below)
  if(NOT below)
    message(FATAL_ERROR "No Simbody below Simbody_ROOT, ${Simbody_ROOT}: scripts/build-simbody makes one, or leave it out.")
  endif()
endif()

# The library itself knows.
try_run(SIMBODY_ASKED SIMBODY_LINKED ${CMAKE_BINARY_DIR}/simbody_build ${CMAKE_CURRENT_LIST_DIR}/simbody_build.cpp
  LINK_LIBRARIES ${Simbody_LIBRARIES}
  COMPILE_OUTPUT_VARIABLE SIMBODY_MESSAGES
  RUN_OUTPUT_VARIABLE SIMBODY_BUILD)
if(NOT SIMBODY_LINKED OR NOT SIMBODY_ASKED EQUAL 0)
  message(FATAL_ERROR "Simbody in ${Simbody_DIR} does not say how it was built: ${SIMBODY_BUILD}${SIMBODY_MESSAGES}")
endif()
if(SIMBODY_BUILD STREQUAL "debug")
  # Eigen's assertions stay as the build type has them, so that its inline code is the same in every file.
  set(SIMBODY_COMPILE_OPTIONS "-std=c++17;-UNDEBUG;$<$<CONFIG:Release>:-DEIGEN_NO_DEBUG>")
else()
  set(SIMBODY_COMPILE_OPTIONS "-std=c++17;-DNDEBUG")
endif()
message(STATUS "Simbody ${Simbody_VERSION}: a ${SIMBODY_BUILD} build, ${Simbody_DIR}")

# armtune_load_simbody_first(TARGET): at a start, the dynamic linker looks for each symbol in the program's
# libraries, in their order. Most of these symbols are in Simbody's libraries and in the C++ library. With these
# libraries first, a start takes a sixth fewer instructions.
function(armtune_load_simbody_first TARGET)
  # A sanitizer's library has to come first itself. --no-as-needed: the objects that need the libraries come later.
  if(NOT ARMTUNE_SANITIZE)
    target_link_options(${TARGET} PRIVATE "SHELL:-Wl,--push-state,--no-as-needed $<TARGET_FILE:SimTKcommon> -lstdc++ \
$<TARGET_FILE:SimTKmath> $<TARGET_FILE:SimTKsimbody> -Wl,--pop-state")
  endif()
endfunction()
