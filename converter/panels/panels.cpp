#include "converter/panels/all.h"

#include <array>

namespace converter {
namespace {

constexpr std::array panel_table{
    &panel::curves,     &panel::slopes, &panel::hue,  &panel::saturation, &panel::hull_ucs,
    &panel::hull_oklab, &panel::slices, &panel::cube, &panel::skin,       &panel::gradient,
};

} // namespace

std::span<const Panel* const> panels() {
    return panel_table;
}

} // namespace converter
