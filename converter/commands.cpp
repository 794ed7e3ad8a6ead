#include "converter/command.h"

#include <array>

namespace converter {
namespace {

constexpr std::array<Command, 9> table{{
    {"bake", "A look becomes an engine's LUT picture", declare_bake},
    {"verify", "Prove a LUT picture right against OpenColorIO, or say what is wrong",
     declare_verify},
    {"convert", "A LUT from any format to any other, saying what is lost", declare_convert},
    {"edit", "Operators on top of a LUT, baked and kept as a recipe", declare_edit},
    {"apply", "A picture through a LUT", declare_apply},
    {"report", "Error against run time and bytes of every way to keep a look", declare_report},
    {"info", "What is in a LUT", declare_info},
    {"eval", "Colours through a LUT", declare_eval},
    {"identity", "A LUT that changes nothing", declare_identity},
}};

} // namespace

std::span<const Command> commands() {
    return table;
}

} // namespace converter
