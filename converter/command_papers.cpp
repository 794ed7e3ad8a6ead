#include "converter/command_papers.h"

#include "lutlib/color/encoding.h"
#include "lutlib/engine/engine.h"
#include "lutlib/interpolation/interpolation.h"
#include "lutlib/io/formats.h"
#include "lutlib/named.h"
#include "lutlib/version.h"
#include "terminal/papers.h"

namespace converter {
namespace {

template <class Rows>
std::vector<std::string> words(const Rows& rows) {
    std::vector<std::string> out;
    for (const std::string_view name : lutlib::name_list(rows)) {
        out.emplace_back(name);
    }
    return out;
}

std::vector<std::string> encoding_words() {
    std::vector<std::string> out;
    for (const lutlib::Encoding& encoding : lutlib::encodings()) {
        out.push_back(encoding.name());
    }
    return out;
}

} // namespace

void write_command_papers(const CLI::App& app, const std::string& folder) {
    terminal::Papers papers{.app = app,
                            .version = std::string(lutlib::version),
                            .values = {{"--engine", words(lutlib::engines())},
                                       {"--page", words(lutlib::engines())},
                                       {"--interpolation", words(lutlib::interpolations())},
                                       {"--layout", words(lutlib::layouts())},
                                       {"--format", words(lutlib::io::file_formats())}}};
    for (const char* const option :
         {"--look-input", "--look-output", "--picture-encoding", "--input-encoding",
          "--output-encoding", "--encoding", "--before-encoding", "--after-encoding"}) {
        papers.values.push_back({option, encoding_words()});
    }
    terminal::write_papers(papers, folder);
}

} // namespace converter
