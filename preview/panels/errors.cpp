#include "preview/panels/errors.h"

#include <algorithm>
#include <utility>

namespace preview::panels {

void Errors::add(std::string text) {
    std::size_t count = 1;
    const auto same =
        std::find_if(rows_.begin(), rows_.end(), [&](const Row& row) { return row.text == text; });
    if (same != rows_.end()) {
        count += same->count;
        rows_.erase(same);
    }
    rows_.insert(rows_.begin(), Row{std::move(text), count});
    if (rows_.size() > most_kept) {
        rows_.pop_back();
        ++dropped_;
    }
}

void Errors::close(std::size_t at) {
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(at));
    dropped_ = rows_.empty() ? 0 : dropped_;
}

void Errors::clear() {
    rows_.clear();
    dropped_ = 0;
}

std::string Errors::more() const {
    if (rows_.size() <= most_shown) {
        return {};
    }
    const std::size_t hidden = rows_.size() - most_shown + dropped_;
    return std::to_string(hidden) + (hidden == 1 ? " older one is" : " older ones are") +
           " not shown" + (dropped_ > 0 ? "; the oldest are given up" : "");
}

} // namespace preview::panels
