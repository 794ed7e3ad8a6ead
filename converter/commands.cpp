#include "converter/command.h"

#include <array>

namespace converter {
namespace {

constexpr auto table = std::to_array<Command>({
    {"bake", "Bake a look into the LUT picture that an engine loads", declare_bake},
    {"verify", "Prove a LUT picture right against OpenColorIO, or name what is wrong with it",
     declare_verify},
    {"check", "Find what is broken, folded, steep or flat in a look, and repair it", declare_check},
    {"convert", "Convert a LUT between formats, and list what is lost", declare_convert},
    {"edit", "Apply operators to a LUT; bake the result, save the recipe", declare_edit},
    {"resample", "Resample a look onto another lattice", declare_resample},
    {"compose", "Compose looks, one after the other, into one LUT", declare_compose},
    {"invert", "Invert a look, and report what cannot be undone", declare_invert},
    {"blend", "Blend two looks", declare_blend},
    {"compare", "Measure how far apart two looks are, and where most", declare_compare},
    {"apply", "Apply a LUT to a picture", declare_apply},
    {"report", "Report error against run time and size for every way to store a look",
     declare_report},
    {"engines", "The engines: size, bits, layout, encoding and import step of each",
     declare_engines, false},
    {"info", "Show what a LUT file or picture holds", declare_info},
    {"encodings", "The transfer curves and gamuts that options take", declare_encodings},
    {"eval", "Evaluate a LUT at colours", declare_eval},
    {"identity", "Write the identity LUT", declare_identity, false},
});

} // namespace

std::span<const Command> commands() {
    return table;
}

} // namespace converter
