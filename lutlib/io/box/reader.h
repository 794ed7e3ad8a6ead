// A boxed process that reads files for this program.
#pragma once

#include "lutlib/io/box/confine.h"
#include "lutlib/io/box/message.h"

#include <memory>
#include <mutex>
#include <string>
#include <sys/types.h>

namespace lutlib::io::box {

/// A library that is used in boxes only.
struct Foreign {
    std::string_view module;  ///< "lutlib_oiio": liblutlib_oiio.so
    std::string_view entry;   ///< the function that it exports, which tells its interface too
    std::string_view library; ///< for messages
};
inline constexpr Foreign openimageio{"lutlib_oiio", "lutlib_oiio", "OpenImageIO"};
inline constexpr Foreign opencolorio{"lutlib_ocio", "lutlib_ocio", "OpenColorIO"};

/// What a question is about.
struct About {
    std::string file;       ///< for messages
    std::size_t bytes = 0;  ///< of the file: a reader may compute in proportion
    std::size_t colors = 0; ///< to compute
};

/// The seconds of computing that a question may take.
std::uint32_t seconds_for(const About& about);

/// The beginning of a question; what it needs follows.
Outgoing question(const About& about);
template <Plain Call>
Outgoing question(Call call, const About& about) {
    Outgoing out = question(about);
    out.put(call);
    return out;
}

/// One process, which starts with the object and ends with it. One question at a time.
class Reader {
  public:
    /// Throws Error when the library is not installed or no process can be had.
    Reader(const Foreign& library, const Allowance& allowance);
    ~Reader();
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// The answer, behind its Outcome. Throws what the other side throws; and Error, with the
    /// reason, when the process has died of the question.
    Incoming ask(const Outgoing& question, const About& about);

    bool is_alive() const { return socket_ != nullptr; }

  private:
    [[noreturn]] void tell_end(const About& about);

    const Foreign& library_;
    std::unique_ptr<Descriptor> socket_;
    pid_t process_ = 0;
};

} // namespace lutlib::io::box
