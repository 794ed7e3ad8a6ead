#include "converter/listing_verb.h"

#include "converter/report.h"

#include <nlohmann/json.hpp>

#include <memory>

namespace converter {

Run declare_listing(Verb& verb, const std::string& json_help, std::string (*as_text)(),
                    nlohmann::ordered_json (*as_json)()) {
    const auto json = std::make_shared<bool>(false);
    verb.add_flag("--json", *json, "print the rows as JSON, with " + json_help);
    return [json, as_text, as_json] {
        *json ? print(as_json(), "") : print(as_text(), "");
        return static_cast<int>(ok);
    };
}

} // namespace converter
