#include "lutlib/io/box/confine.h"

#include "lutlib/io/descriptor.h"

#include <array>
#include <cerrno>
#include <ctime>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <vector>

namespace lutlib::io::box {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool has_shadow_memory = true; // terabytes of addresses
#elif defined(__has_feature)
constexpr bool has_shadow_memory = __has_feature(address_sanitizer);
#else
constexpr bool has_shadow_memory = false;
#endif

void limit(__rlimit_resource what, rlim_t most) {
    const rlimit both{most, most};
    ::setrlimit(what, &both);
}

// Landlock's first version knows these; later ones add more, which seccomp forbids besides.
constexpr std::uint64_t all_of_files = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
constexpr std::uint64_t reading = LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;

void allow_reading(int rules, const std::string& path) {
    const Descriptor file(::open(path.c_str(), O_PATH | O_CLOEXEC));
    struct stat info {};
    if (file.get() < 0 || ::fstat(file.get(), &info) != 0) {
        return; // whoever reads it will say so
    }
    landlock_path_beneath_attr rule{};
    rule.allowed_access =
        S_ISDIR(info.st_mode) ? reading : std::uint64_t{LANDLOCK_ACCESS_FS_READ_FILE};
    rule.parent_fd = file.get();
    ::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

int forbid_files(const std::vector<std::string>& readable) {
    const long version =
        ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    if (version < 1) {
        return 0;
    }
    landlock_ruleset_attr handled{};
    handled.handled_access_fs = all_of_files;
    const Descriptor rules(static_cast<int>(
        ::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled.handled_access_fs, 0)));
    for (const std::string& path : readable) {
        allow_reading(rules.get(), path);
    }
    return ::syscall(SYS_landlock_restrict_self, rules.get(), 0) == 0 ? static_cast<int>(version)
                                                                      : 0;
}

// A list of what is forbidden, for what libraries and the C library call differs between versions.
constexpr std::array forbidden_calls{SCMP_SYS(socket),
                                     SCMP_SYS(connect),
                                     SCMP_SYS(bind),
                                     SCMP_SYS(listen),
                                     SCMP_SYS(accept),
                                     SCMP_SYS(accept4),
                                     SCMP_SYS(execve),
                                     SCMP_SYS(execveat),
                                     SCMP_SYS(fork),
                                     SCMP_SYS(vfork),
                                     SCMP_SYS(ptrace),
                                     SCMP_SYS(process_vm_readv),
                                     SCMP_SYS(process_vm_writev),
                                     SCMP_SYS(kill),
                                     SCMP_SYS(tkill),
                                     SCMP_SYS(pidfd_open),
                                     SCMP_SYS(pidfd_getfd),
                                     SCMP_SYS(pidfd_send_signal),
                                     SCMP_SYS(mount),
                                     SCMP_SYS(umount2),
                                     SCMP_SYS(pivot_root),
                                     SCMP_SYS(chroot),
                                     SCMP_SYS(setns),
                                     SCMP_SYS(unshare),
                                     SCMP_SYS(bpf),
                                     SCMP_SYS(perf_event_open),
                                     SCMP_SYS(keyctl),
                                     SCMP_SYS(add_key),
                                     SCMP_SYS(request_key),
                                     SCMP_SYS(userfaultfd),
                                     SCMP_SYS(io_uring_setup),
                                     SCMP_SYS(open_by_handle_at),
                                     SCMP_SYS(init_module),
                                     SCMP_SYS(finit_module),
                                     SCMP_SYS(unlink),
                                     SCMP_SYS(unlinkat),
                                     SCMP_SYS(rename),
                                     SCMP_SYS(renameat),
                                     SCMP_SYS(renameat2),
                                     SCMP_SYS(link),
                                     SCMP_SYS(linkat),
                                     SCMP_SYS(symlink),
                                     SCMP_SYS(symlinkat),
                                     SCMP_SYS(mkdir),
                                     SCMP_SYS(mkdirat),
                                     SCMP_SYS(rmdir),
                                     SCMP_SYS(mknod),
                                     SCMP_SYS(mknodat),
                                     SCMP_SYS(truncate),
                                     SCMP_SYS(chmod),
                                     SCMP_SYS(fchmod),
                                     SCMP_SYS(fchmodat),
                                     SCMP_SYS(chown),
                                     SCMP_SYS(lchown),
                                     SCMP_SYS(fchown),
                                     SCMP_SYS(fchownat),
                                     SCMP_SYS(setxattr),
                                     SCMP_SYS(lsetxattr),
                                     SCMP_SYS(fsetxattr),
                                     SCMP_SYS(utimensat)};

using Program = std::vector<sock_filter>;

// As bytes for the kernel; empty where libseccomp cannot make it.
Program exported(scmp_filter_ctx filter) {
    const Descriptor file(::memfd_create("filter", MFD_CLOEXEC));
    struct stat info {};
    if (file.get() < 0 || ::seccomp_export_bpf(filter, file.get()) != 0 ||
        ::fstat(file.get(), &info) != 0) {
        return {};
    }
    Program out(static_cast<std::size_t>(info.st_size) / sizeof(sock_filter));
    const auto bytes = static_cast<ssize_t>(out.size() * sizeof(sock_filter));
    return ::pread(file.get(), out.data(), static_cast<std::size_t>(bytes), 0) == bytes ? out
                                                                                        : Program();
}

Program made_filter() {
    const scmp_filter_ctx filter = ::seccomp_init(SCMP_ACT_ALLOW);
    if (filter == nullptr) {
        return {};
    }
    bool is_whole = true;
    for (const int call : forbidden_calls) {
        is_whole = is_whole && ::seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), call, 0) == 0;
    }
    // Threads are started, processes are not; the C library falls back to clone, whose flags can be
    // looked at.
    is_whole = is_whole &&
               ::seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0) == 0 &&
               ::seccomp_rule_add(filter, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), 1,
                                  SCMP_A0(SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0)) == 0;
    const Program out = is_whole ? exported(filter) : Program();
    ::seccomp_release(filter);
    return out;
}

// Made once: it takes as long as a reader's other preparations together.
const Program& filter_of_calls() {
    static const Program made = made_filter();
    return made;
}

bool forbid_calls() {
    const Program& filter = filter_of_calls();
    sock_fprog program{static_cast<unsigned short>(filter.size()),
                       const_cast<sock_filter*>(filter.data())};
    return !filter.empty() && ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

} // namespace

void prepare_to_confine() {
    filter_of_calls();
}

Held confine(const Allowance& allowance) {
    if (!has_shadow_memory) {
        limit(RLIMIT_AS, allowance.memory);
    }
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, 64);
    Held out;
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) {
        out.landlock = forbid_files(allowance.readable);
        out.seccomp = forbid_calls();
    }
    return out;
}

void limit_computing(unsigned seconds) {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    rlimit both{};
    ::getrlimit(RLIMIT_CPU, &both);
    both.rlim_cur = static_cast<rlim_t>(used.tv_sec) + 1 + (has_shadow_memory ? 10 : 1) * seconds;
    ::setrlimit(RLIMIT_CPU, &both);
}

} // namespace lutlib::io::box
