# Finds Emscripten's own toolchain file, beside its compiler: Debian's package, or an SDK whose
# emcc is on the PATH.
find_program(ARTISKETCH_EMCC emcc)
if(NOT ARTISKETCH_EMCC)
  message(FATAL_ERROR "Emscripten's compiler emcc is not on the PATH: install Emscripten "
                      "(Debian and Ubuntu: apt-get install emscripten)")
endif()
file(REAL_PATH "${ARTISKETCH_EMCC}" emcc)
cmake_path(GET emcc PARENT_PATH root)
include("${root}/cmake/Modules/Platform/Emscripten.cmake")
