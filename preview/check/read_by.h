// What a pass has read in a frame, by its bindings.
#pragma once

#include "preview/check/pass_twins.h"

#include <cstring>
#include <span>
#include <vector>

namespace preview {

/// Colours of an image with four channels.
reference::Image image_of(const Observed& observed);
reference::Image image_of(const ShownPicture& picture);

class ReadBy {
  public:
    explicit ReadBy(const TwinInput& in) : in_(in) {}

    /// Null for what the frame withheld, and for what is imported.
    const Observed* image(std::size_t binding) const {
        return with_version(in_.observed, use(binding).version);
    }
    reference::Image colors(std::size_t binding) const { return image_of(*image(binding)); }
    /// Of an image or a buffer of floats.
    const std::vector<float>& values(std::size_t binding) const { return image(binding)->values; }

    /// Of a buffer that came with the graph; empty where it was withheld.
    template <class Block>
    std::vector<Block> blocks(std::size_t binding) const {
        const std::uint32_t version = use(binding).version;
        if (version == Version::none) {
            return {};
        }
        const std::vector<std::byte>& bytes = in_.graph.resource_of(version).data;
        std::vector<Block> out(bytes.size() / sizeof(Block));
        std::memcpy(out.data(), bytes.data(), out.size() * sizeof(Block));
        return out;
    }
    template <class Block>
    Block block(std::size_t binding) const {
        return blocks<Block>(binding).at(0);
    }

  private:
    const Use& use(std::size_t binding) const { return in_.pass.uses.at(binding); }

    const TwinInput& in_;
};

} // namespace preview
