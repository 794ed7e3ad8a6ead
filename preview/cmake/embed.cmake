# Writes OUTPUT, a C++ file that defines preview::gpu::shaders() from the SPIR-V files MODULES.
set(arrays "")
set(table "")
set(index 0)
foreach(module IN LISTS MODULES)
    get_filename_component(name ${module} NAME_WLE)
    file(READ ${module} hex HEX)
    string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${hex}")
    string(APPEND arrays "constexpr std::uint32_t code_${index}[] = {${words}};\n")
    string(APPEND table "    {\"${name}\", code_${index}},\n")
    math(EXPR index "${index} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Written by the build from shaders/.
#include \"preview/gpu/shaders.h\"

namespace preview::gpu {
namespace {
${arrays}
constexpr ShaderCode table[] = {
${table}};
} // namespace

std::span<const ShaderCode> shaders() {
    return table;
}

} // namespace preview::gpu
")
