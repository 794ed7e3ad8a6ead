// Walking over the nodes of a lattice.
#pragma once

namespace lutlib {

/// visit(r, g, b) for every node of a lattice of so many nodes per axis, in their order in memory:
/// red fastest.
template <class F>
void for_each_node(int size, F&& visit) {
    for (int b = 0; b < size; ++b) {
        for (int g = 0; g < size; ++g) {
            for (int r = 0; r < size; ++r) {
                visit(r, g, b);
            }
        }
    }
}

} // namespace lutlib
