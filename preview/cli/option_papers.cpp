#include "preview/cli/option_papers.h"

#include "lutlib/io/image.h"
#include "lutlib/named.h"
#include "lutlib/version.h"
#include "preview/cli/option_rows.h"
#include "preview/effects/effect.h"
#include "preview/look/gpu_lookups.h"

namespace preview {

namespace {

using Words = std::vector<std::string>;

template <class Rows>
Words words(const Rows& rows) {
    Words out;
    for (const std::string_view name : lutlib::name_list(rows)) {
        out.emplace_back(name);
    }
    return out;
}

Words encoding_words() {
    Words out;
    for (const lutlib::Encoding& encoding : lutlib::encodings()) {
        out.push_back(encoding.name());
    }
    return out;
}

Words parts() {
    Words out = words(effects);
    const Words more = words(post_effects());
    out.insert(out.end(), more.begin(), more.end());
    return out;
}

template <class S>
void add(terminal::Papers& papers, std::span<const ChoiceRow<S>> rows) {
    for (const ChoiceRow<S>& row : rows) {
        papers.values.push_back({"--" + std::string(row.flag), words(row.options())});
    }
}

} // namespace

terminal::Papers papers(const CLI::App& app) {
    terminal::Papers out{.app = app,
                         .version = std::string(lutlib::version),
                         .values = {{"--surroundings", words(surroundings_kinds())},
                                    {"--effect", words(post_effects())},
                                    {"--without", parts()},
                                    {"--depth", words(lutlib::io::depths())}},
                         .words = words(scenes())};
    for (const Study& study : studies()) {
        out.words.emplace_back(study.name);
    }
    add(out, picture_choices());
    add(out, option_choices());
    for (const char* const option : {"--engine", "--engine-a", "--engine-b"}) {
        out.values.push_back({option, words(gpu_lookups())});
    }
    for (const char* const option :
         {"--look-input", "--look-input-a", "--look-input-b", "--look-output", "--look-output-a",
          "--look-output-b", "--picture-encoding", "--scope-encoding", "--still-encoding"}) {
        out.values.push_back({option, encoding_words()});
    }
    for (const OptionRow& row : option_rows()) {
        if (row.one_of[0] != nullptr) {
            out.values.push_back({row.flag, {row.one_of[0], row.one_of[1]}});
        }
    }
    return out;
}

} // namespace preview
