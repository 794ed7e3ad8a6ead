// The process that makes the readers of one library: it has loaded the library and reads nothing
// itself, so that a reader costs a fork and never inherits a stranger's bytes.
#pragma once

#include "lutlib/io/box/confine.h"
#include "lutlib/io/box/reader.h"

namespace lutlib::io::box {

struct Born {
    int socket;
    pid_t process;
};

/// Starts the nursery when it is not there. From any thread. Throws Error.
Born new_reader(const Foreign& library, const Allowance& allowance);

/// How a reader ended, as waitpid() says it. Waits for its end.
int end_of(const Foreign& library, pid_t reader);

} // namespace lutlib::io::box
