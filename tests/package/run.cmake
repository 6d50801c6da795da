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
run(${prefix}/bin/algae --version)
