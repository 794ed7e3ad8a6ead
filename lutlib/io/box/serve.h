// What a boxed process does for its program: the questions, and who answers them. An answer begins
// with its Outcome (values.h).
#pragma once

#include "lutlib/io/box/confine.h"
#include "lutlib/io/box/message.h"
#include "lutlib/io/ocio.h"
#include "lutlib/io/oiio.h"

#include <functional>

namespace lutlib::io::box {

/// Of the process that makes the readers: it has loaded the library and reads nothing.
enum class NurseryCall : std::uint8_t {
    reader, ///< memory, readable paths; a socket to it goes along. Answer: its process number
    ended   ///< process number. Answer: how it ended, as waitpid() says it
};

enum class OiioCall : std::uint8_t {
    held,
    version,
    size,
    read,
    writes,
    written_extensions,
    written_depth,
    write
};

enum class OcioCall : std::uint8_t {
    held,
    version,
    readable_extensions,
    parse,
    from_lut,
    from_config,
    read,
    write,
    images ///< of the transform that the reader has made
};

/// Puts the answer to a question, and throws what the library throws.
using Desk = std::function<void(Incoming& question, Outgoing& answer)>;
Desk oiio_desk(const Oiio& library, const Held& held);
Desk ocio_desk(const Ocio& library, const Held& held);

} // namespace lutlib::io::box
