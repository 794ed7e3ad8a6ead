#include "lutlib/io/box/reader.h"

#include "lutlib/io/box/nursery.h"
#include "lutlib/io/box/values.h"

#include <csignal>
#include <cstring>
#include <sys/wait.h>

namespace lutlib::io::box {

std::uint32_t seconds_for(const About& about) {
    constexpr std::size_t least = 1, bytes_each = std::size_t{256} << 10;
    constexpr std::size_t colors_each = 100'000;
    return static_cast<std::uint32_t>(least + about.bytes / bytes_each +
                                      about.colors / colors_each);
}

Outgoing question(const About& about) {
    Outgoing out;
    out.put(seconds_for(about));
    return out;
}

Reader::Reader(const Foreign& library, const Allowance& allowance) : library_(library) {
    const Born born = new_reader(library, allowance);
    socket_ = std::make_unique<Descriptor>(born.socket);
    process_ = born.process;
}

Reader::~Reader() = default;

Incoming Reader::ask(const Outgoing& question, const About& about) {
    // Computing is limited on the other side; this is for one that waits for ever.
    const int longest_wait = static_cast<int>(1000 * (60 + 20 * seconds_for(about)));
    if (socket_ == nullptr) {
        throw Error("the reader has ended", {about.file, 0, {}});
    }
    if (send(socket_->get(), question)) {
        if (std::optional<Incoming> answer = receive(socket_->get(), longest_wait)) {
            throw_if_failed(*answer, about.file);
            return std::move(*answer);
        }
    }
    tell_end(about);
}

void Reader::tell_end(const About& about) {
    socket_.reset();
    ::kill(process_, SIGKILL);
    const int status = end_of(library_, process_);
    const std::string who(library_.library);
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (signal == SIGXCPU || signal == SIGKILL) {
        throw Error(who + " computes longer on it than on any whole file of its size, " +
                        std::to_string(seconds_for(about)) +
                        " s; fetch or export it again, or read it without a limit by --no-sandbox",
                    {about.file, 0, {}});
    }
    throw Error(who + "'s reader crashes on it (" +
                    (signal != 0 ? ::strsignal(signal) : "it ended by itself") +
                    "); it is damaged: fetch or export it again",
                {about.file, 0, {}});
}

} // namespace lutlib::io::box
