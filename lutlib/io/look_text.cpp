#include "lutlib/io/look_text.h"

#include <fmt/core.h>

namespace lutlib::io {
namespace {

// Somebody else's text within a line of ours.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        out += code >= 0x20 && code != 0x7F ? std::string(1, c) : fmt::format("\\x{:02x}", code);
    }
    return out;
}

} // namespace

std::vector<std::string> told_of(const Look& look) {
    std::vector<std::string> out;
    for (const LookFile& file : look.files()) {
        const bool is_base = &file != &look.files().front();
        const auto tell = [&](const std::string& sentence) {
            out.push_back(escaped(is_base ? file.name + ": " + sentence : sentence));
        };
        for (const Loss& loss : file.losses) {
            tell(fmt::format("lost: {}: {:.4g}{}{}", loss.what, loss.figure,
                             loss.is_difference() ? "" : " ", loss.unit));
        }
        for (const std::string& remark : file.remarks) {
            tell(remark);
        }
        for (const std::string& keyword : file.keywords) {
            tell("kept but not acted on: " + keyword);
        }
    }
    return out;
}

} // namespace lutlib::io
