# Every dependency of the program in one place; all but meshoptimizer and zlib are headers alone. Each is
# looked for where systems' packages put it; to use another copy, set the cache path
# ARTISKETCH_NAME_DIR to the folder that holds its headers.
#
# A link to each is made in BUILD/include, and only that folder is searched: the same headers serve
# this machine's compiler and Emscripten's, which must never see /usr/include. They are SYSTEM
# headers: their warnings are theirs. Targets are artisketch::NAME.

set(headers "${PROJECT_BINARY_DIR}/include")
file(MAKE_DIRECTORY "${headers}")

# Links `entry`, the folder or header that an #include of the dependency begins with.
#   UNDER folder   beneath a system's include folder, where packages put the entry
#   SINCE version  the oldest that will do, known by its HAVING a header that older ones lack
function(artisketch_header_dependency name entry)
  cmake_parse_arguments(arg "" "UNDER;SINCE;HAVING" "" ${ARGN})
  string(TOUPPER "ARTISKETCH_${name}_DIR" dir)
  if(arg_HAVING)
    set(sought "${entry}/${arg_HAVING}")
  else()
    set(sought "${entry}")
  endif()
  # A cross compiler looks in its own folders alone, unless told.
  find_path(${dir} NAMES "${sought}" PATHS /usr/local/include /usr/include
            PATH_SUFFIXES ${arg_UNDER} NO_CMAKE_FIND_ROOT_PATH
            DOC "Folder that holds ${entry}")
  if(NOT EXISTS "${${dir}}/${sought}")
    message(FATAL_ERROR "${name} ${arg_SINCE} was not found. Install it, or pass "
                        "-D${dir}=FOLDER with the folder that holds ${sought}")
  endif()
  file(CREATE_LINK "${${dir}}/${entry}" "${headers}/${entry}" SYMBOLIC)
  add_library(artisketch::${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(artisketch::${name} SYSTEM INTERFACE "${headers}")
endfunction()

artisketch_header_dependency(eigen Eigen UNDER eigen3 SINCE 3.4 HAVING src/Core/Reshaped.h)
artisketch_header_dependency(json nlohmann SINCE 3.11 HAVING detail/abi_macros.hpp)
artisketch_header_dependency(stb stb HAVING stb_image.h)
artisketch_header_dependency(tinygltf tiny_gltf.h)
artisketch_header_dependency(cli11 CLI HAVING CLI.hpp)

# tiny_gltf.h includes the others' headers itself, and stb's without their folder.
target_link_libraries(artisketch::tinygltf INTERFACE artisketch::json)
target_include_directories(artisketch::tinygltf SYSTEM INTERFACE "${headers}/stb")

if(EMSCRIPTEN)
  # Eigen 3.4 has no packets of WebAssembly's, but Emscripten has SSE2 in terms of them: faster than
  # scalars, and sums are then taken in the same order as on a PC, so that both give the same model.
  # "GCC 5.13" is where Eigen stops writing SSE in assembly for old compilers, and before it starts to
  # for new ones.
  target_compile_options(artisketch::eigen INTERFACE -msimd128 -msse2 -fgnuc-version=5.13)
  # It goes by the size of a pointer otherwise, and takes half of the registers.
  target_compile_definitions(artisketch::eigen INTERFACE EIGEN_ARCH_DEFAULT_NUMBER_OF_REGISTERS=16)
  target_include_directories(artisketch::eigen SYSTEM INTERFACE "${PROJECT_SOURCE_DIR}/cmake/sse")

  # Compiled along: the system's libraries are for the system. `sources` are a library's, within its
  # folder, which holds what Debian's source package of its name does.
  function(artisketch_compiled_dependency name include)
    string(TOUPPER "ARTISKETCH_${name}_SOURCE" folder)
    set(${folder} "" CACHE PATH "Folder of ${name}'s sources")
    if(NOT EXISTS "${${folder}}/${include}")
      message(FATAL_ERROR "Set ${folder} to the folder of ${name}'s sources (apt-get source ${name})")
    endif()
    list(TRANSFORM ARGN PREPEND "${${folder}}/")
    file(GLOB sources ${ARGN})
    add_library(${name}_web STATIC ${sources})
    target_include_directories(${name}_web SYSTEM PUBLIC "${${folder}}/${include}")
    add_library(artisketch::${name} ALIAS ${name}_web)
  endfunction()
  artisketch_compiled_dependency(meshoptimizer src src/*.cpp)
  # What compressing takes; stb reads.
  artisketch_compiled_dependency(zlib . adler32.c compress.c crc32.c deflate.c trees.c zutil.c)
else()
  find_package(meshoptimizer REQUIRED)  # meshoptimizer_DIR
  add_library(artisketch::meshoptimizer ALIAS meshoptimizer::meshoptimizer)
  find_package(ZLIB REQUIRED)
  add_library(artisketch::zlib ALIAS ZLIB::ZLIB)
endif()
