#include "preview/finish/setting_rows.h"

#include <fmt/format.h>

namespace preview {

std::string number_text(float value, std::string_view own_name) {
    return own_name.empty() ? fmt::format("{}", value) : fmt::format("{} ({})", own_name, value);
}

} // namespace preview
