#include "converter/command.h"

#include <array>

namespace converter {
namespace {

constexpr auto table = std::to_array<Command>({
    {"bake", "A look becomes an engine's LUT picture", declare_bake},
    {"verify", "Prove a LUT picture right against OpenColorIO, or say what is wrong",
     declare_verify},
    {"check", "What is broken, folded, steep or flat in a look, and its repair", declare_check},
    {"convert", "A LUT from any format to any other, saying what is lost", declare_convert},
    {"edit", "Operators on top of a LUT, baked and kept as a recipe", declare_edit},
    {"resample", "A look on another lattice", declare_resample},
    {"compose", "Looks one after the other, as one LUT", declare_compose},
    {"invert", "A LUT that undoes a look, and what cannot be undone", declare_invert},
    {"blend", "A mixture of two looks", declare_blend},
    {"compare", "How far apart two looks are, and where most", declare_compare},
    {"apply", "A picture through a LUT", declare_apply},
    {"report", "Error against run time and bytes of every way to keep a look", declare_report},
    {"engines", "The engines: size, bits, layout, encoding and import step of each",
     declare_engines, false},
    {"info", "What is in a LUT", declare_info},
    {"encodings", "The transfer curves and gamuts that options take", declare_encodings},
    {"eval", "Colours through a LUT", declare_eval},
    {"identity", "A LUT that changes nothing", declare_identity, false},
});

} // namespace

std::span<const Command> commands() {
    return table;
}

} // namespace converter
