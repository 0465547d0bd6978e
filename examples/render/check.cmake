# SPDX-License-Identifier: Apache-2.0
# README.md shows what SOURCE has below its first comment, and PROGRAM writes lamp.exr.
file(READ ${SOURCE} source)
file(READ ${README} readme)
string(FIND "${source}" "*/\n" end)
math(EXPR end "${end} + 3")
string(SUBSTRING "${source}" ${end} -1 source)
string(FIND "${readme}" "\n```c\n${source}```\n" found)
if(found EQUAL -1)
  message(FATAL_ERROR "README.md does not show ${SOURCE}")
endif()

file(REMOVE lamp.exr)
execute_process(COMMAND ${PROGRAM} COMMAND_ERROR_IS_FATAL ANY)
if(NOT EXISTS lamp.exr)
  message(FATAL_ERROR "no lamp.exr")
endif()
