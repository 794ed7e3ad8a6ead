// lutconv shader: an engine's lookup, or a look itself, as code for a shader of one's own.
#include "converter/command.h"
#include "converter/inline_shader.h"
#include "converter/options.h"
#include "converter/report.h"
#include "converter/unused.h"
#include "converter/usage.h"
#include "lutlib/bake/bake.h"
#include "lutlib/engine/shader_code.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <fmt/core.h>

#include <memory>

namespace converter {
namespace {

struct ShaderOptions {
    EngineOption engine;
    std::string language, interpolation, output, inlined;
    int size = 0;
    double max_delta_e = 1;
};

int run_shader(const ShaderOptions& o, const Verb& verb) {
    const bool reads_picture = o.inlined.empty();
    const std::string why_not = "the look itself is in the code, which reads no engine's picture";
    tell_unused(verb, {{"--engine", reads_picture, why_not},
                       {"--interpolation", reads_picture, why_not},
                       {"--size", reads_picture, why_not},
                       {"--max-delta-e", !reads_picture, "only --inline has an error to keep to"}});
    if (!reads_picture) {
        return write_inline_shader({o.inlined, o.language, o.output, o.max_delta_e});
    }
    const lutlib::Engine& engine = o.engine.get();
    const lutlib::ShaderLanguage& language =
        lutlib::require_named(lutlib::shader_languages(), "language", o.language);
    const int size = o.size ? o.size : engine.default_size;
    check_contract(engine, size, engine.default_bits);
    const lutlib::Interpolation how =
        o.interpolation.empty()
            ? engine.interpolation
            : lutlib::require_named(lutlib::interpolations(), "interpolation", o.interpolation)
                  .kind;
    lutlib::io::write_file(o.output, lutlib::shader_code({engine, language, size, how}));
    const lutlib::PictureSize picture = *lutlib::layout_named(engine.layout)->picture(size);
    print(fmt::format("{} <- the lookup of {} ({}) in {}\n"
                      "  lut_lookup() reads a picture of {}x{} pixels, {} nodes per axis, {} "
                      "between them\n  {}\n",
                      output_text(o.output), engine.label, engine.name, language.label,
                      picture.width, picture.height, size, name_of(how), language.trial),
          o.output);
    return ok;
}

std::string language_list() {
    std::string out = "Languages:\n";
    for (const lutlib::ShaderLanguage& row : lutlib::shader_languages()) {
        out += fmt::format("  {:<8} {:<14} {}\n", row.name, row.label, row.trial);
    }
    return out;
}

} // namespace

Run declare_shader(Verb& verb) {
    const auto o = std::make_shared<ShaderOptions>();
    o->engine.declare(verb, "piccolo");
    verb.add_option("--language", o->language,
                    "one of: " + lutlib::names_of(lutlib::shader_languages()))
        .required();
    verb.add_option("--interpolation", o->interpolation,
                    "between the nodes: " + lutlib::names_of(lutlib::interpolations()) +
                        " (default: as the engine; tetrahedral keeps greys between greys and "
                        "fetches least)");
    verb.add_option("--size", o->size, "nodes per axis (default: the engine's)")
        .takes(Takes::cube_size);
    verb.add_option(
        "--inline", o->inlined,
        "put this look itself into the code, a LUT or recipe file that is small enough, "
        "or - for standard input: as curves, a matrix and curves, or packed nodes");
    verb.add_option("--max-delta-e", o->max_delta_e,
                    "largest dE2000 that --inline may have from the look, anywhere in its domain")
        .takes(Takes::above_zero)
        .capture_default_str();
    verb.add_output("-o,--output", o->output, "the file to write, or - for standard output")
        .required();
    verb.footer(language_list());
    return [o, &verb] { return run_shader(*o, verb); };
}

} // namespace converter
