#include "preview/editor/corrections.h"

#include "lutlib/error.h"
#include "lutlib/io/correction_files.h"
#include "lutlib/recipe/correction_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace preview::editor {

namespace {

using lutlib::Operation;

const lutlib::Op& cdl() {
    return *lutlib::op_named("cdl");
}

std::string lines_of(const std::vector<lutlib::Loss>& losses) {
    std::string out;
    for (const lutlib::Loss& loss : losses) {
        out += fmt::format("  lost: {}: {:.4g} {}\n", loss.what, loss.figure, loss.unit);
    }
    return out;
}

} // namespace

std::optional<std::size_t> cdl_of(const lutlib::Recipe& recipe) {
    const auto found =
        std::find_if(recipe.operations.begin(), recipe.operations.end(),
                     [](const Operation& operation) { return operation.op == &cdl(); });
    return found != recipe.operations.end()
               ? std::optional(static_cast<std::size_t>(found - recipe.operations.begin()))
               : std::nullopt;
}

std::string put_correction(State& state, const lutlib::ColorCorrection& correction) {
    std::vector<lutlib::Loss> losses;
    Operation put = operation_of(correction, losses);
    std::vector<Operation>& operations = state.recipe.operations;
    if (!cdl_of(state.recipe)) {
        operations.push_back(default_operation(cdl()));
    }
    Operation& there = operations[*cdl_of(state.recipe)];
    put.values.back() = there.values.back(); // the clamp, which no file says
    const bool clamps = std::get<double>(put.values.back()) != 0;
    there.values = std::move(put.values);
    std::string out = lines_of(losses);
    if (const double moved = clamping_of(correction); moved > 0 && !clamps) {
        out += fmt::format("  the standard clamps to 0..1, which moves colours by up to {:.4g}: "
                           "tick the clamp for that\n",
                           moved);
    }
    return out;
}

PreparedExport prepare_correction(const State& state, const std::string& id,
                                  const std::string& path) {
    const std::optional<std::size_t> at = cdl_of(state.recipe);
    if (!at) {
        throw lutlib::Error("change something on this page first: the look has no CDL yet");
    }
    std::vector<lutlib::Loss> losses;
    lutlib::ColorCorrection correction = correction_of(state.recipe, *at, losses);
    correction.id = id;
    correction.description = state.recipe.title;
    PreparedExport out{.path = path, .bytes = lutlib::io::correction_bytes(path, correction)};
    const lutlib::CorrectionFormat& format = *lutlib::correction_format_of(path);
    std::error_code unknown;
    out.report = fmt::format("the look's CDL -> {}\n  {}\n", path, format.label);
    if (format.holds_many() && std::filesystem::exists(path, unknown)) {
        out.report += fmt::format("  with the {} that stay as they are\n",
                                  lutlib::parse_corrections(out.bytes, path).size() - 1);
    }
    out.loses = !losses.empty();
    out.report += lines_of(losses);
    if (!out.loses) {
        out.report += "  nothing is lost: the file is the look\n";
    }
    return out;
}

} // namespace preview::editor
