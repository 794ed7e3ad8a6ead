// Command lines as tests give them.
#pragma once

#include "preview/cli/option_rows.h"
#include "preview/frame/settings.h"

#include <CLI/CLI.hpp>

#include <string>

namespace preview {

inline Options parsed(const std::string& arguments) {
    CLI::App app;
    Options options;
    declare(app, options);
    app.parse(arguments);
    return options;
}

inline FrameSettings settings(const std::string& arguments, Size input = {}) {
    return settings_of(parsed(arguments), input);
}

} // namespace preview
