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
file(GLOB files CONFIGURE_DEPENDS src/files/*.cpp)
set(edits edit animate bone_axis correspondence cut drawing_edit history mend outline_edit posing skeleton_edit
  sprite_sheet strokes suggest templates)
list(TRANSFORM edits PREPEND src/document/)
set(clips acts body_plan clips contacts feet gaits joint_name library motion_map own_skeleton puppet retarget
  retarget_aims rig_profile t_pose upright_motion)
list(TRANSFORM clips PREPEND src/model/rig/)
list(APPEND edits ${clips})
list(TRANSFORM edits APPEND .cpp)
set_source_files_properties(${files} ${edits} src/model/calibrate/calibration_words.cpp
  src/model/calibrate/drawn_size.cpp src/model/calibrate/unseen_sides.cpp src/app/cli.cpp
  src/app/command_table.cpp src/app/command_manual.cpp
  src/app/document_verbs.cpp src/app/many_documents.cpp src/app/picture_verbs.cpp src/app/reconstruct_verb.cpp
  src/app/job_bytes.cpp web/page_main.cpp web/browser.cpp PROPERTIES COMPILE_OPTIONS -Oz)

# What goes over all that is drawn, and over all of a model.
set_source_files_properties(src/editor/gl/damage.cpp src/editor/pictures/model_picture.cpp
  PROPERTIES COMPILE_OPTIONS -O2)

artisketch_web_module(editor createEditor web web/page_main.cpp web/browser.cpp)
target_link_libraries(editor PRIVATE artisketch_window artisketch::json)
target_link_options(editor PRIVATE -Oz -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
artisketch_web_module(core createCore worker web/worker_main.cpp)

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
            "${folder}/${name}.artisketch" -o "${packed}.glb" --grid 64 --triangles 5300 --compress --quiet
    COMMAND "${ARTISKETCH_NODE}" --no-experimental-fetch $<TARGET_FILE:artisketch> render "${packed}.glb"
            -o "${packed}.png" --clear --frame 1 --yaw 25 --pitch 8 --size 120x144
    DEPENDS artisketch web/pack.mjs "${folder}/${name}.artisketch" ${drawings}
    COMMENT "Making the example ${name}")
  list(APPEND made "${packed}.artisketch" "${packed}.glb" "${packed}.png")
endforeach()

file(GLOB page CONFIGURE_DEPENDS web/*.js web/*.html web/*.css web/*.mjs)
add_custom_command(OUTPUT "${CMAKE_BINARY_DIR}/artisketch.html" VERBATIM
  COMMAND "${ARTISKETCH_NODE}" "${PROJECT_SOURCE_DIR}/web/assemble.mjs" "${CMAKE_BINARY_DIR}" ${examples}
  DEPENDS editor core ${made} ${page}
  COMMENT "Putting the page together")
add_custom_target(site DEPENDS "${CMAKE_BINARY_DIR}/artisketch.html")
