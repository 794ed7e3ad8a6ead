#include "lutlib/io/look.h"

#include "lutlib/error.h"
#include "lutlib/formats/cube.h"
#include "lutlib/io/describe.h"
#include "lutlib/io/file.h"
#include "lutlib/io/formats.h"
#include "lutlib/io/formats/opencolorio.h"
#include "lutlib/io/lut_picture.h"
#include "lutlib/io/ocio.h"
#include "lutlib/io/recipe_file.h"
#include "lutlib/io/references.h"
#include "lutlib/metrics/compare.h"
#include "lutlib/metrics/samples.h"
#include "lutlib/metrics/scale.h"
#include "lutlib/recipe/bake_recipe.h"
#include "lutlib/text.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace lutlib::io {
namespace {

// The table that a recipe becomes, with what lies between its nodes measured.
LookTable baked(const Recipe& recipe) {
    // Tables hold floats.
    constexpr double float_rounding = 2e-6;
    const auto lut = std::make_shared<const Lut>(bake_recipe(recipe));
    const Transform exact = Transform::of(recipe);
    const Peak peak =
        largest_difference(exact, Transform::of(lut),
                           error_samples(lut->domain(), united(no_breaks(), breaks_of(*lut))),
                           recipe.output_encoding(), Metric::code);
    LookTable out{lut, {}};
    if (peak.error > float_rounding * std::max(1.0, largest_magnitude(exact(to_double(peak.at))))) {
        out.losses.push_back({"recipe sampled onto " + shape_of(*lut) + " over the input " +
                                  text_of(lut->domain()) + ", largest error",
                              peak.error, ""});
    }
    return out;
}

// What was guessed of a picture's layout, then of a table's codes; names of encodings that nobody
// knows here.
std::vector<std::string> remarks_of(std::vector<std::string> remarks, const Lut& lut,
                                    const LookEncodings& said = {}) {
    remarks.insert(remarks.end(), lut.notes.begin(), lut.notes.end());
    const auto look_at = [&](const char* side, const std::string& name,
                             const std::optional<Encoding>& option) {
        const std::optional<Encoding> known = encoding_named(name);
        if (!name.empty() && !known && !option) {
            remarks.push_back(fmt::format("its {0} encoding '{1}' is unknown; name one of 'lutconv "
                                          "encodings' with --look-{0}",
                                          side, name));
        } else if (known && option && *known != *option) {
            remarks.push_back(
                fmt::format("it says that its {0} is {1}; --look-{0} {2} is used instead", side,
                            name, option->name()));
        }
    };
    look_at("input", lut.encodings.input, said.input);
    look_at("output", lut.encodings.output, said.output);
    return remarks;
}

// Where a file leaves it to its readers how large white is.
std::string scale_text(const Transform& theirs, const Lut& lut, Interpolation how) {
    const std::vector<Rgb> inputs = sample_colors(5, {.neutral = 64, .random = 500});
    const auto scale = scale_between(theirs, Transform::of(lut, how), inputs);
    if (!scale) {
        return {};
    }
    std::string why;
    for (const std::string& note : lut.notes) {
        why += (why.empty() ? ": " : "; ") + note;
    }
    return fmt::format("OpenColorIO reads {:.4g} times the values that lutlib reads{}", *scale,
                       why);
}

// The format of a file that need not be there whole, by its first bytes; null for all others.
const FileFormat* format_in_pieces(std::string_view head, const std::string& path) {
    if (is_recipe(head) || utf8_of_utf16(head)) {
        return nullptr;
    }
    const FileFormat* const format = find_format(head, path);
    return format && format->read_in_pieces ? format : nullptr;
}

bool claims_to_be_a_look(const std::string& path) {
    const auto formats = file_formats();
    return std::any_of(formats.begin(), formats.end(), [&](const FileFormat* format) {
        return format->extensions.contain(extension_of(path)) && !format->picture;
    });
}

} // namespace

Look Look::open(const std::string& path, const LookOptions& options) {
    FileInput file(path);
    std::string head = file.head(FileFormat::head_bytes);
    const FileFormat* const format =
        file.remaining() > 0 && options.format.empty() ? format_in_pieces(head, path) : nullptr;
    if (!format || file.remaining() > limits::max_file_bytes) {
        return of_bytes(file.all_of(std::move(head)), path, options);
    }
    Look out(path, options);
    out.take({.lut = format->read_in_pieces(head, file, out.name_)}, *format);
    return out;
}

Look::Look(const std::string& path, const LookOptions& options)
    : path_(path), name_(input_name(path)), options_(options) {}

Look Look::of_bytes(std::string bytes, const std::string& path, const LookOptions& options) {
    Look out(path, options);
    out.bytes_ = std::move(bytes);
    if (options.format.empty() && is_recipe(out.bytes_)) {
        out.read_recipe();
    } else {
        out.read_table();
    }
    return out;
}

std::optional<Look> Look::open_if_look(const std::string& path, const LookOptions& options) {
    std::string bytes = read_file(path);
    try {
        return of_bytes(bytes, path, options);
    } catch (const UsageError&) {
        throw;
    } catch (const Error&) {
        const bool says_recipe =
            is_recipe(bytes) && bytes.find("\"schema_version\"") != std::string::npos;
        if (says_recipe || claims_to_be_a_look(path)) {
            throw;
        }
        return std::nullopt;
    }
}

void Look::read_recipe() {
    kind_.format = "recipe";
    files_ = {{name_, {}, {}, {}}};
    recipe_ = parse_recipe(bytes_, name_);
    if (recipe_->base.empty()) {
        return;
    }
    const std::string base_bytes = read_reference(path_, recipe_->base);
    if (is_recipe(base_bytes)) {
        throw Error("its base is a recipe too; bake that one into a LUT and name it here",
                    {name_, 0, recipe_->base});
    }
    Reading base = decode_lut(base_bytes, base_path(*recipe_, path_),
                              {.layout = options_.layout, .engine = options_.engine});
    files_.push_back({base.lut.provenance, base.all_losses(), base.lut.keywords,
                      remarks_of(base.remarks, base.lut)});
    const auto given = encoding_named(base.lut.encodings.output);
    if (given && !recipe_->states_input) {
        recipe_->input = *given;
    } else if (given && *given != recipe_->input) {
        files_.front().remarks.push_back(fmt::format(
            "its operators work on {0} and its base gives {1}; nothing converts between "
            "them: write \"input\": \"{1}\" into the recipe",
            recipe_->input.name(), given->name()));
    }
    recipe_->base_lut = std::make_shared<const Lut>(std::move(base.lut));
}

void Look::read_table() {
    const FileFormat& format = options_.format.empty() ? recognise_format(bytes_, name_)
                                                       : require_file_format(options_.format);
    take(decode_lut(bytes_, name_, read_options(0), format.name), format);
}

ReadOptions Look::read_options(int size) const {
    return {
        .size = size, .layout = options_.layout, .engine = options_.engine, .row = options_.row};
}

void Look::take(Reading reading, const FileFormat& format) {
    kind_ = {std::string(format.name), reading.layout, reading.engine};
    files_ = {{name_, std::move(reading.losses), reading.lut.keywords,
               remarks_of(reading.remarks, reading.lut, options_.encodings)}};
    table_losses_ = std::move(reading.table_losses);
    const EncodingNames said = names_of(options_.encodings);
    EncodingNames& names = reading.lut.encodings;
    names = {said.input.empty() ? names.input : said.input,
             said.output.empty() ? names.output : said.output};
    lut_ = std::make_shared<const Lut>(std::move(reading.lut));
}

const std::string& Look::title() const {
    return recipe_ ? recipe_->title : lut_->title;
}

Domain Look::domain() const {
    if (!recipe_) {
        return lut_->domain();
    }
    return recipe_->bake.domain.value_or(recipe_->base_lut ? recipe_->base_lut->domain()
                                                           : Domain{});
}

std::optional<Domain> Look::clamps_to() const {
    const Lut* const table = recipe_ ? recipe_->base_lut.get() : is_table() ? lut_.get() : nullptr;
    return table ? std::optional(table->domain()) : std::nullopt;
}

LookEncodings Look::encodings() const {
    LookEncodings out = recipe_ ? encodings_of(*recipe_) : lutlib::encodings_of(lut_->encodings);
    out.input = options_.encodings.input ? options_.encodings.input : out.input;
    out.output = options_.encodings.output ? options_.encodings.output : out.output;
    return out;
}

Recipe Look::as_recipe() const {
    if (recipe_) {
        return *recipe_;
    }
    Recipe out;
    out.base = path_;
    out.base_lut = lut_;
    return out;
}

Interpolation Look::interpolation() const {
    return options_.interpolation.value_or(lut_ ? usual_interpolation(*lut_)
                                                : Interpolation::tetrahedral);
}

Breaks Look::breaks() const {
    if (recipe_) {
        return united(no_breaks(), recipe_->base_lut ? breaks_of(*recipe_->base_lut) : Breaks{});
    }
    return is_table() ? breaks_of(*lut_, interpolation()) : no_breaks();
}

std::optional<int> Look::nodes() const {
    const bool is_lattice =
        !recipe_ && is_table() && lut_->cube && !lut_->shaper && lut_->domain().is_unit();
    return is_lattice ? std::optional(lut_->cube->size) : std::nullopt;
}

Transform Look::exact() const {
    return recipe_      ? Transform::of(*recipe_)
           : is_table() ? Transform::of(lut_, interpolation())
                        : in_opencolorio(interpolation());
}

LookTable Look::table(int size) const {
    if (recipe_) {
        Recipe recipe = *recipe_;
        if (size != 0) {
            recipe.bake.size = size;
        }
        return baked(recipe);
    }
    if (size == 0 || is_table()) {
        return {lut_, table_losses_};
    }
    Reading reading = decode_lut(bytes_, name_, read_options(size), kind_.format);
    return {std::make_shared<const Lut>(std::move(reading.lut)), std::move(reading.table_losses)};
}

std::optional<LookPicture> Look::picture() const {
    if (!kind_.layout) {
        return std::nullopt;
    }
    LookPicture out{code_picture(read_lut_picture(bytes_, name_)), kind_.layout, kind_.engine,
                    lut_->cube->size};
    const bool is_whole = kind_.layout->lattice({out.codes.width, out.codes.height}) == out.size;
    return is_whole ? std::optional(std::move(out)) : std::nullopt;
}

LookReference Look::reference(Interpolation how) const {
    if (recipe_) {
        return {exact(), "the recipe, evaluated exactly", {}};
    }
    if (how == Interpolation::nearest) {
        return {Transform::of(lut_, how),
                "lutlib, exactly, as OpenColorIO has no nearest interpolation",
                {}};
    }
    LookReference out{{}, "OpenColorIO " + ocio().version(), {}};
    if (kind_.layout) {
        out.refusal = "it reads no pictures";
    } else if (lut_->interpolation.value_or(how) != how) {
        out.refusal = "the file asks for " + std::string(name_of(*lut_->interpolation)) +
                      " interpolation, not " + std::string(name_of(how));
    } else if (require_file_format(kind_.format).extensions.contain("cube") &&
               has_decimal_commas(bytes_.empty() ? read_file(path_) : bytes_)) {
        out.refusal = "it stops at decimal commas";
    } else {
        try {
            out.look = opened_by_opencolorio(how);
            out.scale = scale_text(out.look, *lut_, how);
            if (out.scale.empty()) {
                return out;
            }
        } catch (const Error& error) {
            out.refusal = error.message();
        }
    }
    out.look = ocio().from_lut(*lut_, {.interpolation = how});
    return out;
}

Transform Look::opened_by_opencolorio(Interpolation how) const {
    // It chooses its reader by the extension first.
    const bool is_named_so =
        require_file_format(kind_.format).extensions.contain(extension_of(path_));
    const auto own = is_named_so ? ocio().open(path_, {.interpolation = how}) : std::nullopt;
    return own ? *own : in_opencolorio(how);
}

Transform Look::in_opencolorio(Interpolation how) const {
    const FileFormat& format = require_file_format(kind_.format);
    // A table that was read in pieces is not kept as text.
    return ocio().parse(bytes_.empty() ? read_file(path_) : bytes_,
                        formats::opencolorio_extension(format, name_), name_,
                        {.interpolation = how});
}

} // namespace lutlib::io
