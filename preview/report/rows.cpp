#include "lutlib/survey/pareto.h"
#include "preview/report/report.h"
#include "preview/report/test_pictures.h"
#include "preview/scene/camera.h"

#include <algorithm>
#include <array>
#include <map>

namespace preview::report {

namespace {

constexpr int pan_frames = 6, pan_step = 1; // texels
constexpr int turn_frames = 4;
constexpr std::size_t few_pixels = 100'000;

/// One input of a study at one size.
struct Input {
    std::string name;
    Situation situation;
    const TestPicture* picture = nullptr; ///< null: the report's own input
};

Situation with_picture(Situation situation, const TestPicture& picture, int pan) {
    Shown shown;
    shown.name = picture.name;
    shown.picture = picture.make(situation.settings.output, pan);
    situation.shown = std::make_shared<const Shown>(std::move(shown));
    return situation;
}

std::vector<Input> inputs_of(const Study& study, const Situation& situation, Size size) {
    std::vector<Input> out;
    if (study.none_because(situation).empty()) {
        out.push_back({situation.shown->name, studied(situation, size)});
    }
    if (study.takes_test_pictures) {
        for (const TestPicture& picture : test_pictures()) {
            out.push_back({std::string(picture.name),
                           with_picture(studied(situation, size), picture, 0), &picture});
        }
    }
    return out;
}

Truth truth_of(const StudyTools& tools, const Study& study, const TruthRequest& request) {
    if (study.truth != nullptr) {
        return study.truth(request);
    }
    Situation converged = request.base;
    study.converge(converged, tools);
    Frame frame = tools.renderer.render(converged, study.looked);
    return {std::move(frame.finished), std::move(frame.result)};
}

/// How restless the pass is while its input moves.
double unrest_of(const StudyTools& tools, const Study& study, const Input& input,
                 const Variant& variant) {
    std::vector<reference::Image> frames;
    for (int k = 0; k < pan_frames; ++k) {
        Situation moved = with_picture(input.situation, *input.picture, k * pan_step);
        variant.set(moved);
        frames.push_back(tools.renderer.render(moved, study.looked).result);
    }
    return unrest(frames, pan_step);
}

/// Truths by key, of each frame of a turn.
using Truths = std::map<std::string, std::vector<Truth>>;

/// Of a scene: how restless the pass's error is while the camera turns by half a texel a frame.
double unrest_of_turn(const StudyTools& tools, const Study& study, const Input& input,
                      const Variant& variant, std::vector<Truth>& truths) {
    std::vector<reference::Image> got, wanted;
    for (int k = 0; k < turn_frames; ++k) {
        Situation base = input.situation;
        Orbit& orbit = base.settings.orbit;
        const auto height = static_cast<float>(base.settings.output.height);
        orbit = turned_on_the_spot(orbit,
                                   0.5F * static_cast<float>(k) * orbit.field_of_view / height, 0);
        Situation varied = base;
        variant.set(varied);
        Frame frame = tools.renderer.render(varied, study.looked);
        if (truths.size() == static_cast<std::size_t>(k)) {
            truths.push_back(truth_of(tools, study, {tools, base, variant, varied, frame}));
        }
        got.push_back(std::move(frame.result));
        wanted.push_back(truths[static_cast<std::size_t>(k)].result);
    }
    return unrest_of_error(got, wanted);
}

void add_pass_error(const StudyTools& tools, const Study& study, const Input& input,
                    const Variant& variant, const Frame& frame, std::vector<Truth>& truths,
                    Row& row) {
    const bool is_impulse = input.picture != nullptr && input.picture->impulse != nullptr;
    row.pass = pass_error(frame.result, truths.front().result,
                          is_impulse ? input.picture->impulse(row.size) : std::nullopt);
    if (input.picture != nullptr && input.picture->name == "sun disc") {
        row.pass->unrest = unrest_of(tools, study, input, variant);
    } else if (input.picture == nullptr && input.situation.has_scene() &&
               !study.takes_test_pictures &&
               !(study.is_truth_slow && truths.front().result.pixels.size() > few_pixels)) {
        row.pass->unrest = unrest_of_turn(tools, study, input, variant, truths);
    }
}

void add_rows(const StudyTools& tools, const Study& study, const Input& input,
              std::span<const Variant> variants, std::vector<Row>& rows) {
    Truths all;
    for (const Variant& variant : variants) {
        Situation varied = input.situation;
        variant.set(varied);
        const Frame frame = tools.renderer.render(varied, study.looked);
        std::vector<Truth>& truths =
            all[study.truth_key != nullptr ? study.truth_key(varied, variant) : std::string()];
        if (truths.empty()) {
            truths.push_back(
                truth_of(tools, study, {tools, input.situation, variant, varied, frame}));
        }
        Row row{.study = &study,
                .input = input.name,
                .size = input.situation.settings.output,
                .variant = variant.name,
                .is_usual = variant.is_usual,
                .is_choice = variant.is_choice};
        row.picture = picture_error(frame.finished, truths.front().finished);
        if (!frame.result.pixels.empty()) {
            add_pass_error(tools, study, input, variant, frame, truths, row);
        }
        rows.push_back(std::move(row));
    }
}

/// What other rows of the same group beat in time and in the finished picture's error.
void find_front(std::span<Row> rows, std::size_t first) {
    std::vector<std::array<double, 2>> points;
    for (const Row& row : rows) {
        points.push_back({row.time.median, row.picture.relative_l2});
    }
    const std::vector<std::size_t> by = lutlib::dominators<2>(points);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].dominated_by = first + (by[i] == lutlib::not_dominated ? i : by[i]);
    }
}

} // namespace

Situation studied(Situation situation, Size size) {
    FrameSettings& s = situation.settings;
    s.output = size;
    s.format = Format::rgba32f;
    s.compare = &compare_a;
    s.picture_view = picture_view_named("picture");
    s.dithers = false;
    s.keeps_light = false;
    s.force_all = true;
    return situation;
}

std::vector<Row> rows_of(const StudyTools& tools, const Study& study, const Situation& situation,
                         const ReportSettings& settings, std::vector<LeftOutStudy>& left_out) {
    std::vector<Row> rows;
    const std::string_view reason = study.none_because(situation);
    if (!reason.empty()) {
        left_out.push_back({&study, std::string(reason)});
    }
    for (const Size size : settings.sizes) {
        std::vector<Input> inputs = inputs_of(study, situation, size);
        if (inputs.empty()) {
            continue;
        }
        const std::vector<Variant> variants = study.variants(studied(situation, size), tools);
        const std::size_t first = rows.size();
        std::vector<Situation> timed;
        for (Input& input : inputs) {
            if (study.prepare != nullptr) {
                study.prepare(input.situation);
            }
            add_rows(tools, study, input, variants, rows);
        }
        for (const Variant& variant : variants) {
            timed.push_back(inputs.front().situation);
            variant.set(timed.back());
        }
        const auto times = tools.renderer.time(timed, study.counts, settings.rounds);
        for (std::size_t i = first; i < rows.size(); ++i) {
            rows[i].time = times[(i - first) % variants.size()];
        }
        for (std::size_t at = first; at < rows.size(); at += variants.size()) {
            find_front(std::span(rows).subspan(at, variants.size()), at);
        }
        tools.renderer.forget();
    }
    return rows;
}

} // namespace preview::report
