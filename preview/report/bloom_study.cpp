// Bloom: every method, format of its pyramid and width, against exact convolution.
#include "preview/passes/bloom_composite.h"
#include "preview/passes/resolve.h"
#include "preview/report/bloom_kernel.h"
#include "preview/report/study.h"

#include <fmt/format.h>

#include <cctype>

namespace preview::report {

namespace {

std::string_view none_because(const Situation& s) {
    return !s.has_light() ? "the picture is display-encoded already"
           : s.settings.bloom == nullptr || s.settings.without.has(Effect::bloom)
               ? "it is switched off"
               : "";
}

/// What stands between the bloom and the finished picture is the tone map alone.
void prepare(Situation& s) {
    s.settings.effects.clear();
    s.settings.without.set(Effect::looks, true);
}

constexpr Format work_formats[] = {Format::rgba16f, Format::r11g11b10f, Format::rgba32f};

std::vector<Variant> variants(const Situation& situation, const StudyTools& tools) {
    const Bloom* const usual = situation.settings.bloom;
    std::vector<Variant> out{
        {"none", [](Situation& s) { s.settings.bloom = bloom_named("none"); }}};
    for (const Bloom& row : blooms()) {
        if (row.plan({64, 64}, {}).empty()) {
            continue;
        }
        for (const Format format : work_formats) {
            if (!tools.renderer.can_store(format)) {
                continue;
            }
            out.push_back({fmt::format("{}, {}", row.name, info(format).name),
                           [&row, format](Situation& s) {
                               s.settings.bloom = &row;
                               s.settings.bloom_format = format;
                           },
                           &row == usual && format == Format::rgba16f, &row == usual});
        }
        for (const float width : {0.5F, 2.0F}) {
            out.push_back({fmt::format("{}, {} times as wide", row.name, width),
                           [&row, width](Situation& s) {
                               s.settings.bloom = &row;
                               s.settings.bloom_settings.radius *= width;
                           },
                           false, false});
        }
    }
    return out;
}

/// The bloom alone: added to a picture without any light.
ImageHandle glow_alone(Graph& graph, const FrameHandles& handles) {
    if (!handles.bloom) {
        return {};
    }
    Finishing dark;
    dark.picture = add_resolve(graph, handles.hdr, size_of(graph, handles.hdr), 0).hdr;
    dark.bloom = handles.bloomed;
    return add_bloom_composite(graph, dark);
}

/// Without any bloom the usual one is missed.
const Situation& aimed_at(const Situation& base, const Variant& variant, const Situation& varied) {
    return variant.is_choice ? base : varied;
}

std::string truth_key(const Situation& varied, const Variant& variant) {
    const FrameSettings& s = varied.settings;
    return variant.is_choice ? "usual"
                             : fmt::format("{} {}", s.bloom->name, s.bloom_settings.radius);
}

Truth truth(const TruthRequest& request) {
    const Situation& aim = aimed_at(request.base, request.variant, request.varied);
    const FrameSettings& s = aim.settings;
    Truth out;
    out.result = exact_glow(*s.bloom, s.bloom_settings, request.frame.light);
    out.finished = with_glow(*s.bloom, s.bloom_settings, request.frame.light, out.result);
    const Tonemap& tonemap = s.without.has(Effect::tonemap) ? *tonemap_named("none") : *s.tonemap;
    for (lutlib::RgbD& pixel : out.finished.pixels) {
        pixel = tonemap.apply(pixel);
    }
    return out;
}

/// Its last filter is the finishing pass's.
bool counts(std::string_view pass) {
    const std::string_view begins = "bloom ";
    return pass == "finish" ||
           (pass.starts_with(begins) &&
            std::isdigit(static_cast<unsigned char>(pass.substr(begins.size()).front())) != 0);
}

} // namespace

const Study bloom_study{
    .name = "bloom",
    .title = "Bloom",
    .help = "Every method, with its levels stored in three formats, and narrower and wider. The "
            "pass is the light that it adds; its time has the finishing pass, which does its last "
            "filter.",
    .reference = "Zero-padded float64 FFT convolution with the method's own kernel, prefilter and "
                 "border; then the tone map in double. 'none' is held against the usual bloom.",
    .none_because = none_because,
    .variants = variants,
    .truth = truth,
    .counts = counts,
    .looked = {.result = glow_alone, .light = true},
    .prepare = prepare,
    .truth_key = truth_key,
    .takes_test_pictures = true,
    .converge = [](Situation& s, const StudyTools&) { s.settings.bloom_format = Format::rgba32f; }};

} // namespace preview::report
