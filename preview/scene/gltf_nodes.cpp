// The tree of a glTF file's nodes.
#include "preview/scene/gltf_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace preview {

namespace {

using nlohmann::json;

constexpr std::size_t no_parent = SIZE_MAX;

bool is_usable(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(m[column][row]) < most_coordinate)) {
                return false;
            }
        }
    }
    return true;
}

glm::mat4 transform_of(const json& node) {
    float m[16];
    if (gltf_numbers(node, "matrix", m, 16)) {
        glm::mat4 out;
        for (int i = 0; i < 16; ++i) {
            out[i / 4][i % 4] = m[i];
        }
        return out;
    }
    float t[3] = {0, 0, 0}, r[4] = {0, 0, 0, 1}, s[3] = {1, 1, 1};
    gltf_numbers(node, "translation", t, 3);
    gltf_numbers(node, "rotation", r, 4);
    gltf_numbers(node, "scale", s, 3);
    glm::quat turn(r[3], r[0], r[1], r[2]);
    const float length = glm::length(turn);
    turn = length > 0 ? turn / length : glm::quat(1, 0, 0, 0);
    const glm::mat4 moved = glm::translate(glm::mat4(1), {t[0], t[1], t[2]});
    return glm::scale(moved * glm::mat4_cast(turn), {s[0], s[1], s[2]});
}

std::vector<std::size_t> children_of(const GltfFile& file, std::size_t node) {
    std::vector<std::size_t> out;
    const json& row = file.list("nodes")[node];
    const auto children = row.find("children");
    if (children == row.end()) {
        return out;
    }
    for (const json& child : *children) {
        if (!child.is_number_unsigned() || child.get<std::size_t>() >= file.list("nodes").size()) {
            file.refuse("a node names a child that does not exist");
        }
        out.push_back(child.get<std::size_t>());
    }
    return out;
}

/// Of each node; each has one at most.
std::vector<std::size_t> parents_of(const GltfFile& file) {
    const std::size_t count = file.list("nodes").size();
    if (count > import_limits.nodes) {
        file.refuse(fmt::format("it has {} nodes; the limit is {}", count, import_limits.nodes));
    }
    std::vector<std::size_t> parents(count, no_parent);
    for (std::size_t i = 0; i < count; ++i) {
        for (const std::size_t child : children_of(file, i)) {
            if (parents[child] != no_parent) {
                file.refuse("a node has two parents");
            }
            parents[child] = i;
        }
    }
    return parents;
}

} // namespace

std::vector<glm::mat4> gltf_places(const GltfFile& file, LeftOut& left_out) {
    const std::vector<std::size_t> parents = parents_of(file);
    std::vector<glm::mat4> own;
    for (const json& node : file.list("nodes")) {
        own.push_back(transform_of(node));
    }
    std::vector<glm::mat4> places;
    for (std::size_t i = 0; i < own.size(); ++i) {
        glm::mat4 place = own[i];
        int depth = 0;
        for (std::size_t at = parents[i]; at != no_parent; at = parents[at]) {
            if (++depth > import_limits.depth) {
                file.refuse(fmt::format("its node tree has a cycle, or is deeper than {}",
                                        import_limits.depth));
            }
            place = own[at] * place;
        }
        if (!is_usable(place)) {
            left_out.add("nodes whose transform is not finite");
            place = glm::mat4(0);
        }
        places.push_back(place);
    }
    return places;
}

std::vector<std::size_t> gltf_shown_nodes(const GltfFile& file) {
    const json& scenes = file.list("scenes");
    std::vector<std::size_t> open;
    if (scenes.empty()) {
        const std::vector<std::size_t> parents = parents_of(file);
        for (std::size_t i = 0; i < parents.size(); ++i) {
            if (parents[i] == no_parent) {
                open.push_back(i);
            }
        }
    } else {
        const std::size_t shown = file.index(file.root(), "scene", "scenes").value_or(0);
        for (const json& node : scenes[shown].value("nodes", json::array())) {
            if (!node.is_number_unsigned() ||
                node.get<std::size_t>() >= file.list("nodes").size()) {
                file.refuse("the scene names a node that does not exist");
            }
            open.push_back(node.get<std::size_t>());
        }
    }
    if (open.size() > import_limits.nodes) {
        file.refuse("the scene has more nodes than the limit");
    }
    std::reverse(open.begin(), open.end()); // the last is taken first
    std::vector<bool> is_shown(file.list("nodes").size());
    std::vector<std::size_t> shown;
    while (!open.empty()) {
        const std::size_t node = open.back();
        open.pop_back();
        if (is_shown[node]) {
            continue; // named twice
        }
        is_shown[node] = true;
        shown.push_back(node);
        std::vector<std::size_t> children = children_of(file, node);
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return shown;
}

void gltf_extensions(const json& object, const std::string& of,
                     std::initializer_list<std::string_view> known, LeftOut& left_out) {
    for (const auto& [name, unused] : gltf_object(object, "extensions").items()) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            left_out.add(of + " " + printable(name));
        }
    }
}

} // namespace preview
