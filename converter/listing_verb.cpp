#include "converter/listing_verb.h"

#include "converter/report.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace converter {

Run declare_listing(Verb& verb, const std::string& json_help, terminal::Table (*as_table)(),
                    nlohmann::ordered_json (*as_json)()) {
    const auto json = std::make_shared<bool>(false);
    verb.add_flag("--json", *json, "print the rows as JSON, with " + json_help);
    return [json, as_table, as_json] {
        *json ? print(as_json(), "") : terminal::print(as_table());
        return static_cast<int>(ok);
    };
}

} // namespace converter
