#include "preview/editor/search.h"

#include "lutlib/text.h"

#include <algorithm>

namespace preview::editor {

bool is_found(std::string_view text, std::string_view typed) {
    const lutlib::Words words = lutlib::words_of(typed);
    const auto shown = std::min(words.count, words.items.size());
    const auto same = [](char a, char b) { return lutlib::upper(a) == lutlib::upper(b); };
    return std::all_of(words.items.begin(),
                       words.items.begin() + static_cast<std::ptrdiff_t>(shown),
                       [&](std::string_view word) {
                           return std::search(text.begin(), text.end(), word.begin(), word.end(),
                                              same) != text.end();
                       });
}

} // namespace preview::editor
