#include "converter/inline_shader.h"

#include "converter/command.h"
#include "converter/look_files.h"
#include "converter/report.h"
#include "lutlib/engine/shader_parts.h"
#include "lutlib/error.h"
#include "lutlib/fit/inline_fit.h"
#include "lutlib/io/bake_report.h"
#include "lutlib/io/file.h"
#include "lutlib/named.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>

namespace converter {
namespace {

namespace io = lutlib::io;

// Two digits behind the point, no less than it is.
double rounded_up(double figure) {
    return std::ceil(100 * figure) / 100;
}

// A line of a comment that ends in a backslash would go on in the next.
std::string comment_name(const std::string& path) {
    std::string out = one_line(std::filesystem::path(io::input_name(path)).filename().string());
    std::replace(out.begin(), out.end(), '\\', '/');
    return out;
}

std::string encoding_words(const std::optional<lutlib::Encoding>& encoding) {
    return encoding ? encoding->name() : "an encoding that the look does not name";
}

/// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
    const auto is_plain = [](unsigned char c) {
        return std::isalnum(c) != 0 || c >= 0x80 ||
               std::string_view("._-+/,:@%").find(static_cast<char>(c)) != std::string_view::npos;
    };
    if (std::all_of(text.begin(), text.end(), is_plain)) {
        return text;
    }
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return out + "'";
}

std::string heading_of(const InlineRequest& request, const io::Look& look,
                       const lutlib::ShaderLanguage& language, const lutlib::InlineFit& fit) {
    const std::string name = comment_name(request.look);
    std::string out =
        lutlib::shader_comment("The colour look " + name + " in " + std::string(language.label) +
                               ", without a picture. "
                               "Made by:");
    out +=
        lutlib::shader_command(fmt::format("lutconv shader --inline {} --language {} "
                                           "--max-delta-e {:g}",
                                           shell_word(name), language.name, request.max_delta_e));
    out += lutlib::shader_comment(
        fmt::format("lut_lookup takes codes of {}, of which each channel is held to {}, and gives "
                    "codes of {}. It holds the look as {}; the largest dE2000 {} is {:.3g}.",
                    encoding_words(look.encodings().input), io::domain_text(look.domain()),
                    encoding_words(look.encodings().output), lutlib::text_of(fit.look),
                    fit.error.delta_e_2000.largest_seen ? "seen" : "over all of that",
                    fit.error.delta_e_2000.max));
    return out + lutlib::shader_comment("This code: " + std::string(language.trial) + ".");
}

} // namespace

int write_inline_shader(const InlineRequest& request) {
    const lutlib::ShaderLanguage& language =
        lutlib::require_named(lutlib::shader_languages(), "language", request.language);
    const io::Look look = open_look(request.look);
    const lutlib::LookEncodings encodings = look.encodings();
    const lutlib::Viewing viewing(encodings.output.value_or(lutlib::srgb()));
    const std::shared_ptr<const lutlib::Lut> table = look.is_table() ? look.table().lut : nullptr;
    const bool is_shaped = table && table->shaper && table->cube;
    const lutlib::InlineSearch search = fit_inline(
        look.exact(), look.domain(), look.breaks(), encodings, viewing, request.max_delta_e,
        is_shaped ? std::optional(lutlib::ShapedTable{*table, look.interpolation()})
                  : std::nullopt);
    if (!search.found) {
        const double least = rounded_up(search.closest.error.delta_e_2000.max);
        throw lutlib::Error(
            fmt::format("no form that code has room for stays within dE2000 {:g}: {} reach {:.2f}, "
                        "which --max-delta-e {:.2f} would allow; or leave --inline out, and let "
                        "the code read a picture that 'lutconv bake' makes",
                        request.max_delta_e, lutlib::text_of(search.closest.look), least, least),
            {io::input_name(request.look), 0, {}});
    }
    const lutlib::InlineFit& fit = *search.found;
    io::write_file(request.output, lutlib::inline_code(fit.look, language,
                                                       heading_of(request, look, language, fit)));
    print(fmt::format("{} <- {} in {}\n  lut_lookup() holds it as {}: {} numbers\n"
                      "  dE2000 from the look, as colours of {}: {}\n  {}\n",
                      output_text(request.output), input_text(request.look), language.label,
                      lutlib::text_of(fit.look), lutlib::numbers_of(fit.look), io::text_of(viewing),
                      to_text(fit.error.delta_e_2000), language.trial),
          request.output);
    return ok;
}

} // namespace converter
