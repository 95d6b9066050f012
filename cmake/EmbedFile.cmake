# cmake -DINPUT=FILE -DOUTPUT=FILE.cpp -DNAME=symbol -P EmbedFile.cmake
# Writes a source file that defines std::string_view embedded::NAME with the bytes of INPUT.
file(READ "${INPUT}" bytes HEX)
string(LENGTH "${bytes}" digits)
math(EXPR size "${digits} / 2")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "// Made at build time from ${INPUT}.
#include <string_view>
namespace artisketch::embedded {
static const unsigned char kBytes[] = {${bytes}};
extern const std::string_view ${NAME};
const std::string_view ${NAME}(reinterpret_cast<const char*>(kBytes), ${size});
}
")
