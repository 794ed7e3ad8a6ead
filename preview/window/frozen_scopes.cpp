#include "preview/window/frozen_scopes.h"

namespace preview {

bool FrozenScopes::take(Executor& executor, const FrameHandles& handles, FrozenCounts& copies) {
    executor.wait(); // for frames that read what was frozen before
    copies = {};
    is_frozen_ = false;
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        const ScopeCounts& from = handles.scope_counts[i];
        counted_[i] = {};
        if (from.counts) {
            counted_[i].counts = executor.read_buffer(from.counts);
            counted_[i].shape = {nullptr, from.columns, from.width, from.height};
            is_frozen_ = true;
        }
    }
    return is_frozen_;
}

std::array<KeptScope, scopes.size()> FrozenScopes::on(const gpu::Device& device,
                                                      FrozenCounts& copies) const {
    std::array<KeptScope, scopes.size()> out{};
    for (std::size_t i = 0; is_frozen_ && i < out.size(); ++i) {
        if (counted_[i].counts.empty()) {
            continue;
        }
        if (!copies[i]) {
            copies[i].emplace(gpu::make_buffer(device, counted_[i].counts));
        }
        out[i] = counted_[i].shape;
        out[i].counts = &*copies[i];
    }
    return out;
}

} // namespace preview
