# Third-party libraries, all from Debian 12 (scripts/packages.txt). Their headers are SYSTEM: our warnings
# are for our own code.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(pugixml REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(Qhull 8 REQUIRED)
find_package(SQLite3 3.37 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(NLopt REQUIRED)
find_package(Threads REQUIRED)

include(${CMAKE_CURRENT_LIST_DIR}/Simbody.cmake)

# SuiteSparse 5 ships no CMake package that names SPQR and CHOLMOD.
set(SUITESPARSE_VERSION "not built in")
if(ARMTUNE_SUITESPARSE)
  find_path(SPQR_INCLUDE_DIR SuiteSparseQR.hpp PATH_SUFFIXES suitesparse REQUIRED)
  find_library(SPQR_LIBRARY spqr REQUIRED)
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
  file(STRINGS ${SPQR_INCLUDE_DIR}/SuiteSparse_config.h version_lines REGEX "define SUITESPARSE_(MAIN|SUB|SUBSUB)_VERSION")
  string(REGEX REPLACE "[^0-9;]" "" SUITESPARSE_VERSION "${version_lines}")
  string(REPLACE ";" "." SUITESPARSE_VERSION "${SUITESPARSE_VERSION}")
  add_library(SuiteSparse::spqr INTERFACE IMPORTED GLOBAL)
  target_include_directories(SuiteSparse::spqr SYSTEM INTERFACE ${SPQR_INCLUDE_DIR})
  target_link_libraries(SuiteSparse::spqr INTERFACE ${SPQR_LIBRARY} ${CHOLMOD_LIBRARY})
  add_library(SuiteSparse::cholmod INTERFACE IMPORTED GLOBAL)
  target_include_directories(SuiteSparse::cholmod SYSTEM INTERFACE ${SPQR_INCLUDE_DIR})
  target_link_libraries(SuiteSparse::cholmod INTERFACE ${CHOLMOD_LIBRARY})
endif()

# Only the C interface: MPI::MPI_C.
if(ARMTUNE_MPI)
  enable_language(C)
  find_package(MPI COMPONENTS C)
  if(NOT MPI_C_FOUND)
    message(FATAL_ERROR "No MPI found: install Open MPI (scripts/setup does), or build without with -DARMTUNE_MPI=OFF.")
  endif()
endif()

# Debian has two CMake packages of that name; the C interface is in either.
if(NOT TARGET NLopt::nlopt)
  add_library(NLopt::nlopt ALIAS NLopt::nlopt_cxx)
endif()

# urdfdom ships pkg-config files, and CMake files that name no targets.
find_package(PkgConfig REQUIRED)
pkg_check_modules(URDFDOM REQUIRED IMPORTED_TARGET urdfdom console_bridge)

# Debian ships no CMake files of LZ4.
pkg_check_modules(COMPRESSION REQUIRED IMPORTED_TARGET liblz4 libzstd)

# Debian's pybind11 and NumPy are for Debian's Python, whichever other comes first on the PATH.
if(ARMTUNE_PYTHON)
  if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
    set(Python_EXECUTABLE /usr/bin/python3)
  endif()
  set(PYBIND11_FINDPYTHON ON)
  find_package(Python 3.10 COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.9 CONFIG)
  if(NOT pybind11_FOUND OR NOT Python_Development.Module_FOUND)
    message(STATUS "No pybind11 or no headers of Python: no Python module (pybind11-dev, python3-dev)")
    set(ARMTUNE_PYTHON OFF)
  endif()
endif()
