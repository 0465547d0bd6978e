# SPDX-License-Identifier: Apache-2.0
# Fails unless MAKE_SCENES writes into WRITTEN exactly the scenes that are in COMMITTED.
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${WRITTEN})
execute_process(COMMAND ${MAKE_SCENES} ${WRITTEN} COMMAND_ERROR_IS_FATAL ANY)

file(GLOB written RELATIVE ${WRITTEN} ${WRITTEN}/*/scene.*)
file(GLOB committed RELATIVE ${COMMITTED} ${COMMITTED}/*/scene.*)
if(NOT written STREQUAL committed)
  message(FATAL_ERROR "written: ${written}\ncommitted: ${committed}")
endif()
foreach(name ${written})
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WRITTEN}/${name} ${COMMITTED}/${name}
    RESULT_VARIABLE different)
  if(different)
    message(FATAL_ERROR "examples/scenes/${name} is not what make-scenes writes: run it on "
      "examples/scenes, or mend it")
  endif()
endforeach()
list(LENGTH written count)
message("${count} files are the same")
