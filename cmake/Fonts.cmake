# Fonts, subset to what is written and embedded in the program: Inter for the pictures' words and the
# editor's, once for both.

set(ARTISKETCH_INTER_DIR "/usr/share/fonts/opentype/inter" CACHE PATH "Folder of Inter-*.otf")
# Debian's Python holds Debian's fontTools, whichever Python comes first on the PATH.
find_program(ARTISKETCH_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH
             DOC "Python with fontTools")
find_program(ARTISKETCH_PYTHON NAMES python3)
execute_process(COMMAND "${ARTISKETCH_PYTHON}" -c "import fontTools.subset" RESULT_VARIABLE failed
                OUTPUT_QUIET ERROR_QUIET)
if(failed)
  message(FATAL_ERROR "Python's fontTools was not found (Debian: python3-fonttools)")
endif()
if(NOT EXISTS "${ARTISKETCH_INTER_DIR}/Inter-Regular.otf")
  message(FATAL_ERROR "${ARTISKETCH_INTER_DIR}/Inter-Regular.otf was not found (Debian: fonts-inter)")
endif()

# Subsets `input` to `unicodes` and embeds it as embedded::NAME, in ${ARTISKETCH_EMBEDDED}/NAME.cpp.
# Nothing here kerns or hints, so what serves only that goes too. The box for what a font lacks stays.
set(ARTISKETCH_EMBEDDED "${PROJECT_BINARY_DIR}/embedded")
file(MAKE_DIRECTORY "${ARTISKETCH_EMBEDDED}")
function(artisketch_embedded_font name input unicodes)
  cmake_path(GET input EXTENSION extension)
  set(subset "${ARTISKETCH_EMBEDDED}/${name}${extension}")
  add_custom_command(OUTPUT "${ARTISKETCH_EMBEDDED}/${name}.cpp" VERBATIM
    COMMAND "${ARTISKETCH_PYTHON}" -m fontTools.subset "${input}" "--output-file=${subset}"
            "--unicodes=${unicodes}" --layout-features= --no-hinting --desubroutinize
            --notdef-outline --name-IDs= --drop-tables+=GPOS,GSUB,GDEF,BASE,STAT,DSIG
    COMMAND "${CMAKE_COMMAND}" "-DINPUT=${subset}" "-DOUTPUT=${ARTISKETCH_EMBEDDED}/${name}.cpp"
            -DNAME=${name} -P "${PROJECT_SOURCE_DIR}/cmake/EmbedFile.cmake"
    DEPENDS "${input}" "${PROJECT_SOURCE_DIR}/cmake/EmbedFile.cmake" COMMENT "Subsetting ${name}")
endfunction()

# Latin with its accents, Greek, Cyrillic; the punctuation and signs that the editor's words use.
set(letters "U+20-7E,U+A0-17F,U+386-3CE,U+400-45F,U+2010-2026,U+2030,U+20AC,U+2190-2193,U+2212,U+2318,U+21E7")
artisketch_embedded_font(kInterRegular "${ARTISKETCH_INTER_DIR}/Inter-Regular.otf" "${letters}")
artisketch_embedded_font(kInterSemiBold "${ARTISKETCH_INTER_DIR}/Inter-SemiBold.otf" "${letters}")
