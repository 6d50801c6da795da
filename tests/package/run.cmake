# cmake -D BUILD=build-folder -D GENERATOR=... -D COMPILER=... -D TYPE=... -D FLAGS=... -P run.cmake
# Installs algae into the build folder, then configures, builds and runs the other project there.
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(prefix ${BUILD}/package/installed)
set(garden ${BUILD}/package/garden)
file(REMOVE_RECURSE ${prefix} ${garden})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${garden} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_BUILD_TYPE=${TYPE} -D CMAKE_CXX_FLAGS=${FLAGS} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${garden})
run(${garden}/garden)

# The installed command finds all that comes with it from an empty folder.
set(empty ${BUILD}/package/empty)
file(REMOVE_RECURSE ${empty})
file(MAKE_DIRECTORY ${empty})
function(answers status expected)  # answers(status expected argument...): runs the command, looks for a text in its output
  execute_process(COMMAND ${prefix}/bin/algae ${ARGN} WORKING_DIRECTORY ${empty}
    RESULT_VARIABLE ended OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(FIND "${said}" "${expected}" place)
  if(NOT ended EQUAL status OR place EQUAL -1)
    message(FATAL_ERROR "algae ${ARGN}: expected status ${status} and '${expected}', found status ${ended} and:\n${said}")
  endif()
endfunction()
answers(0 "algae 0." --version)
answers(0 "F -> F+F--F+F" show koch)
answers(0 "koch" gallery)
answers(0 "fern.ifs" gallery)
answers(0 "axiom" show ${prefix}/share/algae/systems/fibonacci.lsys)
answers(0 "Growth" lesson)
answers(0 "Exercise 3.2" lesson 3 --exercise 2)
answers(0 "right" lesson 3 --exercise 2 ${prefix}/share/algae/lessons/answers/03-2.lsys)
answers(0 "14 claims" check theory/growth --accept cited)
answers(0 "14 claims" check ${prefix}/share/algae/theory/growth --accept cited)
answers(0 "axiom" show ${prefix}/share/algae/examples/bush.brno)
answers(1 "not 0L" closure 0L union)
answers(0 "" draw koch -n 3 -o koch.pdf)
foreach(file share/man/man1/algae.1 share/bash-completion/completions/algae share/zsh/site-functions/_algae
    share/fish/vendor_completions.d/algae.fish share/algae/systems/fibonacci.lsys share/doc/algae/copyright
    share/doc/algae/README.md share/doc/algae/NOTATION.md share/doc/algae/CERTIFICATES.md share/doc/algae/CHANGELOG.md)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
