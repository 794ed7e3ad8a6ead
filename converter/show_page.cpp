#include "converter/show_page.h"

#include "lutlib/plot/axis.h"
#include "lutlib/plot/figure_sheet.h"
#include "lutlib/plot/page.h"

namespace converter {

std::string show_html(const Shown& shown) {
    plot::Page page;
    page.title = shown.title;
    for (const std::string& remark : shown.remarks) {
        page.summary += (page.summary.empty() ? "" : "; ") + remark;
    }
    for (const ShownPanel& panel : shown.panels) {
        page.sections.push_back("<h2>" + plot::escaped(std::string(panel.panel->label)) +
                                "</h2>\n<p>" + plot::escaped(std::string(panel.panel->help)) +
                                "</p>\n" + plot::figures_html(panel.figures));
    }
    return html(page);
}

plot::Drawing show_drawing(const Shown& shown, int width) {
    std::vector<std::string> headlines{shown.title};
    headlines.insert(headlines.end(), shown.remarks.begin(), shown.remarks.end());
    std::vector<plot::Figure> figures;
    for (const ShownPanel& panel : shown.panels) {
        figures.insert(figures.end(), panel.figures.begin(), panel.figures.end());
    }
    return plot::figure_sheet(headlines, figures, plot::sheet_dots(width, figures));
}

} // namespace converter
