#include "converter/engine_page.h"

#include "lutlib/engine/shader_code.h"

#include <fmt/core.h>

namespace converter {
namespace {

using lutlib::Engine;

std::string chunks_text(const Engine& engine) {
    switch (engine.color_chunks) {
    case lutlib::ColorChunks::ignored:
        return "ignored";
    case lutlib::ColorChunks::converted:
        return "the loader converts the codes by them, so there must be none";
    case lutlib::ColorChunks::unknown:
        break;
    }
    return "not documented, so there should be none";
}

std::string contract(const Engine& e) {
    const lutlib::Layout& layout = *lutlib::layout_named(e.layout);
    const lutlib::PictureSize extent = *layout.picture(e.default_size);
    return fmt::format("| | |\n|---|---|\n"
                       "| picture | {}x{} pixels of {} nodes per axis, unless another size is "
                       "asked for; sizes: {} |\n"
                       "| layout | `{}`: {} |\n"
                       "| bits a sample | {} |\n"
                       "| sRGB chunk | {} |\n"
                       "| chunks gAMA, cHRM, iCCP | {} |\n"
                       "| feeds | {} |\n"
                       "| lookup | {} |\n"
                       "| documented in | {} |\n",
                       extent.width, extent.height, e.default_size, sizes_of(e), layout.name,
                       layout.help, list_of(e.bits),
                       e.srgb_tag == lutlib::SrgbTag::present ? "must be there"
                                                              : "must not be there",
                       chunks_text(e), e.input, e.lookup_help, e.source);
}

std::string check(const Engine& e) {
    return fmt::format(
        "1. `lutconv identity --engine {0} -o identity.png`, imported as above, must leave the "
        "picture as it is. Where it does not, the import converts, compresses or filters it.\n"
        "2. Take a screenshot with the identity, then one with `strip.png`. `lutconv apply LOOK "
        "screenshot.png -o expected.png` says what the second should be.\n"
        "3. `lutconv verify strip.png --against LOOK --engine {0}` proves the picture itself "
        "right, "
        "or says what is wrong with it, also after other programs saved it anew.\n",
        e.name);
}

} // namespace

std::string list_of(std::span<const int> values) {
    const auto count = static_cast<int>(values.size());
    if (count > 3 && values.back() - values.front() == count - 1) {
        return fmt::format("{} to {}", values.front(), values.back());
    }
    std::string out;
    for (const int value : values) {
        out += (out.empty() ? "" : " or ") + std::to_string(value);
    }
    return out;
}

std::string sizes_of(const Engine& engine) {
    return engine.sizes.empty() ? std::string(lutlib::layout_named(engine.layout)->sizes)
                                : list_of(engine.sizes);
}

std::string engine_page(const Engine& e) {
    const lutlib::ShaderLanguage& glsl = lutlib::shader_languages().front();
    return fmt::format(
        "# {1}\n\n"
        "Made by `lutconv engines --page {0}`.\n\n"
        "## What it wants\n\n{2}\n"
        "## Make and import it\n\n"
        "```\nlutconv bake LOOK -o strip.png --engine {0}\n```\n\n"
        "Import: {3}.\n\n"
        "## Check it in the engine\n\n{4}\n"
        "## The lookup in a shader of your own\n\n"
        "`lutconv shader --engine {0} --language {5} -o {6}`; other languages, sizes and "
        "interpolations by its options.\n\n"
        "```glsl\n{7}```\n",
        e.name, e.label, contract(e), e.import, check(e), glsl.name, glsl.file,
        lutlib::shader_code({e, glsl, e.default_size, e.interpolation}));
}

} // namespace converter
