// Accessors: typed elements in buffers, some of them replaced by sparse ones. glTF 2.0, 3.6.2.
#include "preview/scene/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace preview {

namespace {

using nlohmann::json;

struct ComponentType {
    std::size_t number, bytes;
    float largest; ///< stands for 1 when normalized; 0: a float
    double (*read)(const char* at);
};

template <class T>
double read_as(const char* at) {
    T value{};
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

constexpr ComponentType component_types[] = {
    {5120, 1, 127, read_as<std::int8_t>},
    {5121, 1, 255, read_as<std::uint8_t>},
    {5122, 2, 32767, read_as<std::int16_t>},
    {5123, 2, 65535, read_as<std::uint16_t>},
    {5125, 4, 4294967295.0F, read_as<std::uint32_t>},
    {5126, 4, 0, read_as<float>},
};

struct ElementType {
    std::string_view name;
    std::size_t components;
};
constexpr ElementType element_types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4},
                                         {"MAT2", 4},   {"MAT3", 9}, {"MAT4", 16}};

const ComponentType& component_type(const GltfFile& file, const json& object) {
    const std::size_t number = file.count(object, "componentType", 0);
    for (const ComponentType& row : component_types) {
        if (row.number == number) {
            return row;
        }
    }
    file.refuse("an accessor has no known componentType", std::to_string(number));
}

/// Elements that lie `stride` bytes apart.
struct Elements {
    std::string_view bytes;
    std::size_t stride = 0;
    const char* at(std::size_t index) const { return bytes.data() + index * stride; }
};

/// `count` elements of `size` bytes that the object's bufferView holds. `is_packed`: whatever the
/// view's stride says.
Elements elements(const GltfFile& file, const json& object, std::size_t count, std::size_t size,
                  bool is_packed) {
    const auto view = file.index(object, "bufferView", "bufferViews");
    if (!view || count == 0) {
        return {};
    }
    const std::string_view bytes = file.view_bytes(*view);
    const std::size_t stride =
        is_packed ? size : file.count(file.list("bufferViews")[*view], "byteStride", size);
    const std::size_t offset = file.count(object, "byteOffset", 0);
    if (stride < size || stride > 65'536 || offset > bytes.size() || size > bytes.size() - offset ||
        (bytes.size() - offset - size) / stride < count - 1) {
        file.refuse("an accessor reaches beyond its bufferView");
    }
    return {bytes.substr(offset), stride};
}

template <class T>
class Reader {
  public:
    Reader(const GltfFile& file, const json& accessor, std::size_t components)
        : file_(file), accessor_(accessor), components_(components),
          type_(component_type(file, accessor)),
          is_normalized_(accessor.value("normalized", json(false)) == json(true)) {}

    std::vector<T> run() {
        const std::size_t count = file_.count(accessor_, "count", 0);
        file_.spend(count);
        const std::size_t size = components_ * type_.bytes;
        const Elements given = elements(file_, accessor_, count, size, false);
        std::vector<T> out(count * components_);
        for (std::size_t i = 0; given.stride != 0 && i < count; ++i) {
            read(given.at(i), out.data() + i * components_);
        }
        if (accessor_.contains("sparse")) {
            replace(gltf_object(accessor_, "sparse"), count, out);
        }
        return out;
    }

  private:
    void read(const char* from, T* to) const {
        for (std::size_t c = 0; c < components_; ++c) {
            const double value = type_.read(from + c * type_.bytes);
            to[c] = static_cast<T>(is_normalized_ && type_.largest > 0
                                       ? std::max(value / static_cast<double>(type_.largest), -1.0)
                                       : value);
        }
    }

    void replace(const json& sparse, std::size_t whole, std::vector<T>& out) const {
        const std::size_t count = file_.count(sparse, "count", 0);
        const json& indices = gltf_object(sparse, "indices");
        const ComponentType& index_type = component_type(file_, indices);
        if (count > whole || index_type.largest == 0) {
            file_.refuse("a sparse accessor replaces more than there is, or by no index");
        }
        const Elements places = elements(file_, indices, count, index_type.bytes, true);
        const Elements values =
            elements(file_, gltf_object(sparse, "values"), count, components_ * type_.bytes, true);
        if (count > 0 && (places.stride == 0 || values.stride == 0)) {
            file_.refuse("a sparse accessor has no indices or values");
        }
        for (std::size_t i = 0; i < count; ++i) {
            const double place = index_type.read(places.at(i));
            if (!(place >= 0 && place < static_cast<double>(whole))) {
                file_.refuse("a sparse accessor replaces what does not exist");
            }
            read(values.at(i), out.data() + static_cast<std::size_t>(place) * components_);
        }
    }

    const GltfFile& file_;
    const json& accessor_;
    std::size_t components_;
    const ComponentType& type_;
    bool is_normalized_;
};

template <class T>
std::vector<T> read_accessor(const GltfFile& file, std::size_t index, std::size_t components) {
    if (gltf_components(file, index) != components) {
        file.refuse(fmt::format("an accessor is of type {}, which it cannot be there",
                                gltf_text(file.list("accessors")[index], "type")));
    }
    return Reader<T>(file, file.list("accessors")[index], components).run();
}

} // namespace

std::size_t gltf_components(const GltfFile& file, std::size_t accessor) {
    const std::string type = gltf_text(file.list("accessors")[accessor], "type");
    for (const ElementType& row : element_types) {
        if (type == row.name) {
            return row.components;
        }
    }
    file.refuse("an accessor has no known type", type);
}

std::vector<float> gltf_floats(const GltfFile& file, std::size_t accessor, std::size_t components) {
    return read_accessor<float>(file, accessor, components);
}

std::vector<std::uint32_t> gltf_words(const GltfFile& file, std::size_t accessor,
                                      std::size_t components) {
    const std::size_t type = file.count(file.list("accessors")[accessor], "componentType", 0);
    if (type != 5121 && type != 5123 && type != 5125) {
        file.refuse("an accessor is not of unsigned whole numbers", std::to_string(type));
    }
    return read_accessor<std::uint32_t>(file, accessor, components);
}

} // namespace preview
