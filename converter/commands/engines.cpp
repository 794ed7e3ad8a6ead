// lutconv engines: the engines whose LUT pictures are known, with what each wants.
#include "converter/command.h"
#include "converter/engine_page.h"
#include "converter/listings.h"
#include "converter/report.h"
#include "lutlib/engine/engine_names.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace converter {
namespace {

using lutlib::Engine;

std::string as_text(const Engine& e) {
    const lutlib::PictureSize extent = *lutlib::layout_named(e.layout)->picture(e.default_size);
    return fmt::format("{:<12}{}\n"
                       "            {} nodes ({}x{}, layout {}), {} bits{}; takes {}, {} bits\n"
                       "            feeds: {}\n            import: {}\n            lookup: {}\n",
                       e.name, e.label, e.default_size, extent.width, extent.height, e.layout,
                       e.default_bits,
                       e.srgb_tag == lutlib::SrgbTag::present ? ", tagged sRGB" : "", sizes_of(e),
                       list_of(e.bits), e.input, e.import, e.lookup_help);
}

int run(bool json) {
    std::string text;
    for (const Engine& engine : lutlib::engines()) {
        text += as_text(engine);
    }
    json ? print(engines_json(), "") : print(text, "");
    return ok;
}

} // namespace

Run declare_engines(Verb& verb) {
    const auto json = std::make_shared<bool>(false);
    const auto page = std::make_shared<std::string>();
    verb.add_flag("--json", *json, "print as JSON, with where each row is documented");
    verb.add_option("--page", *page,
                    "print the page of one engine: its contract, how to check it, its shader")
        .excludes({"--json"});
    return [json, page] {
        if (page->empty()) {
            return run(*json);
        }
        print(engine_page(lutlib::require_engine(*page)), "");
        return static_cast<int>(ok);
    };
}

} // namespace converter
