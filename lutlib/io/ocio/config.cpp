#include "lutlib/io/ocio/config.h"

#include <functional>

namespace lutlib::io {
namespace {

constexpr int builtin_configs_since = 0x02020000;

std::string listed(int count, const std::function<const char*(int)>& name) {
    constexpr int most = 60;
    std::string out;
    for (int i = 0; i < std::min(count, most); ++i) {
        out += (out.empty() ? "'" : ", '") + std::string(name(i)) + "'";
    }
    return count > most ? out + " and " + std::to_string(count - most) + " more" : out;
}

OCIO::ConstConfigRcPtr config_named(const std::string& name) {
    if (name.starts_with("ocio://") && OCIO::GetVersionHex() < builtin_configs_since) {
        throw Error("OpenColorIO " + std::string(OCIO::GetVersion()) + " has no '" + name +
                    "', built-in configs came with 2.2: name a .ocio file, or install "
                    "OpenColorIO 2.2 or later");
    }
    return OCIO::Config::CreateFromFile(name.c_str());
}

void require_space(const OCIO::ConstConfigRcPtr& config, const std::string& space,
                   const std::string& file) {
    if (!config->getColorSpace(space.c_str())) {
        throw Error("it has no colour space '" + space + "'; there are " +
                        listed(config->getNumColorSpaces(),
                               [&](int i) { return config->getColorSpaceNameByIndex(i); }),
                    {file, 0, {}});
    }
}

std::string view_of(const OCIO::ConstConfigRcPtr& config, const ConfigConversion& c) {
    const char* const display = c.display.c_str();
    const int views = config->getNumViews(display);
    if (views == 0) {
        throw Error(
            "it has no display '" + c.display + "'; there are " +
                listed(config->getNumDisplays(), [&](int i) { return config->getDisplay(i); }),
            {c.config, 0, {}});
    }
    if (c.view.empty()) {
        return config->getDefaultView(display);
    }
    for (int i = 0; i < views; ++i) {
        if (c.view == config->getView(display, i)) {
            return c.view;
        }
    }
    throw Error("its display '" + c.display + "' has no view '" + c.view + "'; there are " +
                    listed(views, [&](int i) { return config->getView(display, i); }),
                {c.config, 0, {}});
}

} // namespace

OCIO::ConstProcessorRcPtr processor_of_config(const ConfigConversion& c) {
    const OCIO::ConstConfigRcPtr config = config_named(c.config);
    require_space(config, c.from, c.config);
    if (c.display.empty()) {
        require_space(config, c.to, c.config);
        return config->getProcessor(c.from.c_str(), c.to.c_str());
    }
    const OCIO::DisplayViewTransformRcPtr transform = OCIO::DisplayViewTransform::Create();
    transform->setSrc(c.from.c_str());
    transform->setDisplay(c.display.c_str());
    transform->setView(view_of(config, c).c_str());
    return config->getProcessor(transform);
}

} // namespace lutlib::io
