// Every skip is held to its bound, from a bare picture to the full scene.
#include "tests/preview/report/report_fixture.h"
#include "tests/support/thorough.h"

#include "preview/look/gpu_look.h"
#include "preview/look/look_bake.h"
#include "preview/report/leaving_out.h"

namespace preview::report {
namespace {

TEST_F(ReportTest, leaving_out_changes_no_picture_by_more_than_its_bound_and_draws_less) {
    const GpuLook look(device(), look_for(tools.look.table, table_lookup(*tools.look.table)).data);
    for (const std::string_view scene :
         support::all_or<std::string_view>({"sample", "night"}, {"night"})) {
        std::size_t left_out = 0;
        for (const SavingStage& stage : saving_stages(studied(showing(scene), size), &look)) {
            const SavingRow row = saving_of(renderer, stage, 1);
            EXPECT_LE(row.largest, row.bound) << scene << ": " << row.name;
            EXPECT_TRUE(row.holds());
            EXPECT_LE(row.usual.passes, row.forced.passes) << row.name;
            EXPECT_LE(row.usual.bytes, row.forced.bytes) << row.name;
            left_out += row.forced.passes - row.usual.passes;
        }
        EXPECT_GT(left_out, 10U) << scene;
    }
}

TEST_F(ReportTest, a_difference_between_forced_and_usual_is_seen) {
    // Of a frame that is a hundredth of a stop darker, as a wrong skip might make it.
    const Situation base = studied(showing("plain"), size);
    SavingStage stage{"a wrong skip", base};
    stage.situation.settings.force_all = false;
    const Situation dark = [&] {
        Situation out = stage.situation;
        out.settings.exposure -= 0.01F;
        return out;
    }();
    const reference::Image a = renderer.render_as_usual(stage.situation).finished,
                           b = renderer.render_as_usual(dark).finished;
    EXPECT_GT(largest_difference(a, b), 0);
    EXPECT_EQ(largest_difference(a, a), 0);
    EXPECT_EQ(saving_of(renderer, stage, 1).largest, 0);
}

} // namespace
} // namespace preview::report
