#include "preview/graph/plan.h"

#include <fmt/format.h>

#include <algorithm>

namespace preview {

std::string explain(const Graph& graph, const Plan& plan) {
    std::size_t width = 0;
    for (const PassRecord& pass : graph.passes()) {
        width = std::max(width, pass.name.size());
    }
    for (const Withheld& item : graph.withheld()) {
        width = std::max(width, item.name.size());
    }
    std::string text;
    for (std::size_t index = 0; index < graph.passes().size(); ++index) {
        const PassRecord& pass = graph.passes()[index];
        std::string outputs;
        for (const Use& use : pass.uses) {
            if (!use.writes) {
                continue;
            }
            const Version& version = graph.versions()[use.version];
            const bool lives = plan.version_lives[use.version];
            if (plan.pass_lives[index] && lives) {
                const Resource& made = graph.resources()[version.resource];
                outputs += (outputs.empty() ? "writes " : ", ") + made.name;
                if (made.kind == ResourceKind::image) {
                    outputs += fmt::format(" {}x{}", made.image.width, made.image.height);
                }
            }
        }
        text += plan.pass_lives[index]
                    ? fmt::format("kept      {:<{}}  {}\n", pass.name, width, outputs)
                    : fmt::format("left out  {:<{}}  {}\n", pass.name, width, plan.reasons[index]);
    }
    for (const Withheld& item : graph.withheld()) {
        text += fmt::format("left out  {:<{}}  {}\n", item.name, width, item.reason);
    }
    return text;
}

} // namespace preview
