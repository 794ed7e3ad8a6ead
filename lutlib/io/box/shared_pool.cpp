#include "lutlib/io/box/shared_pool.h"

#include "lutlib/io/box/shared_bytes.h"

#include <algorithm>
#include <mutex>
#include <vector>

namespace lutlib::io::box {
namespace {

constexpr std::size_t most_bytes_kept = std::size_t{256} << 20;

} // namespace

struct SharedPool::Kept {
    std::mutex mutex;
    std::vector<SharedBytes> unused; ///< the oldest first
    std::size_t size = 0;            ///< of all unused, in bytes

    SharedBytes take(std::size_t wanted) {
        const std::lock_guard lock(mutex);
        const auto fits = std::find_if(unused.rbegin(), unused.rend(), [wanted](const auto& one) {
            return one.bytes().size() == wanted;
        });
        if (fits == unused.rend()) {
            return {};
        }
        const SharedBytes out = *fits;
        unused.erase(std::next(fits).base());
        size -= wanted;
        return out;
    }

    void give_back(const SharedBytes& one) {
        const std::size_t added = one.bytes().size();
        if (added > most_bytes_kept) {
            return;
        }
        const std::lock_guard lock(mutex);
        while (size + added > most_bytes_kept) {
            size -= unused.front().bytes().size();
            unused.erase(unused.begin());
        }
        unused.push_back(one);
        size += added;
    }
};

SharedPool::SharedPool() : kept_(std::make_shared<Kept>()) {}

SampleBuffer SharedPool::take(std::size_t size) const {
    SharedBytes memory = kept_->take(size);
    if (memory.descriptor() < 0) {
        memory = SharedBytes(size);
    }
    const auto bytes = memory.bytes();
    const int descriptor = memory.descriptor();
    std::shared_ptr<void> owner(bytes.data(), [kept = kept_, memory](void*) noexcept {
        try {
            kept->give_back(memory);
        } catch (...) { // no memory to remember it: it ends here
        }
    });
    return {std::move(owner), bytes, descriptor};
}

} // namespace lutlib::io::box
