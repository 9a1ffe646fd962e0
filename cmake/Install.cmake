# cmake --install: the program, the libraries with their headers, the bundled data, and a CMake package.

include(CMakePackageConfigHelpers)

install(TARGETS armtune RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS armtune_core armtune_sim armtune_tuner armtune_simbody EXPORT armtune
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(room core sim tuner)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/armtune
    FILES_MATCHING PATTERN "*.hpp" PATTERN "web" EXCLUDE)
endforeach()
if(ARMTUNE_SUITESPARSE)
  install(TARGETS armtune_identification armtune_planning EXPORT armtune_suitesparse
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT armtune_suitesparse NAMESPACE armtune:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune
    FILE armtuneSuiteSparseTargets.cmake)
endif()
install(TARGETS armtune_cli EXPORT armtune_cli ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT armtune_cli NAMESPACE armtune:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune
  FILE armtuneCliTargets.cmake)
install(EXPORT armtune NAMESPACE armtune:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune
  FILE armtuneTargets.cmake)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/armtuneConfig.cmake.in
  ${CMAKE_BINARY_DIR}/armtuneConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/armtuneConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/armtuneConfig.cmake ${CMAKE_BINARY_DIR}/armtuneConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune)

# Bundled data. The build tree gets the same layout beside bin/, so the program finds it the same way.
set(data sim/robots sim/scenarios sim/theta sim/gains tuner/studies tuner/tasks)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/armtune)
foreach(folder ${data})
  get_filename_component(name ${folder} NAME)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/armtune)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${CMAKE_BINARY_DIR}/share/armtune/${name} SYMBOLIC)
endforeach()
