# The page: two modules, the editor's and the worker's, and what puts them together (web/). `./dev web`
# fetches what it needs.

if(NOT TARGET artisketch_editor)
  message(STATUS "No page: it needs the editor")
  return()
endif()

# Modules that a script begins by calling NAME(); `exports` are their functions beside malloc and free.
function(artisketch_web_module name begin environment)
  add_executable(${name} EXCLUDE_FROM_ALL ${ARGN})
  target_link_libraries(${name} PRIVATE artisketch_core artisketch_warnings)
  target_link_options(${name} PRIVATE
    -sMODULARIZE=1 -sEXPORT_NAME=${begin} -sENVIRONMENT=${environment}
    -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=2GB -sFILESYSTEM=0
    -sDYNAMIC_EXECUTION=0  # the page's policy forbids eval
    -sEXPORTED_FUNCTIONS=_malloc,_free -sEXPORTED_RUNTIME_METHODS=UTF8ToString,HEAPU8
    $<$<VERSION_GREATER_EQUAL:${EMSCRIPTEN_VERSION},3.1.27>:-sSTACK_SIZE=5MB>)
endfunction()

# Small where it isn't slow: the interface, what a person does to the document, the reading and writing
# of files, and what makes clips.
target_compile_options(artisketch_editor PRIVATE -Oz)
target_compile_options(artisketch_window PRIVATE -Oz)
target_compile_options(artisketch_imgui PRIVATE -Oz)
set(edits edit animate bone_axis correspondence covered cut drawing_edit figure_cells figure_parts history
  joint_limits line_fit mend outline_edit place_words posing region_outline skeleton_edit split sprite_sheet strokes
  suggest templates)
set(clips acts body_plan clips contacts feet gaits joint_name library motion_map own_skeleton puppet retarget
  retarget_aims rig_profile t_pose upright_motion)
set(words calibration_words drawn_size unseen_sides)
set(app cli command_table command_manual document_verbs many_documents picture_verbs reconstruct_verb job_bytes)
list(TRANSFORM edits PREPEND src/document/)
list(TRANSFORM clips PREPEND src/model/rig/)
list(TRANSFORM words PREPEND src/model/calibrate/)
list(TRANSFORM app PREPEND src/app/)
get_target_property(sources artisketch_core SOURCES)
set(small ${sources})
list(FILTER small INCLUDE REGEX "^src/files/")
foreach(source IN LISTS edits clips words app)
  if(NOT "${source}.cpp" IN_LIST sources)
    message(FATAL_ERROR "cmake/Web.cmake names ${source}.cpp, which isn't one of the core's sources")
  endif()
  list(APPEND small "${source}.cpp")
endforeach()
# What a drag waits for: lines and rows of a few numbers at a time, which the compiler must copy and
# vectorise to make them fast.
set(fast ${sources})
list(FILTER fast INCLUDE REGEX "^src/(base|model/surface)/")
# Each is a library of its own, so that each has its flags.
list(REMOVE_ITEM sources ${small} ${fast})
foreach(part IN ITEMS small fast)
  add_library(artisketch_core_${part} OBJECT ${${part}})
  foreach(property IN ITEMS INCLUDE_DIRECTORIES COMPILE_DEFINITIONS LINK_LIBRARIES)
    get_target_property(value artisketch_core ${property})
    set_property(TARGET artisketch_core_${part} PROPERTY ${property} ${value})
  endforeach()
  list(APPEND sources $<TARGET_OBJECTS:artisketch_core_${part}>)
endforeach()
set_property(TARGET artisketch_core PROPERTY SOURCES ${sources})
target_compile_options(artisketch_core_small PRIVATE -Oz)
set_source_files_properties(web/page_main.cpp web/browser.cpp PROPERTIES COMPILE_OPTIONS -Oz)
# The rest no larger than it must be: loops that are copied for more at a time and functions inlined
# wherever they might be made it a fourth larger and 3 % faster. What counts is in Eigen's packets.
target_compile_options(artisketch_core PRIVATE
  -O2 -fno-unroll-loops -fno-vectorize "SHELL:-mllvm -inline-threshold=40")

# What goes over all that is drawn, and over all of a model.
set_source_files_properties(src/editor/gl/damage.cpp src/editor/pictures/model_picture.cpp
  PROPERTIES COMPILE_OPTIONS -O2)

artisketch_web_module(editor createEditor web web/page_main.cpp web/browser.cpp)
target_link_libraries(editor PRIVATE artisketch_window artisketch::json)
target_link_options(editor PRIVATE -Oz -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
artisketch_web_module(core createCore worker web/worker_main.cpp)
# Of a function that several objects have, as templates give it, the linker takes the one it meets first:
# those that are fast before those that are small, which made calibration four times as slow.
foreach(program IN ITEMS core artisketch)
  target_sources(${program} PRIVATE $<TARGET_OBJECTS:artisketch_core_fast> $<TARGET_OBJECTS:artisketch_core>)
endforeach()

# The examples as the page shows them: drawings inside, the model made, and its picture. The first
# greets.
find_program(ARTISKETCH_NODE NAMES node nodejs NO_CMAKE_FIND_ROOT_PATH DOC "Runs what builds the page")
set(examples hero fox robot heart circles)
set(made "")
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/examples")
foreach(name IN LISTS examples)
  set(folder "${PROJECT_SOURCE_DIR}/assets/examples/${name}")
  set(packed "${CMAKE_BINARY_DIR}/examples/${name}")
  file(GLOB drawings CONFIGURE_DEPENDS "${folder}/*.png")
  # The core just built makes the models: those that the worker would make, in fewer triangles and packed,
  # since they are a good part of what the page loads.
  add_custom_command(OUTPUT "${packed}.artisketch" "${packed}.glb" "${packed}.png" VERBATIM
    COMMAND "${ARTISKETCH_NODE}" "${PROJECT_SOURCE_DIR}/web/pack.mjs" "${folder}/${name}.artisketch"
            "${packed}.artisketch"
    COMMAND "${ARTISKETCH_NODE}" --no-experimental-fetch $<TARGET_FILE:artisketch> reconstruct
            "${folder}/${name}.artisketch" -o "${packed}.glb" --grid 64 --triangles 4800 --compress --quiet
    COMMAND "${ARTISKETCH_NODE}" --no-experimental-fetch $<TARGET_FILE:artisketch> render "${packed}.glb"
            -o "${packed}.png" --clear --frame 1 --yaw 25 --pitch 8 --size 120x144
    DEPENDS artisketch web/pack.mjs "${folder}/${name}.artisketch" ${drawings}
    COMMENT "Making the example ${name}")
  list(APPEND made "${packed}.artisketch" "${packed}.glb" "${packed}.png")
endforeach()

# The gallery: its drawings inside, too; what it shows of a model is there already (./dev pictures).
set(figures "")
file(MAKE_DIRECTORY "${CMAKE_BINARY_DIR}/gallery")
file(GLOB folders CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/assets/gallery/*")
foreach(folder IN LISTS folders)
  cmake_path(GET folder FILENAME name)
  set(packed "${CMAKE_BINARY_DIR}/gallery/${name}")
  file(GLOB drawings CONFIGURE_DEPENDS "${folder}/*.png")
  add_custom_command(OUTPUT "${packed}.artisketch" "${packed}.png" VERBATIM
    COMMAND "${ARTISKETCH_NODE}" "${PROJECT_SOURCE_DIR}/web/pack.mjs" "${folder}/${name}.artisketch"
            "${packed}.artisketch"
    COMMAND "${CMAKE_COMMAND}" -E copy "${folder}/model.png" "${packed}.png"
    DEPENDS web/pack.mjs "${folder}/${name}.artisketch" ${drawings}
    COMMENT "Packing the figure ${name}")
  list(APPEND figures ${name})
  list(APPEND made "${packed}.artisketch" "${packed}.png")
endforeach()

file(GLOB page CONFIGURE_DEPENDS web/*.js web/*.html web/*.css web/*.mjs assets/languages/*.txt)
add_custom_command(OUTPUT "${CMAKE_BINARY_DIR}/artisketch.html" VERBATIM
  COMMAND "${ARTISKETCH_NODE}" "${PROJECT_SOURCE_DIR}/web/assemble.mjs" "${CMAKE_BINARY_DIR}" ${examples} -- ${figures}
  DEPENDS editor core "${ARTISKETCH_GUIDE}" ${made} ${page}
  COMMENT "Putting the page together")
add_custom_target(site DEPENDS "${CMAKE_BINARY_DIR}/artisketch.html")
