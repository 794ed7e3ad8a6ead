// lutconv engines: the engines whose LUT pictures are known, with what each wants.
#include "converter/command.h"
#include "converter/engine_page.h"
#include "converter/listings.h"
#include "converter/report.h"
#include "lutlib/engine/engine_names.h"
#include "terminal/table.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace converter {
namespace {

using lutlib::Engine;

void add(terminal::Table& table, const Engine& e) {
    const lutlib::PictureSize extent = *lutlib::layout_named(e.layout)->picture(e.default_size);
    table.row({std::string(e.name), std::string(e.label)});
    for (const std::string& line :
         {fmt::format("{} nodes ({}x{}, layout {}), {} bits{}; takes {}, {} bits", e.default_size,
                      extent.width, extent.height, e.layout, e.default_bits,
                      e.srgb_tag == lutlib::SrgbTag::present ? ", tagged sRGB" : "", sizes_of(e),
                      list_of(e.bits)),
          fmt::format("feeds: {}", e.input), fmt::format("import: {}", e.import),
          fmt::format("lookup: {}", e.lookup_help)}) {
        table.row({"", line});
    }
}

void run_engines(bool json) {
    terminal::Table table;
    for (const Engine& engine : lutlib::engines()) {
        add(table, engine);
    }
    json ? print(engines_json(), "") : terminal::print(table);
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
            run_engines(*json);
        } else {
            print(engine_page(lutlib::require_engine(*page)), "");
        }
        return static_cast<int>(ok);
    };
}

} // namespace converter
