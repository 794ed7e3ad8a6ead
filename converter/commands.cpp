#include "converter/command.h"

#include <array>

namespace converter {
namespace {

constexpr std::array<Command, 4> table{{
    {"bake", "A look becomes an engine's LUT picture", declare_bake},
    {"info", "What is in a LUT", declare_info},
    {"eval", "Colours through a LUT", declare_eval},
    {"identity", "A LUT that changes nothing", declare_identity},
}};

} // namespace

std::span<const Command> commands() {
    return table;
}

} // namespace converter
