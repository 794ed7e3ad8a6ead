// The parts of the panel Look.
#pragma once

#include "preview/panels/ui.h"

namespace preview::panels {

void encodings_of_look(Ui& ui);
/// A list of curves, each of which brings its own gamut, and one of gamuts; `place` is how their
/// names for mark() begin.
void encoding_choice(Ui& ui, const std::string& label, const std::string& place,
                     lutlib::Encoding& chosen);

/// A page of the panel: some operators, large, whether the recipe has them already or not.
struct LookPage {
    std::string_view name;
    std::string_view help;
    std::span<const std::string_view> ops; ///< empty: the recipe's own, in their order
    void (*above)(Ui& ui) = nullptr;       ///< draws what stands above them; null: nothing
    bool is_over_one_axis = false; ///< each of them is a curve over the same axis as the others'
};
std::span<const LookPage> look_pages();

/// ASC CDL files on the page CDL.
void cdl_files(Ui& ui);

/// The operators of a page that names some: the recipe's first of each kind, or a new one, which
/// the recipe gets at its end as soon as it is changed.
void page_of_operators(Ui& ui, const LookPage& page);

/// How much of something is taken, 0 to 100 %; `place` is its name for mark().
void opacity_control(Ui& ui, const char* label, const char* help, double& opacity,
                     const std::string& place);

} // namespace preview::panels
