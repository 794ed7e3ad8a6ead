// lutlib-reader MODULE ENTRY: loads OpenImageIO's or OpenColorIO's module, or one of a program's
// own, and makes readers of it, processes that read strangers' files within limits. Speaks with its
// program over descriptor 3.
#include "lutlib/io/box/module_desk.h"
#include "lutlib/io/box/serve.h"
#include "lutlib/io/box/values.h"

#include <csignal>
#include <cstdio>
#include <dlfcn.h>
#include <map>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lutlib::io::box {
namespace {

constexpr int program_socket = 3;

using MakeDesk = std::function<Desk(const Held&)>;

// What the library makes at its first use is made here once, of nobody's bytes, and not again in
// each reader. Not so OpenImageIO, which starts threads, and a reader would wait for those for
// ever.
void warm_up(const Ocio& library) {
    library.readable_extensions();
    Lut lut;
    lut.cube = identity_cube(2);
    library.from_lut(lut, {})(RgbD{});
}

MakeDesk desk_of(const char* module, const std::string& entry) {
    void* const library = ::dlopen(module, RTLD_NOW | RTLD_LOCAL);
    void* const found = library ? ::dlsym(library, entry.c_str()) : nullptr;
    if (found == nullptr) {
        return {};
    }
    if (entry == "lutlib_oiio") {
        return [it = reinterpret_cast<const Oiio* (*)()>(found)()](const Held& held) {
            return oiio_desk(*it, held);
        };
    }
    if (entry == "lutlib_ocio") {
        const Ocio* const it = reinterpret_cast<const Ocio* (*)()>(found)();
        warm_up(*it);
        return [it](const Held& held) { return ocio_desk(*it, held); };
    }
    return [it = reinterpret_cast<const ModuleDesk* (*)()>(found)()](const Held&) {
        return [it](Incoming& question, Outgoing& answer) { it->answer(question, answer); };
    };
}

/// The life of a reader.
[[noreturn]] void serve(int socket, const Allowance& allowance, const MakeDesk& make_desk) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // the nursery ends with its program
    const Desk desk = make_desk(confine(allowance));
    while (std::optional<Incoming> question = receive(socket, -1)) {
        const Outgoing answer = answered([&](Outgoing& out) {
            limit_computing(question->take<std::uint32_t>());
            desk(*question, out);
        });
        if (!send(socket, answer)) {
            break;
        }
    }
    ::_exit(0); // what the libraries do at the end is no business of a reader's
}

class Nursery {
  public:
    explicit Nursery(MakeDesk make_desk) : make_desk_(std::move(make_desk)) {}

    void answer(Incoming& question, Outgoing& out) {
        reap(-1, WNOHANG);
        switch (question.take<NurseryCall>()) {
        case NurseryCall::reader: {
            Allowance allowance;
            allowance.memory = question.take<std::uint64_t>();
            allowance.readable = question.take_texts();
            const Descriptor socket(question.take_file());
            const pid_t reader = ::fork();
            if (reader == 0) {
                ::close(program_socket);
                serve(socket.get(), allowance, make_desk_);
            }
            if (reader < 0) {
                throw Error("the system lets no further process start");
            }
            return out.put(std::int64_t{reader});
        }
        case NurseryCall::ended: {
            const auto reader = static_cast<pid_t>(question.take<std::int64_t>());
            if (!ends_.contains(reader)) {
                reap(reader, 0);
            }
            return out.put(std::int32_t{ends_[reader]});
        }
        }
    }

  private:
    void reap(pid_t reader, int how) {
        int status = 0;
        for (pid_t ended = 0; (ended = ::waitpid(reader, &status, how)) > 0;) {
            ends_[ended] = status;
        }
    }

    MakeDesk make_desk_;
    std::map<pid_t, int> ends_;
};

int run(const char* module, const std::string& entry) {
    const MakeDesk make_desk = desk_of(module, entry);
    prepare_to_confine();
    Outgoing greeting =
        make_desk ? answered([](Outgoing&) {}) : failure(Outcome::error, ::dlerror());
    if (!send(program_socket, greeting) || !make_desk) {
        return 1;
    }
    Nursery nursery(make_desk);
    while (std::optional<Incoming> question = receive(program_socket, -1)) {
        if (!send(program_socket,
                  answered([&](Outgoing& out) { nursery.answer(*question, out); }))) {
            break;
        }
    }
    ::_exit(0); // nor of those who make them: the program waits for their end
}

} // namespace
} // namespace lutlib::io::box

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "lutlib-reader reads files for lutconv and lutpreview, which start it "
                             "themselves\n");
        return 3;
    }
    std::signal(SIGINT, SIG_IGN); // of a terminal: the program decides, and its end is ours
    return lutlib::io::box::run(argv[1], argv[2]);
}
