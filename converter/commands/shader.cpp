// lutconv shader: an engine's lookup as code for a shader of one's own.
#include "converter/command.h"
#include "converter/options.h"
#include "converter/report.h"
#include "converter/usage.h"
#include "lutlib/bake/bake.h"
#include "lutlib/engine/shader_code.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <fmt/core.h>

#include <memory>

namespace converter {
namespace {

struct Options {
    EngineOption engine;
    std::string language, interpolation, output;
    int size = 0;
};

int run(const Options& o) {
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
    const auto o = std::make_shared<Options>();
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
    verb.add_option("-o,--output", o->output, "the file to write, or - for standard output")
        .required();
    verb.footer(language_list());
    return [o] { return run(*o); };
}

} // namespace converter
