#include "preview/report/report.h"

#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/report/choose.h"

#include <fmt/format.h>

namespace preview::report {

RendererReport make_report(const StudyTools& tools, const Situation& situation,
                           const ReportSettings& settings, const Progress& progress) {
    RendererReport out;
    out.input = situation.shown->name;
    out.device = tools.renderer.device().name();
    out.look = tools.look.name;
    out.is_cpu = tools.renderer.is_cpu();
    out.settings = settings;
    const bool is_whole = settings.only.empty();
    for (const Study* const study : is_whole ? studies() : settings.only) {
        progress(std::string(study->title));
        const std::size_t first = out.rows.size();
        for (Row& row : rows_of(tools, *study, situation, settings, out.left_out)) {
            row.dominated_by += first;
            out.rows.push_back(std::move(row));
        }
    }
    out.glare = glare_model(
        situation.has_scene() ? static_cast<double>(situation.settings.orbit.field_of_view) : 45);
    progress("the choice for a budget");
    out.choice = choice_of(tools, situation, settings, out.rows);
    tools.renderer.forget();
    if (!is_whole) {
        return out;
    }
    progress("what leaving out saves");
    const Situation last = studied(situation, settings.sizes.back());
    const GpuLook look(tools.renderer.device(),
                       look_for(tools.look.table, table_lookup(*tools.look.table)).data);
    for (const SavingStage& stage : saving_stages(last, &look)) {
        out.savings.push_back(saving_of(tools.renderer, stage, settings.rounds));
    }
    tools.renderer.forget();
    progress("how costs grow");
    out.growth = growth_of(tools.renderer, last, settings.rounds);
    return out;
}

} // namespace preview::report
