// Modules of a program's own, whose questions lutlib does not know.
#pragma once

#include "lutlib/io/box/message.h"
#include "lutlib/io/box/reader.h"

namespace lutlib::io::box {

/// What such a module's entry hands out.
class ModuleDesk {
  public:
    virtual ~ModuleDesk() = default;
    /// Puts the answer to a question, and throws what the library throws.
    virtual void answer(Incoming& question, Outgoing& answer) const = 0;
};

/// The answer of a box that is made for this question; without boxes (box.h) of the module in this
/// process. `asked` begins as question(about). Throws Error.
Incoming ask_module(const Foreign& library, const Outgoing& asked, const About& about);

} // namespace lutlib::io::box
