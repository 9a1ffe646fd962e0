# cmake --install: what is run (component armtune: the program, its data, manual page, completion), what is built with
# (component dev: libraries with their headers, and a CMake package), and the Python module (component python).

include(CMakePackageConfigHelpers)

install(TARGETS armtune RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT armtune)
install(TARGETS armtune_core armtune_sim armtune_tuner armtune_simbody EXPORT armtune
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
# The interface alone: headers of core, sim and tuner are armtune's own.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/armtune DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
if(ARMTUNE_SUITESPARSE)
  install(TARGETS armtune_identification armtune_validation armtune_calibration armtune_planning EXPORT armtune_suitesparse
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  install(EXPORT armtune_suitesparse NAMESPACE armtune:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune
    FILE armtuneSuiteSparseTargets.cmake COMPONENT dev)
endif()
install(TARGETS armtune_cli EXPORT armtune_cli ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
install(EXPORT armtune_cli NAMESPACE armtune:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune
  FILE armtuneCliTargets.cmake COMPONENT dev)
install(EXPORT armtune NAMESPACE armtune:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune
  FILE armtuneTargets.cmake COMPONENT dev)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/armtuneConfig.cmake.in
  ${CMAKE_BINARY_DIR}/armtuneConfig.cmake INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/armtuneConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/armtuneConfig.cmake ${CMAKE_BINARY_DIR}/armtuneConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/armtune COMPONENT dev)

# Bundled data. The build tree gets the same layout beside bin/, so the program finds it the same way.
set(data sim/robots sim/scenarios sim/theta sim/gains tuner/studies tuner/tasks)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/armtune)
foreach(folder ${data})
  get_filename_component(name ${folder} NAME)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/armtune COMPONENT armtune)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${CMAKE_BINARY_DIR}/share/armtune/${name} SYMBOLIC)
endforeach()

# The manual page and completion, which the program itself prints from its declarations.
if(NOT CMAKE_CROSSCOMPILING)
  set(manual ${CMAKE_BINARY_DIR}/share/manual)
  add_custom_command(OUTPUT ${manual}/armtune.1 ${manual}/armtune ${manual}/_armtune
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${manual}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${manual}
    COMMAND armtune man --out ${manual}/armtune.1
    COMMAND armtune completion bash --out ${manual}/armtune
    COMMAND armtune completion zsh --out ${manual}/_armtune
    DEPENDS armtune VERBATIM COMMENT "Manual page and completion")
  add_custom_target(armtune_manual ALL DEPENDS ${manual}/armtune.1)
  install(FILES ${manual}/armtune.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT armtune)
  install(FILES ${manual}/armtune DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT armtune)
  install(FILES ${manual}/_armtune DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT armtune)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/LICENSE-THIRD-PARTY.md ${PROJECT_SOURCE_DIR}/README.md
  ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT armtune)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT armtune)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/controller ${PROJECT_SOURCE_DIR}/examples/cpp
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT dev)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/python DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT python)
# Debian wants to find the licence of every package here.
set(licence ${PROJECT_SOURCE_DIR}/LICENSE)
install(FILES ${licence} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/armtune RENAME copyright COMPONENT armtune)
install(FILES ${licence} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/armtune-dev RENAME copyright COMPONENT dev)
install(FILES ${licence} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-armtune RENAME copyright COMPONENT python)
