# What `cmake --install` puts where, and packages of it: `./dev release`.

# Only what was built: the tests are no part of it.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
include(GNUInstallDirs)

# The manual and the completions, as the program prints them from its own words.
set(words "${CMAKE_CURRENT_BINARY_DIR}/words")
file(MAKE_DIRECTORY "${words}")
add_custom_command(VERBATIM
  OUTPUT "${words}/artisketch.1" "${words}/artisketch" "${words}/_artisketch" "${words}/artisketch.fish"
  COMMAND artisketch manual > "${words}/artisketch.1"
  COMMAND artisketch completions bash > "${words}/artisketch"
  COMMAND artisketch completions zsh > "${words}/_artisketch"
  COMMAND artisketch completions fish > "${words}/artisketch.fish"
  DEPENDS artisketch COMMENT "Writing the manual and the completions")
add_custom_target(artisketch_manual ALL DEPENDS "${words}/artisketch.1")

install(TARGETS artisketch)
install(FILES "${words}/artisketch.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${words}/artisketch" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
install(FILES "${words}/_artisketch" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions")
install(FILES "${words}/artisketch.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/artisketch" RENAME copyright)
install(FILES README.md CHANGELOG.md DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/artisketch")
install(FILES docs/FORMAT.md docs/GUIDE.md docs/MANY.md docs/MOTION.md DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/artisketch/docs")
install(FILES assets/desktop/artisketch.xml DESTINATION "${CMAKE_INSTALL_DATADIR}/mime/packages")
install(FILES assets/desktop/artisketch.svg
  DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")

# The editor, and the examples' models for its first screen, where they were made.
if(TARGET artisketch-editor)
  install(TARGETS artisketch-editor OPTIONAL)
  install(CODE "if(EXISTS \"$<TARGET_FILE:artisketch-editor>\")
    file(INSTALL \"${PROJECT_SOURCE_DIR}/assets/desktop/artisketch.desktop\"
      DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/applications\")
  endif()")
endif()
install(DIRECTORY assets/languages DESTINATION "${CMAKE_INSTALL_DATADIR}/artisketch")
foreach(name IN ITEMS hero fox robot heart circles)
  install(DIRECTORY "assets/examples/${name}" DESTINATION "${CMAKE_INSTALL_DATADIR}/artisketch/examples")
  install(DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/examples/${name}" OPTIONAL
    DESTINATION "${CMAKE_INSTALL_DATADIR}/artisketch/examples")
endforeach()
install(DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/guide" OPTIONAL DESTINATION "${CMAKE_INSTALL_DATADIR}/artisketch")
install(DIRECTORY assets/gallery DESTINATION "${CMAKE_INSTALL_DATADIR}/artisketch")

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME artisketch)
set(CPACK_PACKAGE_VENDOR "ArtiSketch developers")
set(CPACK_PACKAGE_CONTACT "ArtiSketch developers <noreply@artisketch.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "3D characters that move, from a few drawings")
set(CPACK_PACKAGE_DESCRIPTION "An editor and a command line that make a rigged, textured glTF model from
drawings of a character in several poses, outlines of its parts and a rough skeleton.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# With SOURCE_DATE_EPOCH every file is as old as that: the same sources give the same package.
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/SetTimes.cmake")
include(CPack)
