# What is installed stands where it belongs and works there, and nothing of it leans on the build:
#   cmake -DBUILD=build/native -P tests/install_test.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " words)
    message(FATAL_ERROR "${words}\n${said}")
  endif()
  set(said "${said}" PARENT_SCOPE)
endfunction()

set(at "${BUILD}/install-test")
file(REMOVE_RECURSE "${at}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${at}" --strip)
foreach(file IN ITEMS
    bin/artisketch share/man/man1/artisketch.1 share/bash-completion/completions/artisketch
    share/zsh/vendor-completions/_artisketch share/fish/vendor_completions.d/artisketch.fish
    share/mime/packages/artisketch.xml share/icons/hicolor/scalable/apps/artisketch.svg
    share/artisketch/examples/hero/hero.artisketch share/doc/artisketch/copyright)
  if(NOT EXISTS "${at}/${file}")
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
run("${at}/bin/artisketch" check "${at}/share/artisketch/examples/circles/circles.artisketch")
run("${at}/bin/artisketch" manual)
file(READ "${at}/share/man/man1/artisketch.1" manual)
if(NOT said STREQUAL manual)
  message(FATAL_ERROR "the manual is not that of this program")
endif()

# What others say of it, where they are there.
find_program(desktop desktop-file-validate)
if(desktop AND EXISTS "${at}/share/applications/artisketch.desktop")
  run("${desktop}" "${at}/share/applications/artisketch.desktop")
endif()
find_program(mandoc mandoc)
if(mandoc)
  run("${mandoc}" -T lint -W error "${at}/share/man/man1/artisketch.1")
endif()
file(REMOVE_RECURSE "${at}")
