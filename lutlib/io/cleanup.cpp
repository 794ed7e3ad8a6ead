#include "lutlib/io/cleanup.h"

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

namespace lutlib::io {
namespace {

// A signal handler may neither allocate nor lock: paths lie in a fixed table. A path that finds no
// place is left behind by a signal, and by nothing else.
struct Slot {
    std::atomic<bool> taken{false}; ///< by a RemovedBySignals
    std::atomic<bool> ready{false}; ///< `path` is whole
    std::array<char, PATH_MAX> path{};
};
std::array<Slot, 32> slots;
static_assert(std::atomic<bool>::is_always_lock_free);

constexpr std::array<int, 7> ending{SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGPIPE, SIGXCPU, SIGXFSZ};
std::array<struct sigaction, ending.size()> before;
std::atomic<bool> end_is_meant{false};

extern "C" void remove_files(int signal) {
    for (const Slot& slot : slots) {
        if (slot.ready) {
            ::unlink(slot.path.data());
        }
    }
    for (const Slot& slot : slots) {
        if (slot.ready) {
            ::rmdir(slot.path.data());
        }
    }
    if (end_is_meant && (signal == SIGINT || signal == SIGTERM)) {
        ::_exit(EXIT_SUCCESS);
    }
    // The signal is blocked until this returns, and then goes to whom it went before.
    for (std::size_t i = 0; i < ending.size(); ++i) {
        if (ending[i] == signal) {
            ::sigaction(signal, &before[i], nullptr);
        }
    }
    ::raise(signal);
}

bool handle_signals() {
    for (std::size_t i = 0; i < ending.size(); ++i) {
        ::sigaction(ending[i], nullptr, &before[i]);
        // An ignored signal does not end the program.
        if (before[i].sa_handler != SIG_IGN) {
            struct sigaction action {};
            action.sa_handler = remove_files;
            ::sigaction(ending[i], &action, nullptr);
        }
    }
    return true;
}

void handle_signals_once() {
    static const bool handled = handle_signals();
    static_cast<void>(handled);
}

} // namespace

RemovedBySignals::RemovedBySignals(const std::string& path) : slot_(-1) {
    handle_signals_once();
    for (std::size_t i = 0; path.size() < PATH_MAX && slot_ < 0 && i < slots.size(); ++i) {
        if (!slots[i].taken.exchange(true)) {
            std::memcpy(slots[i].path.data(), path.c_str(), path.size() + 1);
            slots[i].ready = true;
            slot_ = static_cast<int>(i);
        }
    }
}

RemovedBySignals::~RemovedBySignals() {
    if (slot_ >= 0) {
        Slot& slot = slots[static_cast<std::size_t>(slot_)];
        slot.ready = false;
        slot.taken = false;
    }
}

EndedBySignals::EndedBySignals() {
    handle_signals_once();
    end_is_meant = true;
}

EndedBySignals::~EndedBySignals() {
    end_is_meant = false;
}

} // namespace lutlib::io
