# The sources of a folder, compiled as one: half the work where they are many, since what templates make is
# made once. The page and what `./dev check` builds are made so. Where one works each source is compiled by
# itself, with what it includes alone, and an include that one forgot is found.
#
# These call two things alike in namespaces without a name, and are compiled by themselves. Where a name
# is said to be defined twice, give one a better name, or add its source.
set(alone
  src/base/dual_surface.cpp
  src/document/mend.cpp
  src/document/skeleton_edit.cpp
  src/model/calibrate/calibrate_rays.cpp
  src/model/calibrate/pose_solver.cpp
  src/model/calibrate/ray_search.cpp
  src/model/surface/thin_parts.cpp
  src/model/fit/fit_marks.cpp
  src/files/bvh_file.cpp
  src/files/document_file.cpp
  src/files/json.cpp
  src/files/mesh_file.cpp
  src/files/report_file.cpp
  src/files/tiny_gltf_impl.cpp
  src/app/version.cpp
  tests/base/raster_test.cpp
  tests/document/animate_test.cpp
  tests/document/covered_test.cpp
  tests/document/posing_test.cpp
  tests/model/fit/fit_marks_test.cpp
  tests/model/rig/retarget_test.cpp
  tests/model/surface/surface_rays_test.cpp
  tests/figures/fox.cpp
  tests/figures/prince.cpp
  tests/figures/horse.cpp
  tests/figures/ballerina.cpp
  tests/figures/alien.cpp
  tests/figures/climber.cpp
  tests/figures/legs.cpp
  tests/figures/parrot.cpp
  tests/figures/monster.cpp
  tests/figures/gnome.cpp
  tests/figures/knight.cpp
  tests/figures/bear.cpp
  tests/figures/polygonise.cpp
  tests/quality/inconsistent.cpp
)
list(TRANSFORM alone PREPEND "${PROJECT_SOURCE_DIR}/")

set(targets artisketch_core artisketch_core_small artisketch_core_fast artisketch_editor artisketch_figures
  artisketch_tests artisketch_editor_tests artisketch_thread_tests)
# What only calls what is tested is run once: compiling it well takes longer than it gains.
foreach(target IN ITEMS artisketch_tests artisketch_editor_tests artisketch_thread_tests)
  if(TARGET ${target})
    target_compile_options(${target} PRIVATE -O1)
  endif()
endforeach()

foreach(target IN LISTS targets)
  if(NOT TARGET ${target})
    continue()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${folder}" NORMALIZE OUTPUT_VARIABLE path)
    if(path IN_LIST alone OR NOT path MATCHES "^${PROJECT_SOURCE_DIR}/(src|tests)/")
      continue()
    endif()
    # Together they would lose the flags that one has for itself.
    get_source_file_property(options "${path}" COMPILE_OPTIONS)
    if(options)
      continue()
    endif()
    cmake_path(GET path PARENT_PATH group)
    string(REPLACE "${PROJECT_SOURCE_DIR}/" "" group "${group}")
    string(MAKE_C_IDENTIFIER "${group}" group)
    set_source_files_properties("${path}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endforeach()
