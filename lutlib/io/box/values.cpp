#include "lutlib/io/box/values.h"

#include "lutlib/io/box/shared_bytes.h"
#include "lutlib/limits.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace lutlib::io::box {
namespace {

void put_interpolation(Outgoing& to, const std::optional<Interpolation>& how) {
    to.put(how ? static_cast<std::int32_t>(*how) : std::int32_t{-1});
}

std::optional<Interpolation> take_interpolation(Incoming& from) {
    const auto how = from.take<std::int32_t>();
    if (how < 0 || how > static_cast<std::int32_t>(Interpolation::tetrahedral)) {
        return std::nullopt;
    }
    return static_cast<Interpolation>(how);
}

void put_losses(Outgoing& to, const std::vector<Loss>& losses) {
    to.put(std::uint64_t{losses.size()});
    for (const Loss& loss : losses) {
        to.put(std::string_view(loss.what));
        to.put(loss.figure);
        to.put(std::string_view(loss.unit));
    }
}

std::vector<Loss> take_losses(Incoming& from) {
    std::vector<Loss> out;
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        Loss& loss = out.emplace_back();
        loss.what = from.take_text();
        loss.figure = from.take<double>();
        loss.unit = from.take_text();
    }
    return out;
}

// Large tables travel as shared memory, which a socket need not carry.
constexpr std::size_t few_nodes = 4096;

void put_table(Outgoing& to, std::span<const Rgb> nodes) {
    const bool is_shared = nodes.size() > few_nodes;
    to.put(std::uint8_t{is_shared});
    if (!is_shared) {
        to.put_all(nodes);
        return;
    }
    const SharedBytes shared(nodes.size_bytes());
    std::memcpy(shared.bytes().data(), nodes.data(), nodes.size_bytes());
    to.attach(shared.descriptor());
}

std::vector<Rgb> take_table(Incoming& from) {
    if (!from.take_bool()) {
        return from.take_all<Rgb>();
    }
    const ForeignBytes shared(from.take_file());
    std::vector<Rgb> out(shared.bytes().size() / sizeof(Rgb));
    std::memcpy(out.data(), shared.bytes().data(), out.size() * sizeof(Rgb));
    return out;
}

} // namespace

void put(Outgoing& to, const Lut& lut) {
    to.put(std::uint8_t{lut.shaper.has_value()});
    if (lut.shaper) {
        to.put(lut.shaper->domain);
        put_table(to, lut.shaper->entries);
    }
    to.put(std::uint8_t{lut.cube.has_value()});
    if (lut.cube) {
        to.put(lut.cube->domain);
        to.put(std::int32_t{lut.cube->size});
        put_table(to, lut.cube->nodes);
    }
    put_interpolation(to, lut.interpolation);
    to.put(std::string_view(lut.title));
    to.put(std::string_view(lut.encodings.input));
    to.put(std::string_view(lut.encodings.output));
    to.put_texts(lut.comments);
    to.put_texts(lut.keywords);
    to.put_texts(lut.notes);
    to.put(std::string_view(lut.provenance));
}

Lut take_lut(Incoming& from) {
    Lut out;
    if (from.take_bool()) {
        out.shaper.emplace();
        out.shaper->domain = from.take<Domain>();
        out.shaper->entries = take_table(from);
    }
    if (from.take_bool()) {
        out.cube.emplace();
        out.cube->domain = from.take<Domain>();
        out.cube->size = from.take<std::int32_t>();
        out.cube->nodes = take_table(from);
    }
    out.interpolation = take_interpolation(from);
    out.title = from.take_text();
    out.encodings.input = from.take_text();
    out.encodings.output = from.take_text();
    out.comments = from.take_texts();
    out.keywords = from.take_texts();
    out.notes = from.take_texts();
    out.provenance = from.take_text();
    validate(out);
    return out;
}

void put(Outgoing& to, const Reading& reading) {
    put(to, reading.lut);
    put_losses(to, reading.losses);
    put_losses(to, reading.table_losses);
    to.put_texts(reading.remarks);
}

Reading take_reading(Incoming& from) {
    Reading out{take_lut(from)};
    out.losses = take_losses(from);
    out.table_losses = take_losses(from);
    out.remarks = from.take_texts();
    return out;
}

SampleBuffer put(Outgoing& to, const SampleImage& image, const SharedPool& pool) {
    to.put(std::int32_t{image.width});
    to.put(std::int32_t{image.height});
    to.put(std::int32_t{image.channels});
    to.put(std::uint8_t{image.alpha});
    to.put(std::uint8_t{image.premultiplied});
    to.put(image.depth);
    to.put(std::uint8_t{image.srgb_tag});
    to.put(std::uint8_t{image.profile_tag});
    to.put(std::uint8_t{image.holds_light});
    to.put(std::uint64_t{image.missing_pixels});
    to.put(std::uint8_t{image.chromaticities.has_value()});
    to.put(image.chromaticities.value_or(std::array<float, 8>{}));
    if (image.samples.descriptor() >= 0) {
        to.attach(image.samples.descriptor());
        return {};
    }
    SampleBuffer out = pool.take(image.bytes());
    std::copy_n(image.samples.data(), image.bytes(), out.data());
    to.attach(out.descriptor());
    return out;
}

namespace {

// Of a picture that came: all but its samples.
SampleImage take_facts(Incoming& from) {
    SampleImage out;
    out.width = from.take<std::int32_t>();
    out.height = from.take<std::int32_t>();
    out.channels = from.take<std::int32_t>();
    out.alpha = from.take_bool();
    out.premultiplied = from.take_bool();
    out.depth = from.take<Depth>();
    out.srgb_tag = from.take_bool();
    out.profile_tag = from.take_bool();
    out.holds_light = from.take_bool();
    out.missing_pixels = static_cast<std::size_t>(from.take<std::uint64_t>());
    const bool has_chromaticities = from.take_bool();
    const auto chromaticities = from.take<std::array<float, 8>>();
    if (has_chromaticities) {
        out.chromaticities = chromaticities;
    }
    return out;
}

void require_possible(const SampleImage& out, std::size_t bytes) {
    const bool has_sides = out.width > 0 && out.height > 0 && out.width <= limits::max_image_side &&
                           out.height <= limits::max_image_side;
    if (!has_sides || out.channels < 1 || out.channels > 4 || out.depth > Depth::float32 ||
        out.missing_pixels > out.pixels() || bytes != out.bytes()) {
        throw Error("the process that reads the file sent a damaged picture; run it again, and "
                    "report the file if that fails too");
    }
}

} // namespace

SampleImage take_image(Incoming& from, ForeignCache& cache, const Oiio::Allocate& allocate) {
    SampleImage out = take_facts(from);
    const ForeignBytes shared = cache.adopt(from.take_file());
    require_possible(out, shared.bytes().size());
    out.samples = allocate(out.bytes());
    std::copy_n(shared.bytes().data(), out.bytes(), out.samples.data());
    return out;
}

ForeignImage take_foreign_image(Incoming& from, ForeignCache& cache) {
    ForeignImage out{take_facts(from), cache.adopt(from.take_file())};
    require_possible(out.image, out.bytes.bytes().size());
    // Readers of a picture take it as constant.
    auto* const data = const_cast<std::byte*>(out.bytes.bytes().data());
    out.image.samples = SampleBuffer(nullptr, {data, out.image.bytes()});
    return out;
}

void put(Outgoing& to, const Held& held) {
    to.put(std::int32_t{held.landlock});
    to.put(std::uint8_t{held.seccomp});
}

Held take_held(Incoming& from) {
    Held out;
    out.landlock = from.take<std::int32_t>();
    out.seccomp = from.take_bool();
    return out;
}

Outgoing failure(Outcome outcome, const std::string& message, const Where& where) {
    Outgoing out;
    out.put(outcome);
    out.put(std::string_view(message));
    out.put(std::string_view(where.file));
    out.put(std::uint64_t{where.line});
    out.put(std::string_view(where.text));
    return out;
}

void throw_if_failed(Incoming& answer, const std::string& file) {
    const auto outcome = answer.take<Outcome>();
    if (outcome == Outcome::answer) {
        return;
    }
    const std::string message = answer.take_text();
    Where where;
    where.file = answer.take_text();
    where.line = static_cast<std::size_t>(answer.take<std::uint64_t>());
    where.text = answer.take_text();
    if (where.file.empty()) {
        where.file = file;
    }
    switch (outcome) {
    case Outcome::usage_error:
        throw UsageError(message, where);
    case Outcome::no_memory:
        throw Error("reading it takes more memory than a reader is allowed; --max-memory raises "
                    "that",
                    where);
    default:
        throw Error(message, where);
    }
}

} // namespace lutlib::io::box
