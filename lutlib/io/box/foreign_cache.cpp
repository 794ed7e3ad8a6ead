#include "lutlib/io/box/foreign_cache.h"

#include <algorithm>
#include <sys/stat.h>

namespace lutlib::io::box {
namespace {

constexpr std::size_t most_bytes_known = std::size_t{256} << 20;

bool is_one_file(int a, int b) {
    struct stat of_a {
    }, of_b{};
    return ::fstat(a, &of_a) == 0 && ::fstat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino && of_a.st_size == of_b.st_size;
}

} // namespace

ForeignBytes ForeignCache::adopt(int descriptor) {
    const auto known = std::find_if(known_.begin(), known_.end(), [descriptor](const auto& one) {
        return is_one_file(one.descriptor(), descriptor);
    });
    if (known != known_.end()) {
        const Descriptor again(descriptor);
        std::rotate(known, known + 1, known_.end());
        return known_.back();
    }
    ForeignBytes out(descriptor);
    const std::size_t added = out.bytes().size();
    if (added > most_bytes_known) {
        return out;
    }
    while (size_ + added > most_bytes_known) {
        size_ -= known_.front().bytes().size();
        known_.erase(known_.begin());
    }
    known_.push_back(out);
    size_ += added;
    return out;
}

} // namespace lutlib::io::box
