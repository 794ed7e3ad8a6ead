#include "converter/many_looks.h"

#include "converter/many.h"
#include "converter/replaceable.h"
#include "converter/report.h"
#include "converter/usage.h"
#include "lutlib/error.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/reason.h"

#include <algorithm>
#include <array>
#include <exception>

namespace converter {
namespace {

namespace io = lutlib::io;

bool is_look(const std::string& extension) {
    const auto formats = io::file_formats();
    return extension == "json" ||
           std::any_of(formats.begin(), formats.end(), [&](const lutlib::FileFormat* format) {
               return format->read && format->extensions.contain(extension);
           });
}

int complain(const std::exception& error, int code) {
    print("lutconv: " + one_line(io::reason_of(error)) + '\n', std::string(io::standard_stream));
    return code;
}

int guarded(const LookRoute& route, const std::function<int(const LookRoute&)>& run) {
    try {
        return run(route);
    } catch (const lutlib::UsageError& error) {
        return complain(error, bad_usage);
    } catch (const std::exception& error) {
        return complain(error, bad_input);
    }
}

} // namespace

bool is_look_file(const std::string& path) {
    return is_look(io::extension_of(path));
}

std::vector<LookRoute> routes_of_looks(std::span<const std::string> words,
                                       const std::string& output,
                                       std::span<const lutlib::Engine* const> engines) {
    require_one_standard_input(words);
    const io::Inputs inputs = io::find_inputs(words, "", is_look);
    const io::OutputTemplate made =
        output.empty() ? io::OutputTemplate({}) : io::OutputTemplate(output, {"engine"}, "");
    const std::array<const lutlib::Engine*, 1> none{nullptr};
    std::vector<LookRoute> out;
    std::vector<io::Route> routes;
    for (const io::InputFile& file : inputs.files) {
        for (const lutlib::Engine* const engine : engines.empty() ? std::span(none) : engines) {
            const io::NameField field{"engine", engine ? engine->name : ""};
            const std::span<const io::NameField> fields(&field, engine ? 1 : 0);
            out.push_back({{file, output.empty() ? "" : made.path_for(file, fields)}, engine});
            routes.push_back(out.back().route);
        }
    }
    if (!output.empty()) {
        require_distinct(routes);
    }
    tell_remarks(inputs.remarks);
    if (made.varies()) {
        make_folders(routes);
    }
    return out;
}

int run_over(std::span<const LookRoute> routes, const std::function<int(const LookRoute&)>& run) {
    const auto checked = [&run](const LookRoute& route) {
        require_replaceable(std::span(&route.route, 1));
        return run(route);
    };
    if (routes.size() == 1) {
        return checked(routes.front());
    }
    int worst = ok;
    for (const LookRoute& route : routes) {
        worst = std::max(worst, guarded(route, checked));
    }
    return worst;
}

} // namespace converter
