# cpack -G DEB: Debian packages, armtune to run, armtune-dev to build with, python3-armtune for scripts. What they link, dpkg-shlibdeps finds.

# armtune-dev's headers and targets name the libraries of scripts/packages.txt.
file(READ ${PROJECT_SOURCE_DIR}/scripts/packages.txt packages)
string(REGEX MATCH "# libraries\n(lib[^\n]*\n|openmpi[^\n]*\n)+" libraries "${packages}")
string(REGEX MATCHALL "\n[a-z][^ \n]*" libraries "${libraries}")
list(TRANSFORM libraries STRIP)
list(FILTER libraries INCLUDE REGEX "-dev$")
list(JOIN libraries ", " libraries)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME armtune)
set(CPACK_PACKAGE_CONTACT "The armtune authors <armtune@example.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL armtune dev)
set(CPACK_COMPONENT_ARMTUNE_DESCRIPTION "Offline trajectory and gain tuning for robot arms
 Simulates an arm from its URDF in Simbody under its complete controller and
 tunes the controller's gains with NLopt, so that tracking errors fall while
 every joint stays inside its velocity limits.")
set(CPACK_COMPONENT_DEV_DESCRIPTION "Libraries and headers of armtune
 For controllers and programs of one's own: find_package(armtune).")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ARMTUNE_PACKAGE_NAME armtune)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME armtune-dev)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ARMTUNE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_ARMTUNE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "armtune (= ${PROJECT_VERSION}), cmake, pkg-config, ${libraries}")
if(ARMTUNE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Python module of armtune
 Simulates and tunes robot arms from scripts; results are NumPy arrays.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-armtune)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "armtune (= ${PROJECT_VERSION}), python3 (>= 3.11), python3-numpy")
endif()
if(ARMTUNE_MPI)
  set(CPACK_DEBIAN_ARMTUNE_PACKAGE_RECOMMENDS openmpi-bin)
endif()
include(CPack)
