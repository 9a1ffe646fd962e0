# Third-party libraries, all from Debian 12 (scripts/packages.txt). Their headers are SYSTEM: our warnings
# are for our own code.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(Simbody 3.7 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(NLopt REQUIRED)
find_package(Threads REQUIRED)

# Debian has two CMake packages of that name; the C interface is in either.
if(NOT TARGET NLopt::nlopt)
  add_library(NLopt::nlopt ALIAS NLopt::nlopt_cxx)
endif()

# urdfdom ships pkg-config files, and CMake files that name no targets.
find_package(PkgConfig REQUIRED)
pkg_check_modules(URDFDOM REQUIRED IMPORTED_TARGET urdfdom console_bridge)
