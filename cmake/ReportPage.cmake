# armtune_report_page(OUT): the report's page, built by npm from tuner/report/web in the build tree, as a .cpp file whose
# path goes to OUT; empty where that cannot be done, which is said. The types of its data, web/src/data.ts, are printed in
# the build tree before (target report_types) from what the C++ code declares: the source tree is only read.
option(ARMTUNE_REPORT "The report's page, which needs node and npm to build" ON)

function(armtune_report_page OUT)
  set(${OUT} "" PARENT_SCOPE)
  if(NOT ARMTUNE_REPORT)
    return()
  endif()
  find_program(ARMTUNE_NODE node)
  find_program(ARMTUNE_NPM npm)
  if(NOT ARMTUNE_NODE OR NOT ARMTUNE_NPM)
    message(WARNING "No node or npm found: armtune is built without report.html. Install them (scripts/setup does), or "
                    "say that it is not wanted with -DARMTUNE_REPORT=OFF.")
    return()
  endif()
  set(web ${CMAKE_CURRENT_SOURCE_DIR}/report/web)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${web} ${web}/*)
  list(FILTER files EXCLUDE REGEX "^(node_modules|dist)/")
  list(TRANSFORM files PREPEND ${web}/ OUTPUT_VARIABLE inputs)
  add_executable(print_types report/types/print_types.cpp report/base64.cpp)
  set_source_files_properties(${CMAKE_CURRENT_SOURCE_DIR}/report/base64.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  target_link_libraries(print_types PRIVATE armtune::sim armtune_options)
  set(types ${CMAKE_CURRENT_BINARY_DIR}/report_types/data.ts)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/report_types)
  add_custom_command(OUTPUT ${types} COMMAND print_types > ${types} DEPENDS print_types VERBATIM)
  add_custom_target(report_types DEPENDS ${types})
  set(page ${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp)
  add_custom_command(OUTPUT ${page}
    COMMAND ${CMAKE_COMMAND} -DWEB=${web} "-DFILES=${files}" -DTYPES=${types} -DWORK=${CMAKE_CURRENT_BINARY_DIR}/report_web -DPAGE=${page}
            -DNPM=${ARMTUNE_NPM} -P ${PROJECT_SOURCE_DIR}/cmake/build_report_page.cmake
    DEPENDS ${inputs} ${types} ${PROJECT_SOURCE_DIR}/cmake/build_report_page.cmake
    COMMENT "Building the report's page with npm" VERBATIM)
  # One literal of the whole page: Clang says that others may not take as long a one.
  set_source_files_properties(${page} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
  set(${OUT} ${page} PARENT_SCOPE)
endfunction()
