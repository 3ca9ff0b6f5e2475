# Writes a font file into one C++ source, so that the library draws captions without a file at hand when it runs.
# cmake -DOUTPUT=caption_font.cpp -DFONT=DejaVuSansMono.ttf -P embed_font.cmake

file(READ "${FONT}" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "// Generated from ${FONT} by embed_font.cmake.
namespace heckbert::report {

extern const unsigned char caption_font[];
const unsigned char caption_font[] = {
${bytes}};

}  // namespace heckbert::report
")
