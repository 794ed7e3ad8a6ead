// What a picture's file holds besides the picture, on its way between processes.
#pragma once

#include "lutlib/io/box/message.h"
#include "lutlib/io/box/shared_bytes.h"
#include "lutlib/io/picture_source.h"

namespace lutlib::io::box {

struct BoxedSource final : PictureSource {
    ForeignBytes packed; ///< as of Oiio::packed(); none: the base is all
    std::vector<std::string> beyond;

    std::vector<std::string> beyond_text() const override { return beyond; }
};

/// May be null. `packed` is an open file; -1: none.
void put_source(Outgoing& to, const PictureSource* source, int packed);
std::shared_ptr<const BoxedSource> take_source(Incoming& from);

} // namespace lutlib::io::box
