# Makes a C++ file with a function NAME that returns the bytes of a text file, and NAME_sha256 that returns their SHA-256 in
# hexadecimal digits.
# usage: cmake -DINPUT=file -DOUTPUT=file.cpp -DHEADER=path.hpp -DFUNCTION=name -P EmbedText.cmake
file(READ ${INPUT} bytes HEX)
file(SHA256 ${INPUT} hash)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
file(WRITE ${OUTPUT} "#include \"${HEADER}\"

namespace rigor {

namespace {
constexpr unsigned char bytes[] = {
${bytes}};
}  // namespace

std::string_view ${FUNCTION}() {
  return {reinterpret_cast<const char*>(bytes), sizeof bytes};
}
std::string_view ${FUNCTION}_sha256() {
  return \"${hash}\";
}

}  // namespace rigor
")
