#include "lutlib/io/ocio/config.h"

#include "lutlib/named.h"

#include <functional>

namespace lutlib::io {
namespace {

constexpr int builtin_configs_since = 0x02020000;

[[noreturn]] void refuse(const std::string& kind, const std::string& name, const std::string& file,
                         int count, const std::function<const char*(int)>& name_at) {
    std::vector<std::string_view> names;
    for (int i = 0; i < count; ++i) {
        names.emplace_back(name_at(i));
    }
    throw Error(no_such_name(kind, name, names), {file, 0, {}});
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
        refuse("colour space", space, file, config->getNumColorSpaces(),
               [&](int i) { return config->getColorSpaceNameByIndex(i); });
    }
}

std::string view_of(const OCIO::ConstConfigRcPtr& config, const ConfigConversion& c) {
    const char* const display = c.display.c_str();
    const int views = config->getNumViews(display);
    if (views == 0) {
        refuse("display", c.display, c.config, config->getNumDisplays(),
               [&](int i) { return config->getDisplay(i); });
    }
    if (c.view.empty()) {
        return config->getDefaultView(display);
    }
    for (int i = 0; i < views; ++i) {
        if (c.view == config->getView(display, i)) {
            return c.view;
        }
    }
    refuse("view of " + c.display, c.view, c.config, views,
           [&](int i) { return config->getView(display, i); });
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
