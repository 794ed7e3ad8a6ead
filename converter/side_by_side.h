// Pieces of work that are many and whose memory is not small.
#pragma once

#include <cstddef>
#include <functional>

namespace converter {

/// Does `work` for each number below `count`, at most `at_once` of them (one at least) at the same
/// time, in no order; the cores that are left over help with what each does in parallel. All are
/// done, whatever some throw; then what the lowest number threw is thrown.
void do_side_by_side(std::size_t count, std::size_t at_once,
                     const std::function<void(std::size_t)>& work);

/// As many pieces of work as there are cores, and as have room in a gigabyte; one at least.
std::size_t pieces_at_once(std::size_t bytes_each);

} // namespace converter
