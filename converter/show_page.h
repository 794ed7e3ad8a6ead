// What `show` draws of panels: a page, a drawing or a picture of all their figures.
#pragma once

#include "converter/panels/panel.h"
#include "lutlib/plot/drawing.h"

#include <string>
#include <vector>

namespace converter {

struct ShownPanel {
    const Panel* panel = nullptr;
    std::vector<plot::Figure> figures;
};

struct Shown {
    std::string title;                ///< the looks' names
    std::vector<std::string> remarks; ///< what must be known of them, a sentence each
    std::vector<ShownPanel> panels;
};

/// A self-contained page: a section for each panel, with what it shows.
std::string show_html(const Shown& shown);

/// All figures below the title and the remarks, for a picture of so many pixels across.
plot::Drawing show_drawing(const Shown& shown, int width);

} // namespace converter
