#include "lutlib/io/box/nursery.h"

#include "lutlib/io/box/serve.h"
#include "lutlib/io/box/values.h"
#include "lutlib/io/module.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <map>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace lutlib::io::box {
namespace {

// Both ends; closed when another program starts.
std::array<int, 2> new_sockets() {
    std::array<int, 2> out{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, out.data()) != 0) {
        throw Error("cannot talk to a further process");
    }
    return out;
}

// What libraries read of the environment (plugins, caches, logs) is nothing that a file needs.
std::vector<std::string> environment() {
    std::vector<std::string> out{"LC_ALL=C", "PATH=/usr/bin:/bin"};
    for (const char* const kept : {"LD_LIBRARY_PATH", "ASAN_OPTIONS", "UBSAN_OPTIONS"}) {
        if (const char* const value = std::getenv(kept)) {
            out.push_back(std::string(kept) + "=" + value);
        }
    }
    return out;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> out;
    for (std::string& text : texts) {
        out.push_back(text.data());
    }
    out.push_back(nullptr);
    return out;
}

class Nursery {
  public:
    explicit Nursery(const Foreign& library) : module_(library.module) {
        const std::string module = module_path("lib" + std::string(library.module) + ".so");
        const std::string program = module_path("lutlib-reader");
        const auto [own, other] = new_sockets();
        socket_ = std::make_unique<Descriptor>(own);
        const Descriptor theirs(other);
        std::vector<std::string> words{program, module, std::string(library.entry)};
        std::vector<std::string> variables = environment();
        posix_spawn_file_actions_t files{};
        ::posix_spawn_file_actions_init(&files);
        for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
            ::posix_spawn_file_actions_addopen(&files, standard, "/dev/null", O_RDWR, 0);
        }
        constexpr int where = STDERR_FILENO + 1;
        if (other == where) { // a duplicate of itself would stay closed for the program
            ::fcntl(other, F_SETFD, 0);
        }
        ::posix_spawn_file_actions_adddup2(&files, other, where);
        ::posix_spawn_file_actions_addclosefrom_np(&files, where + 1);
        const int failed = ::posix_spawn(&process_, program.c_str(), &files, nullptr,
                                         pointers(words).data(), pointers(variables).data());
        ::posix_spawn_file_actions_destroy(&files);
        if (failed != 0) {
            process_ = 0;
            throw Error("cannot start " + program);
        }
    }

    ~Nursery() {
        socket_.reset();
        if (process_ != 0) {
            ::waitpid(process_, nullptr, 0);
        }
    }

    Nursery(const Nursery&) = delete;
    Nursery& operator=(const Nursery&) = delete;

    /// The library is loaded meanwhile.
    void await_greeting() {
        std::optional<Incoming> greeting = receive(socket_->get(), -1);
        if (!greeting) {
            throw Error("the program lutlib-reader does not answer");
        }
        try {
            throw_if_failed(*greeting, {});
        } catch (const Error& error) {
            throw Error(loading_problem(module_, error.message()));
        }
    }

    std::optional<Incoming> ask(const Outgoing& question) {
        return send(socket_->get(), question) ? receive(socket_->get(), -1) : std::nullopt;
    }

  private:
    std::string_view module_;
    std::unique_ptr<Descriptor> socket_;
    pid_t process_ = 0;
};

// One of each library, made anew when it has been killed.
class Nurseries {
  public:
    Incoming ask(const Foreign& library, const Outgoing& question) {
        const std::lock_guard lock(mutex_);
        std::unique_ptr<Nursery>& nursery = all_[library.module];
        for (int attempt = 0; attempt < 2; ++attempt) {
            if (!nursery) {
                auto made = std::make_unique<Nursery>(library);
                made->await_greeting();
                nursery = std::move(made);
            }
            if (std::optional<Incoming> answer = nursery->ask(question)) {
                throw_if_failed(*answer, {});
                return std::move(*answer);
            }
            nursery.reset();
        }
        throw Error("the program lutlib-reader ends before it answers");
    }

  private:
    std::mutex mutex_;
    std::map<std::string_view, std::unique_ptr<Nursery>> all_;
};

Nurseries& nurseries() {
    static Nurseries all;
    return all;
}

} // namespace

Born new_reader(const Foreign& library, const Allowance& allowance) {
    const auto [own, other] = new_sockets();
    auto socket = std::make_unique<Descriptor>(own);
    const Descriptor theirs(other);
    Outgoing wanted;
    wanted.put(NurseryCall::reader);
    wanted.put(std::uint64_t{allowance.memory});
    wanted.put_texts(allowance.readable);
    wanted.attach(other);
    const auto process = static_cast<pid_t>(nurseries().ask(library, wanted).take<std::int64_t>());
    return {socket->release(), process};
}

int end_of(const Foreign& library, pid_t reader) {
    Outgoing question;
    question.put(NurseryCall::ended);
    question.put(std::int64_t{reader});
    return nurseries().ask(library, question).take<std::int32_t>();
}

} // namespace lutlib::io::box
