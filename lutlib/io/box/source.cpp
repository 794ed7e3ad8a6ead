#include "lutlib/io/box/source.h"

namespace lutlib::io::box {

void put_source(Outgoing& to, const PictureSource* source, int packed) {
    to.put(std::uint8_t{source != nullptr});
    if (source == nullptr) {
        return;
    }
    to.put(std::string_view(source->type));
    to.put(std::string_view(source->icc_profile));
    to.put_pairs(source->text);
    to.put(std::int32_t{source->orientation});
    to.put(std::uint8_t{source->premultiplied});
    to.put_texts(source->remarks);
    to.put_texts(source->beyond_text());
    to.put(std::uint8_t{packed >= 0});
    if (packed >= 0) {
        to.attach(packed);
    }
}

std::shared_ptr<const BoxedSource> take_source(Incoming& from) {
    if (!from.take_bool()) {
        return nullptr;
    }
    const auto out = std::make_shared<BoxedSource>();
    out->type = from.take_text();
    out->icc_profile = from.take_text();
    out->text = from.take_pairs();
    out->orientation = from.take<std::int32_t>();
    out->premultiplied = from.take_bool();
    out->remarks = from.take_texts();
    out->beyond = from.take_texts();
    if (from.take_bool()) {
        out->packed = ForeignBytes(from.take_file());
    }
    return out;
}

} // namespace lutlib::io::box
