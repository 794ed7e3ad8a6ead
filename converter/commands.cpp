#include "converter/command.h"

#include <array>

namespace converter {
namespace {

constexpr auto command_rows = std::to_array<Command>({
    {.name = "bake",
     .help = "Bake a look into the LUT picture that an engine loads",
     .declare = declare_bake},
    {.name = "verify",
     .help = "Prove a LUT picture right against OpenColorIO, or name what is wrong with it",
     .declare = declare_verify},
    {.name = "check",
     .help = "Find what is broken, folded, steep or flat in a look, and repair it",
     .declare = declare_check},
    {.name = "convert",
     .help = "Convert a LUT between formats, and list what is lost",
     .declare = declare_convert},
    {.name = "edit",
     .help = "Apply operators to a LUT; bake the result, save the recipe",
     .declare = declare_edit},
    {.name = "resample",
     .help = "Resample a look onto another lattice",
     .declare = declare_resample},
    {.name = "compose",
     .help = "Compose looks, one after the other, into one LUT",
     .declare = declare_compose},
    {.name = "invert",
     .help = "Invert a look, and report what cannot be undone",
     .declare = declare_invert},
    {.name = "blend", .help = "Blend two looks", .declare = declare_blend},
    {.name = "compare",
     .help = "Measure how far apart two looks are, and where most",
     .declare = declare_compare},
    {.name = "extract",
     .help = "Find the neutral strip in a picture that was graded, and make it a LUT",
     .declare = declare_extract,
     .reads_looks = false},
    {.name = "apply", .help = "Apply a LUT to a picture", .declare = declare_apply},
    {.name = "report",
     .help = "Report error against run time and size for every way to store a look",
     .declare = declare_report},
    {.name = "engines",
     .help = "The engines: size, bits, layout, encoding and import step of each",
     .declare = declare_engines,
     .reads_looks = false,
     .is_answer = true},
    {.name = "shader",
     .help = "Write an engine's lookup as code for a shader of your own",
     .declare = declare_shader,
     .reads_looks = false},
    {.name = "info",
     .help = "Show what a LUT file or picture holds",
     .declare = declare_info,
     .is_answer = true},
    {.name = "encodings",
     .help = "The transfer curves and gamuts that options take",
     .declare = declare_encodings,
     .reads_looks = false,
     .is_answer = true},
    {.name = "operators",
     .help = "The operators that edit and recipes take, with their ranges",
     .declare = declare_operators,
     .reads_looks = false,
     .is_answer = true},
    {.name = "formats",
     .help = "The LUT file formats, and whether each is read and written",
     .declare = declare_formats,
     .reads_looks = false,
     .is_answer = true},
    {.name = "eval",
     .help = "Evaluate a LUT at colours",
     .declare = declare_eval,
     .is_answer = true},
    {.name = "identity",
     .help = "Write the identity LUT",
     .declare = declare_identity,
     .reads_looks = false},
});

} // namespace

std::span<const Command> commands() {
    return command_rows;
}

} // namespace converter
