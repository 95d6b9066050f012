# The editor: one library for the window and the page, on Dear ImGui, SDL2 and OpenGL ES 3 (WebGL2).
# It is built when asked for (`./dev edit`) or tested, and only where its needs are met: Dear ImGui's sources
# (./dev fetches Debian's), SDL2 and the icons' font.

set(ARTISKETCH_IMGUI_SOURCE "${PROJECT_SOURCE_DIR}/build/sources/imgui"
    CACHE PATH "Folder of Dear ImGui's sources, 1.90")
set(ARTISKETCH_ICONS_DIR "/usr/share/fonts/truetype/materialdesignicons-webfont"
    CACHE PATH "Folder of materialdesignicons-webfont.ttf")

if(NOT ARTISKETCH_EDITOR)
  return()
endif()
# Without a need of its there is no editor; where it was asked for, that is an error.
if(ARTISKETCH_EDITOR STREQUAL "AUTO")
  set(without STATUS)
else()
  set(without FATAL_ERROR)
endif()
find_package(SDL2 QUIET)
foreach(need IN ITEMS "${ARTISKETCH_IMGUI_SOURCE}/imgui.cpp"
        "${ARTISKETCH_ICONS_DIR}/materialdesignicons-webfont.ttf")
  if(NOT EXISTS "${need}")
    message(${without} "No editor: ${need} was not found")
    return()
  endif()
endforeach()
if(NOT SDL2_FOUND)
  message(${without} "No editor: SDL2 was not found")
  return()
endif()

# ---------------------------------------------------------------- Dear ImGui

add_library(artisketch_imgui STATIC EXCLUDE_FROM_ALL
  "${ARTISKETCH_IMGUI_SOURCE}/imgui.cpp"
  "${ARTISKETCH_IMGUI_SOURCE}/imgui_draw.cpp"
  "${ARTISKETCH_IMGUI_SOURCE}/imgui_tables.cpp"
  "${ARTISKETCH_IMGUI_SOURCE}/imgui_widgets.cpp"
)
target_include_directories(artisketch_imgui SYSTEM PUBLIC "${ARTISKETCH_IMGUI_SOURCE}")
target_compile_definitions(artisketch_imgui PUBLIC
  IMGUI_DISABLE_OBSOLETE_FUNCTIONS IMGUI_DISABLE_DEMO_WINDOWS
  IMGUI_DISABLE_DEBUG_TOOLS IMGUI_DISABLE_DEFAULT_FONT ImDrawIdx=unsigned)

# ---------------------------------------------------------------- icons

# icons.h is the list of the icons in use.
file(STRINGS "${PROJECT_SOURCE_DIR}/src/editor/ui/icons.h" icons REGEX "// U\\+")
list(TRANSFORM icons REPLACE ".*// (U\\+[0-9A-F]+).*" "\\1")
list(JOIN icons "," icons)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS src/editor/ui/icons.h)
artisketch_embedded_font(kIcons "${ARTISKETCH_ICONS_DIR}/materialdesignicons-webfont.ttf" "${icons}")

# ---------------------------------------------------------------- the guide

# docs/GUIDE.md as a page, which the editor shows.
set(ARTISKETCH_GUIDE "${CMAKE_BINARY_DIR}/guide/index.html")
file(GLOB pictures CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/docs/guide/*.png")
add_custom_command(OUTPUT "${ARTISKETCH_GUIDE}" VERBATIM
  COMMAND "${ARTISKETCH_PYTHON}" "${PROJECT_SOURCE_DIR}/cmake/guide.py" "${PROJECT_SOURCE_DIR}/docs/GUIDE.md"
          "${PROJECT_SOURCE_DIR}/docs/guide" "${CMAKE_BINARY_DIR}/guide"
  DEPENDS "${PROJECT_SOURCE_DIR}/docs/GUIDE.md" "${PROJECT_SOURCE_DIR}/cmake/guide.py" ${pictures}
  COMMENT "Making the guide's page")
add_custom_target(artisketch_guide DEPENDS "${ARTISKETCH_GUIDE}")

# ---------------------------------------------------------------- the editor

# 5  editor: ImGui only here. No folder includes one that stands below it in this list:
#   ui/        widgets and theme
#   pictures/  what is handed to the graphics card, and what it asks of it
#   session/   one document being worked on, how it is looked at, commands, jobs, files
#   canvas/    the sketch's pointer and how it is drawn; controls that several panels share
#   modes/     outline, skeleton, pose, result: a tool is a file of its own, and a line in tools.cpp
#   shell/     the panels of the window
#   gl/        what needs a screen (artisketch_window, below)
# The modes' sources are found by themselves: a new tool needs no line here.
file(GLOB_RECURSE modes CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}"
     "${PROJECT_SOURCE_DIR}/src/editor/modes/*.cpp")
add_library(artisketch_editor STATIC EXCLUDE_FROM_ALL
  src/editor/ui/fonts.cpp
  src/editor/ui/keys.cpp
  src/editor/ui/menu.cpp
  src/editor/ui/theme.cpp
  src/editor/ui/touch.cpp
  src/editor/ui/ui.cpp
  src/editor/ui/words.cpp
  src/editor/gl/damage.cpp
  src/editor/pictures/drawings.cpp
  src/editor/pictures/view_projection.cpp
  src/editor/pictures/model_picture.cpp
  src/editor/session/app.cpp
  src/editor/session/built_model.cpp
  src/editor/session/command.cpp
  src/editor/session/drawings_in.cpp
  src/editor/session/drawing_edits.cpp
  src/editor/session/edit_commands.cpp
  src/editor/session/file_commands.cpp
  src/editor/session/files.cpp
  src/editor/session/hints.cpp
  src/editor/session/jobs.cpp
  src/editor/session/language.cpp
  src/editor/session/notes.cpp
  src/editor/session/live.cpp
  src/editor/session/motions_in.cpp
  src/editor/session/part_fit.cpp
  src/editor/session/picking.cpp
  src/editor/session/session.cpp
  src/editor/session/view.cpp
  src/editor/session/view_commands.cpp
  src/editor/canvas/controls.cpp
  src/editor/canvas/layout.cpp
  src/editor/canvas/pointer.cpp
  src/editor/canvas/sketch_paint.cpp
  ${modes}
  src/editor/shell/canvas_menu.cpp
  src/editor/shell/gallery.cpp
  src/editor/shell/hints.cpp
  src/editor/shell/inspector.cpp
  src/editor/shell/model_panel.cpp
  src/editor/shell/notes_card.cpp
  src/editor/shell/picking_sheet.cpp
  src/editor/shell/sheets.cpp
  src/editor/shell/sketch_panel.cpp
  src/editor/shell/splitters.cpp
  src/editor/shell/strip.cpp
  src/editor/shell/tool_rail.cpp
  src/editor/shell/top_bar.cpp
  src/editor/shell/welcome.cpp
  src/editor/editor.cpp
  src/editor/introspection.cpp
  "${ARTISKETCH_EMBEDDED}/kIcons.cpp"
)
target_link_libraries(artisketch_editor PUBLIC artisketch_core artisketch_imgui
                      PRIVATE artisketch_warnings)

# What needs a screen: SDL's window or the page's canvas, and OpenGL in it.
add_library(artisketch_window STATIC EXCLUDE_FROM_ALL
  "${ARTISKETCH_IMGUI_SOURCE}/backends/imgui_impl_sdl2.cpp"
  src/editor/gl/open_gl.cpp
  src/editor/gl/list_painter.cpp
  src/editor/gl/window.cpp
)
target_include_directories(artisketch_window SYSTEM PRIVATE "${ARTISKETCH_IMGUI_SOURCE}/backends")
target_link_libraries(artisketch_window PUBLIC artisketch_editor PRIVATE artisketch_warnings)
if(TARGET SDL2::SDL2)
  target_link_libraries(artisketch_window PUBLIC SDL2::SDL2)
else()
  target_link_libraries(artisketch_window PUBLIC SDL2::SDL2-static)
endif()

if(NOT EMSCRIPTEN)
  target_link_libraries(artisketch_window PUBLIC GLESv2)
  add_executable(artisketch-editor EXCLUDE_FROM_ALL native_main/editor_main.cpp native_main/desktop.cpp native_main/kept_work.cpp native_main/seen_files.cpp native_main/script.cpp)
  target_link_libraries(artisketch-editor PRIVATE artisketch_window artisketch::json artisketch_warnings)
  add_dependencies(artisketch-editor artisketch_guide)
  # Beside the program, as where it is installed.
  file(GLOB beside CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/assets/languages/*.txt"
       "${PROJECT_SOURCE_DIR}/assets/gallery/*/*")
  set_property(TARGET artisketch-editor APPEND PROPERTY LINK_DEPENDS ${beside})
  foreach(folder IN ITEMS languages gallery)
    add_custom_command(TARGET artisketch-editor POST_BUILD VERBATIM
      COMMAND "${CMAKE_COMMAND}" -E copy_directory "${PROJECT_SOURCE_DIR}/assets/${folder}"
              "$<TARGET_FILE_DIR:artisketch-editor>/${folder}")
  endforeach()
endif()
