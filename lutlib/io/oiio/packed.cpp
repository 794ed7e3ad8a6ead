#include "lutlib/io/oiio/packed.h"

#include "lutlib/io/box/message.h"

namespace lutlib::io {
namespace {

using box::Incoming;
using box::Outgoing;

// The windows and the tiles of a picture, by OpenImageIO's names.
constexpr std::array whole_numbers{&OIIO::ImageSpec::x,
                                   &OIIO::ImageSpec::y,
                                   &OIIO::ImageSpec::z,
                                   &OIIO::ImageSpec::width,
                                   &OIIO::ImageSpec::height,
                                   &OIIO::ImageSpec::depth,
                                   &OIIO::ImageSpec::full_x,
                                   &OIIO::ImageSpec::full_y,
                                   &OIIO::ImageSpec::full_z,
                                   &OIIO::ImageSpec::full_width,
                                   &OIIO::ImageSpec::full_height,
                                   &OIIO::ImageSpec::full_depth,
                                   &OIIO::ImageSpec::tile_width,
                                   &OIIO::ImageSpec::tile_height,
                                   &OIIO::ImageSpec::tile_depth,
                                   &OIIO::ImageSpec::nchannels,
                                   &OIIO::ImageSpec::alpha_channel,
                                   &OIIO::ImageSpec::z_channel};

void put(Outgoing& to, const OIIO::TypeDesc& type) {
    to.put(std::array<std::int32_t, 4>{type.basetype, type.aggregate, type.vecsemantics,
                                       type.arraylen});
}

OIIO::TypeDesc take_type(Incoming& from) {
    const auto parts = from.take<std::array<std::int32_t, 4>>();
    return {static_cast<OIIO::TypeDesc::BASETYPE>(parts[0]),
            static_cast<OIIO::TypeDesc::AGGREGATE>(parts[1]),
            static_cast<OIIO::TypeDesc::VECSEMANTICS>(parts[2]), parts[3]};
}

void put(Outgoing& to, const OIIO::ParamValue& attribute) {
    to.put(std::string_view(attribute.name().string()));
    put(to, attribute.type());
    to.put(std::int32_t{attribute.nvalues()});
    if (attribute.type().basetype == OIIO::TypeDesc::STRING) {
        const auto* const texts = static_cast<const OIIO::ustring*>(attribute.data());
        for (std::size_t i = 0; i < attribute.type().numelements(); ++i) {
            to.put(std::string_view(texts[i].string()));
        }
    } else {
        to.put_all(std::span(static_cast<const std::byte*>(attribute.data()),
                             static_cast<std::size_t>(attribute.datasize())));
    }
}

void take_attribute(Incoming& from, OIIO::ImageSpec& spec) {
    const std::string name = from.take_text();
    const auto type = take_type(from);
    const auto count = from.take<std::int32_t>();
    if (type.basetype != OIIO::TypeDesc::STRING) {
        const std::vector<std::byte> data = from.take_all<std::byte>();
        if (count != 1 || data.size() != type.size()) {
            throw Error("a kept attribute makes no sense");
        }
        spec.attribute(name, type, data.data());
        return;
    }
    std::vector<OIIO::ustring> texts;
    for (std::size_t i = 0; i < type.numelements(); ++i) {
        texts.emplace_back(from.take_text());
    }
    spec.attribute(name, type, texts.data());
}

bool can_travel(const OIIO::ParamValue& attribute) {
    return attribute.nvalues() == 1 && attribute.type().basetype != OIIO::TypeDesc::PTR;
}

void put(Outgoing& to, const OIIO::ImageSpec& spec) {
    for (int OIIO::ImageSpec::*const number : whole_numbers) {
        to.put(std::int32_t{spec.*number});
    }
    put(to, spec.format);
    to.put(std::uint64_t{spec.channelformats.size()});
    for (const OIIO::TypeDesc& format : spec.channelformats) {
        put(to, format);
    }
    to.put_texts(spec.channelnames);
    to.put(static_cast<std::uint64_t>(
        std::count_if(spec.extra_attribs.begin(), spec.extra_attribs.end(), can_travel)));
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        if (can_travel(attribute)) {
            put(to, attribute);
        }
    }
}

OIIO::ImageSpec take_spec(Incoming& from) {
    OIIO::ImageSpec out;
    for (int OIIO::ImageSpec::*const number : whole_numbers) {
        out.*number = from.take<std::int32_t>();
    }
    out.format = take_type(from);
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        out.channelformats.push_back(take_type(from));
    }
    out.channelnames = from.take_texts();
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        take_attribute(from, out);
    }
    return out;
}

} // namespace

std::string packed_source(const OiioSource& source) {
    Outgoing to;
    to.put(std::string_view(source.type));
    to.put(std::string_view(source.icc_profile));
    to.put(std::uint8_t{source.premultiplied});
    to.put(std::int32_t{source.orientation});
    to.put_pairs(source.text);
    to.put(std::uint64_t{source.picture.part});
    to.put(std::string_view(source.picture.layer));
    to.put(source.picture.at);
    to.put(std::uint64_t{source.parts.size()});
    for (const KeptPart& part : source.parts) {
        put(to, part.spec);
        to.put_all(std::span<const std::byte>(part.pixels));
    }
    return to.bytes();
}

std::shared_ptr<const OiioSource> unpacked_source(std::string_view bytes) {
    Incoming from(std::string(bytes), {});
    const auto out = std::make_shared<OiioSource>();
    out->type = from.take_text();
    out->icc_profile = from.take_text();
    out->premultiplied = from.take_bool();
    out->orientation = from.take<std::int32_t>();
    out->text = from.take_pairs();
    out->picture.part = from.take<std::uint64_t>();
    out->picture.layer = from.take_text();
    out->picture.at = from.take<std::array<int, 4>>();
    for (auto left = from.take<std::uint64_t>(); left > 0; --left) {
        KeptPart& part = out->parts.emplace_back();
        part.spec = take_spec(from);
        part.pixels = from.take_all<std::byte>();
    }
    if (out->picture.part >= out->parts.size()) {
        throw Error("a kept picture makes no sense");
    }
    return out;
}

} // namespace lutlib::io
