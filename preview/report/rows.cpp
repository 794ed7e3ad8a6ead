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
constexpr std::size_t turn_frames = 4;
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

/// How restless the pass is while its input moves; `first` is of the input as it stands.
double unrest_of(const StudyTools& tools, const Study& study, const Input& input,
                 const Variant& variant, const Frame& first) {
    std::vector<reference::Image> frames{first.result};
    for (int k = 1; k < pan_frames; ++k) {
        Situation moved = with_picture(input.situation, *input.picture, k * pan_step);
        variant.set(moved);
        frames.push_back(tools.renderer.render(moved, study.looked).result);
    }
    return unrest(frames, pan_step);
}

/// The input after `k` steps of a turn by half a texel each.
Situation turned(Situation situation, std::size_t k) {
    if (k > 0) {
        Orbit& orbit = situation.settings.orbit;
        const auto height = static_cast<float>(situation.settings.output.height);
        orbit = turned_on_the_spot(orbit,
                                   0.5F * static_cast<float>(k) * orbit.field_of_view / height, 0);
    }
    return situation;
}

/// Of a scene: whether it is asked how restless the pass's error is while the camera turns.
bool is_turned(const Study& study, const Input& input, const Frame& first) {
    const std::size_t pixels = first.result.pixels.size();
    return input.picture == nullptr && input.situation.has_scene() && !study.takes_test_pictures &&
           pixels > 0 && !(study.is_truth_slow && pixels > few_pixels);
}

/// What the variant makes of the input, and of each further step of a turn.
std::vector<Frame> frames_of(const StudyTools& tools, const Study& study, const Input& input,
                             const Variant& variant) {
    std::vector<Frame> out;
    std::size_t count = 1;
    for (std::size_t k = 0; k < count; ++k) {
        Situation varied = turned(input.situation, k);
        variant.set(varied);
        out.push_back(tools.renderer.render(varied, study.looked));
        count = is_turned(study, input, out.front()) ? turn_frames : 1;
    }
    return out;
}

/// Adds the truths that are not known yet, one after another: then their maps are drawn once.
void add_truths(const StudyTools& tools, const Study& study, const Input& input,
                const Variant& variant, const std::vector<Frame>& frames,
                std::vector<Truth>& truths) {
    for (std::size_t k = truths.size(); k < frames.size(); ++k) {
        const Situation base = turned(input.situation, k);
        Situation varied = base;
        variant.set(varied);
        truths.push_back(truth_of(tools, study, {tools, base, variant, varied, frames[k]}));
    }
}

PassError pass_error_of(const StudyTools& tools, const Study& study, const Input& input,
                        const Variant& variant, const std::vector<Frame>& frames,
                        const std::vector<Truth>& truths) {
    const bool is_impulse = input.picture != nullptr && input.picture->impulse != nullptr;
    PassError out = pass_error(frames.front().result, truths.front().result,
                               is_impulse ? input.picture->impulse(input.situation.settings.output)
                                          : std::nullopt);
    if (input.picture != nullptr && input.picture->name == "sun disc") {
        out.unrest = unrest_of(tools, study, input, variant, frames.front());
    } else if (frames.size() > 1) {
        std::vector<reference::Image> got, wanted;
        for (std::size_t k = 0; k < frames.size(); ++k) {
            got.push_back(frames[k].result);
            wanted.push_back(truths[k].result);
        }
        out.unrest = unrest_of_error(got, wanted);
    }
    return out;
}

void add_rows(const StudyTools& tools, const Study& study, const Input& input,
              std::span<const Variant> variants, std::vector<Row>& rows) {
    std::map<std::string, std::vector<Truth>> all; // by key, of each step of a turn
    for (const Variant& variant : variants) {
        const std::vector<Frame> frames = frames_of(tools, study, input, variant);
        Situation varied = input.situation;
        variant.set(varied);
        std::vector<Truth>& truths =
            all[study.truth_key != nullptr ? study.truth_key(varied, variant) : std::string()];
        add_truths(tools, study, input, variant, frames, truths);
        Row row{.study = &study,
                .input = input.name,
                .size = input.situation.settings.output,
                .variant = variant.name,
                .is_usual = variant.is_usual,
                .is_choice = variant.is_choice};
        row.picture = picture_error(frames.front().finished, truths.front().finished);
        if (!frames.front().result.pixels.empty()) {
            row.pass = pass_error_of(tools, study, input, variant, frames, truths);
        }
        rows.push_back(std::move(row));
    }
}

/// Whether its time has that of maps, which else rest as they do in the program.
bool counts_maps(const Study& study) {
    return study.counts("shadow of a light") || study.counts("surroundings levels");
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
            timed.back().settings.forced_keeps_maps = !counts_maps(study);
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
