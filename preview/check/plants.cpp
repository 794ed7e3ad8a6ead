// Values planted at the inputs of passes up to the HDR resolve.
#include "preview/check/check.h"
#include "preview/graph/interpose.h"
#include "preview/passes/plant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace preview {

namespace {

struct PlantRow {
    std::string_view name;
    float value;
};
constexpr PlantRow plant_rows[] = {
    {"NaN", std::numeric_limits<float>::quiet_NaN()},
    {"+infinity", std::numeric_limits<float>::infinity()},
    {"-infinity", -std::numeric_limits<float>::infinity()},
    {"65504", 65504},
    {"denormal", 0x1p-24F},
    {"-1", -1},
};

/// Whether an image covers the picture, in its size or halved some times.
bool lies_on(const ImageDesc& image, const ImageDesc& picture) {
    const auto halved = [](std::uint32_t side, unsigned times) {
        return (side + (1U << times) - 1) >> times;
    };
    for (unsigned times = 0; times < 4; ++times) {
        if (image.width == halved(picture.width, times) &&
            image.height == halved(picture.height, times)) {
            return true;
        }
    }
    return false;
}

/// From the texel of `hdr` over the planted one to the farthest that differs.
int reach_in(const Observed& hdr, const Observed& plain, const ImageDesc& planted,
             const Planted& place) {
    const std::uint32_t width = hdr.desc.width;
    const double scale_x = static_cast<double>(width) / planted.width,
                 scale_y = static_cast<double>(hdr.desc.height) / planted.height;
    int reach = 0;
    for (std::size_t i = 0; i < hdr.texels(); ++i) {
        const auto at = static_cast<std::ptrdiff_t>(4 * i);
        if (std::equal(hdr.values.begin() + at, hdr.values.begin() + at + 4,
                       plain.values.begin() + at)) {
            continue;
        }
        const double dx = static_cast<double>(i % width) + 0.5 - (place.x + 0.5) * scale_x,
                     dy = static_cast<double>(i / width) + 0.5 - (place.y + 0.5) * scale_y;
        reach = std::max(reach, static_cast<int>(std::ceil(std::max(std::abs(dx), std::abs(dy)))));
    }
    return reach;
}

/// Images that a living pass up to the resolve samples, that hold floats and can be copied.
std::vector<std::uint32_t> plantable(const Graph& graph, std::uint32_t hdr_version) {
    const Plan plan = make_plan(graph);
    const std::uint32_t resolve = graph.versions()[hdr_version].producer;
    std::vector<std::uint32_t> out;
    for (std::uint32_t order = 0; order <= resolve && resolve != Version::none; ++order) {
        for (const Use& use : graph.passes()[order].uses) {
            const bool is_sampled = !use.writes && use.binding == BindingType::sampled_image &&
                                    use.version != Version::none;
            if (plan.pass_lives[order] && is_sampled &&
                can_be_planted(graph.resource_of(use.version).image) &&
                std::find(out.begin(), out.end(), use.version) == out.end()) {
                out.push_back(use.version);
            }
        }
    }
    return out;
}

} // namespace

PlantResult Checker::plant(const Seen& plain, std::uint32_t version, std::string_view name,
                           float value) {
    const Resource& resource = plain.graph.resource_of(version);
    const std::uint32_t producer = plain.graph.versions()[version].producer;
    PlantResult out;
    out.pass = producer == Version::none ? "what is shown" : plain.graph.passes()[producer].name;
    out.name = resource.name;
    out.value = name;
    const Planted planted{resource.image.width / 2, resource.image.height / 2, value};
    const Graph graph =
        interposed(plain.graph, ImageHandle{version},
                   [&](Graph& copy, ImageHandle image) { return add_plant(copy, image, planted); });
    const std::vector<Observed> observed = observe(executor_, graph);
    out.frame = finding_of(graph, observed);
    const Observed* const hdr = left_by(observed, "hdr resolve");
    const Observed* const plain_hdr = left_by(plain.observed, "hdr resolve");
    if (producer == Version::none ? resource.name == "picture"
                                  : lies_on(resource.image, hdr->desc)) {
        out.reach = reach_in(*hdr, *plain_hdr, resource.image, planted);
    }
    if (out.frame.after > 0) {
        out.faults.push_back(
            fmt::format("{} texels are not finite behind the HDR resolve", out.frame.after));
    }
    // What is finite may stand for anything: a depth of 65504 is a wrong scene, and no fault.
    if (!std::isfinite(value) && out.reach.value_or(0) > planted_reach) {
        out.faults.push_back(
            fmt::format("it reaches {} texels far, and may {}", *out.reach, planted_reach));
    }
    return out;
}

std::vector<PlantResult> Checker::check_plants() {
    const Seen plain = see(with_every_pass(situation_));
    const Observed* const hdr = left_by(plain.observed, "hdr resolve");
    std::vector<PlantResult> out;
    if (hdr == nullptr) {
        return out;
    }
    for (const std::uint32_t version : plantable(plain.graph, hdr->version)) {
        for (const PlantRow& row : plant_rows) {
            out.push_back(plant(plain, version, row.name, row.value));
        }
    }
    return out;
}

} // namespace preview
