#include "lutlib/io/frames.h"

#include "lutlib/error.h"

#include <algorithm>
#include <charconv>
#include <set>

namespace lutlib::io {
namespace {

constexpr std::size_t most_digits = 9; // of last_frame
constexpr std::size_t most_frames = 1'000'000;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::optional<int> number(std::string_view text) {
    int value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    const bool is_number = !text.empty() && std::all_of(text.begin(), text.end(), is_digit) &&
                           read.ec == std::errc{} && read.ptr == end && value <= last_frame;
    return is_number ? std::optional(value) : std::nullopt;
}

struct Range {
    int first = 0, last = 0, step = 1;
};

// "1001-1100x2"; the parts from the second on may be missing.
std::optional<Range> range_of(std::string_view text) {
    const std::size_t dash = text.find('-');
    const std::size_t times = text.find('x', dash == std::string_view::npos ? 0 : dash);
    const bool has_last = dash != std::string_view::npos, has_step = times != text.npos;
    const auto first = number(text.substr(0, std::min(dash, times)));
    const auto last = has_last ? number(text.substr(dash + 1, times - dash - 1)) : first;
    const auto step = has_step ? number(text.substr(times + 1)) : std::optional(1);
    if (!first || !last || !step || *last < *first || *step < 1 || (has_step && !has_last)) {
        return std::nullopt;
    }
    return Range{*first, *last, *step};
}

struct Place {
    std::size_t at = 0, length = 0, digits = 1;
};

// A run of # that ends where `text` does.
std::optional<Place> hashes_before(std::string_view text, std::size_t shortest_run) {
    const std::size_t before = text.find_last_not_of('#');
    const std::size_t first = before == text.npos ? 0 : before + 1;
    const std::size_t run = text.size() - first;
    return run >= shortest_run && run <= most_digits ? std::optional(Place{first, run, run})
                                                     : std::nullopt;
}

// "%d" or "%04d" at the beginning.
std::optional<Place> conversion_at(std::string_view text) {
    if (text.substr(0, 2) == "%d") {
        return Place{0, 2, 1};
    }
    const bool is_padded = text.size() >= 4 && text[0] == '%' && text[1] == '0' &&
                           is_digit(text[2]) && text[2] != '0' && text[3] == 'd';
    return is_padded ? std::optional(Place{0, 4, static_cast<std::size_t>(text[2] - '0')})
                     : std::nullopt;
}

} // namespace

std::vector<int> parse_frames(std::string_view text) {
    const auto refuse = [&] {
        throw UsageError("frames are named as 7, 1001-1100, 1001-1100x2 (every second) or several "
                         "of these with commas between, a million at most, not as '" +
                         std::string(text) + "'");
    };
    std::set<int> out;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const auto range = range_of(text.substr(at, comma - at));
        if (!range ||
            static_cast<std::size_t>((range->last - range->first) / range->step) + out.size() >=
                most_frames) {
            refuse();
        }
        for (long frame = range->first; frame <= range->last; frame += range->step) {
            out.insert(static_cast<int>(frame));
        }
        at = comma + 1;
    }
    return {out.begin(), out.end()};
}

std::optional<FramePattern> FramePattern::of(std::string_view path, std::size_t shortest_run) {
    const std::size_t slash = path.rfind('/');
    const std::size_t name = slash == path.npos ? 0 : slash + 1;
    for (std::size_t end = path.size(); end > name; --end) {
        std::optional<Place> place;
        if (path[end - 1] == '#' && (end == path.size() || path[end] != '#')) {
            place = hashes_before(path.substr(name, end - name), shortest_run);
            if (place) {
                place->at += name;
            }
        } else if (path[end - 1] == '%') {
            place = conversion_at(path.substr(end - 1));
            if (place) {
                place->at = end - 1;
            }
        }
        if (place) {
            FramePattern out;
            out.before_ = path.substr(0, place->at);
            out.after_ = path.substr(place->at + place->length);
            out.digits_ = place->digits;
            return out;
        }
    }
    return std::nullopt;
}

std::string FramePattern::path_of(int frame) const {
    const std::string digits = std::to_string(frame);
    return before_ + std::string(digits_ - std::min(digits_, digits.size()), '0') + digits + after_;
}

std::optional<std::string> FramePattern::frame_in(std::string_view path) const {
    if (path.size() < before_.size() + digits_ + after_.size() || !path.starts_with(before_) ||
        !path.ends_with(after_)) {
        return std::nullopt;
    }
    const std::string_view digits =
        path.substr(before_.size(), path.size() - before_.size() - after_.size());
    const bool is_padded = digits.size() == digits_ || digits.front() != '0';
    return number(digits) && is_padded ? std::optional(std::string(digits)) : std::nullopt;
}

} // namespace lutlib::io
