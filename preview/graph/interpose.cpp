#include "preview/graph/interpose.h"

#include <algorithm>
#include <stdexcept>

namespace preview {

namespace {

bool samples(const Use& use, std::uint32_t version) {
    return !use.writes && use.binding == BindingType::sampled_image && use.version == version;
}

} // namespace

bool is_sampled(const Graph& graph, ImageHandle image) {
    return std::any_of(graph.passes().begin(), graph.passes().end(), [&](const PassRecord& pass) {
        return std::any_of(pass.uses.begin(), pass.uses.end(),
                           [&](const Use& use) { return samples(use, image.version); });
    });
}

Graph interposed(const Graph& graph, ImageHandle image,
                 const std::function<ImageHandle(Graph&, ImageHandle)>& declare) {
    Graph out = graph;
    const bool was_retired = out.versions_.at(image.version).retired;
    out.versions_[image.version].retired = false;
    const ImageHandle made = declare(out, image);
    out.versions_[image.version].retired = was_retired;
    if (out.passes_.size() != graph.passes_.size() + 1) {
        throw std::logic_error("render graph: one pass at a time can be interposed");
    }
    for (auto pass = out.passes_.begin(); pass != out.passes_.end() - 1; ++pass) {
        for (Use& use : pass->uses) {
            if (samples(use, image.version)) {
                use.version = made.version;
            }
        }
    }
    const std::uint32_t producer = out.versions_[image.version].producer;
    const std::uint32_t place = producer == Version::none ? 0 : producer + 1;
    const auto last = static_cast<std::uint32_t>(out.passes_.size() - 1);
    std::rotate(out.passes_.begin() + place, out.passes_.end() - 1, out.passes_.end());
    for (Version& version : out.versions_) {
        if (version.producer != Version::none && version.producer >= place) {
            version.producer = version.producer == last ? place : version.producer + 1;
        }
    }
    return out;
}

} // namespace preview
