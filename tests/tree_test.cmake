# The tree itself: no file includes one of a floor above its own. ctest runs it, and so can you:
#   cmake -P tests/tree_test.cmake
# The order is read from docs/ARCHITECTURE.md: the block that begins with ```floors names one place
# a line, lowest first. A place is a folder, with all below it that no other line names, or a file
# without its ending. Files of one place may include each other.
#
# tests/tree_debts.txt lists the includes that still go upward, as "FILE -> INCLUDED": the list can only
# shrink, since one that is gone fails the test too until its line is.

cmake_minimum_required(VERSION 3.25)

cmake_path(SET root NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/..")
file(READ "${root}/docs/ARCHITECTURE.md" text)
if(NOT text MATCHES "```floors\n([^`]*)```")
  message(FATAL_ERROR "docs/ARCHITECTURE.md has no block that begins with ```floors")
endif()
string(REGEX MATCHALL "[^ \n]+" places "${CMAKE_MATCH_1}")

# Sets `out` to the index of the most particular place that holds `file`, a path within src; -1: none.
function(place_of file out)
  cmake_path(REMOVE_EXTENSION file LAST_ONLY)
  while(NOT file STREQUAL "")
    list(FIND places "${file}" at)
    if(at GREATER -1)
      break()
    endif()
    cmake_path(GET file PARENT_PATH file)
  endwhile()
  set(${out} ${at} PARENT_SCOPE)
endfunction()

set(faults "")
set(used "")
set(upward "")
file(GLOB_RECURSE sources RELATIVE "${root}/src" "${root}/src/*.h" "${root}/src/*.cpp")
foreach(source IN LISTS sources)
  place_of("${source}" own)
  if(own EQUAL -1)
    list(APPEND faults "src/${source} stands on no floor")
  endif()
  list(APPEND used ${own})
  file(STRINGS "${root}/src/${source}" includes REGEX "^ *# *include *\"")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1" include "${include}")
    place_of("${include}" other)
    if(NOT EXISTS "${root}/src/${include}")
      list(APPEND faults "src/${source} includes \"${include}\": not a path within src")
    elseif(other GREATER own)
      list(APPEND upward "src/${source} -> src/${include}")
    endif()
  endforeach()
endforeach()

list(LENGTH places count)
math(EXPR last "${count} - 1")
foreach(at RANGE ${last})
  if(NOT at IN_LIST used)
    list(GET places ${at} place)
    list(APPEND faults "docs/ARCHITECTURE.md: nothing stands on the floor ${place}")
  endif()
endforeach()

set(debts "")
if(EXISTS "${root}/tests/tree_debts.txt")
  file(STRINGS "${root}/tests/tree_debts.txt" debts REGEX "^[^#]")
endif()
foreach(include IN LISTS upward)
  if(NOT include IN_LIST debts)
    list(APPEND faults "upward include: ${include}")
  endif()
endforeach()
foreach(debt IN LISTS debts)
  if(NOT debt IN_LIST upward)
    list(APPEND faults "tests/tree_debts.txt: paid, take it out: ${debt}")
  endif()
endforeach()

list(LENGTH sources files)
if(faults)
  list(JOIN faults "\n  " faults)
  message(FATAL_ERROR "The floors are broken:\n  ${faults}")
endif()
message(STATUS "${files} files on ${count} floors, none includes one above")
