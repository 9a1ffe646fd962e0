# Copies the FILES of WEB, and the TYPES of its data, to WORK, builds them there with NPM, and writes the page as the C++ file PAGE. The source tree is
# only read. Packages are installed anew only where package-lock.json has changed.

file(GLOB before LIST_DIRECTORIES true ${WORK}/*)
foreach(entry ${before})
  if(NOT entry MATCHES "/(node_modules|installed\\.json)$")
    file(REMOVE_RECURSE ${entry})
  endif()
endforeach()
foreach(name ${FILES})
  get_filename_component(folder ${name} DIRECTORY)
  file(COPY ${WEB}/${name} DESTINATION ${WORK}/${folder})
endforeach()

file(COPY ${TYPES} DESTINATION ${WORK}/src)

function(npm)
  execute_process(COMMAND ${NPM} ${ARGV} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE failed
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(failed)
    string(JOIN " " command npm ${ARGV})
    message(FATAL_ERROR "${output}\n'${command}' failed in ${WORK}. It needs the npm registry once; "
                        "-DARMTUNE_REPORT=OFF builds armtune without the report's page.")
  endif()
endfunction()

set(lock ${WORK}/package-lock.json)
set(installed ${WORK}/installed.json)
set(same FALSE)
if(EXISTS ${installed} AND EXISTS ${WORK}/node_modules)
  file(SHA256 ${lock} wanted)
  file(SHA256 ${installed} there)
  if(wanted STREQUAL there)
    set(same TRUE)
  endif()
endif()
if(NOT same)
  npm(ci --no-audit --no-fund)
  configure_file(${lock} ${installed} COPYONLY)
endif()
npm(run build)

file(READ ${WORK}/dist/template.html page)
set(end "armtune_page")
string(FIND "${page}" ")${end}\"" clash)
if(NOT clash EQUAL -1)
  message(FATAL_ERROR "The page holds the end of a raw string, ')${end}\"'; rename it in build_report_page.cmake.")
endif()
file(WRITE ${PAGE} "#include \"tuner/report/page.hpp\"\n\nnamespace armtune::internal::report {\n\n"
  "std::string_view page_text() {\n  return R\"${end}(" "${page}" ")${end}\";\n}\n\n}  // namespace armtune::internal::report\n")
