# Every dependency in one place. Each is found where the system's packages put it; to use another
# copy, set the cache path named beside it. Targets are artisketch::NAME.

function(artisketch_header_dependency name header variable)
  find_path(${variable} NAMES ${header} DOC "Folder that holds ${header}" REQUIRED)
  add_library(artisketch::${name} INTERFACE IMPORTED)
  # As SYSTEM: their warnings are theirs. Never /usr/include itself, which is searched anyway and
  # breaks the order of the compiler's own headers when named.
  if(NOT "${${variable}}" STREQUAL "/usr/include")
    target_include_directories(artisketch::${name} SYSTEM INTERFACE "${${variable}}")
  endif()
endfunction()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)  # Eigen3_DIR
add_library(artisketch::eigen INTERFACE IMPORTED)
target_link_libraries(artisketch::eigen INTERFACE Eigen3::Eigen)

find_package(nlohmann_json 3.11 REQUIRED)  # nlohmann_json_DIR
add_library(artisketch::json INTERFACE IMPORTED)
target_link_libraries(artisketch::json INTERFACE nlohmann_json::nlohmann_json)

artisketch_header_dependency(stb stb/stb_image.h ARTISKETCH_STB_DIR)
artisketch_header_dependency(tinygltf tiny_gltf.h ARTISKETCH_TINYGLTF_DIR)
artisketch_header_dependency(nanoflann nanoflann.hpp ARTISKETCH_NANOFLANN_DIR)
artisketch_header_dependency(cli11 CLI/CLI.hpp ARTISKETCH_CLI11_DIR)
