#include "lutlib/io/picture_channels.h"

#include "lutlib/error.h"
#include "lutlib/named.h"
#include "lutlib/text.h"

#include <algorithm>

namespace lutlib::io {
namespace {

struct Name {
    std::string layer, channel; ///< the channel in upper case
};

Name split(const std::string& name) {
    const std::size_t point = name.rfind('.');
    return point == std::string::npos ? Name{"", upper(name)}
                                      : Name{name.substr(0, point), upper(name.substr(point + 1))};
}

struct Spelling {
    std::string_view letter, word;
};
constexpr std::array<Spelling, 4> spellings{
    {{"R", "RED"}, {"G", "GREEN"}, {"B", "BLUE"}, {"A", "ALPHA"}}};
// Of one grey value a pixel; OpenEXR's luminance, and what other types call it.
constexpr std::array<std::string_view, 5> greys{"Y", "I", "L", "GRAY", "GREY"};

int channel_of(const PicturePart& part, const std::string& layer, const Spelling& spelling) {
    for (std::size_t i = 0; i < part.channels.size(); ++i) {
        const Name name = split(part.channels[i]);
        if (name.layer == layer &&
            (name.channel == spelling.letter || name.channel == spelling.word)) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

int grey_of(const PicturePart& part, const std::string& layer, const std::string& file) {
    for (const std::string_view grey : greys) {
        const int at = channel_of(part, layer, {grey, grey});
        if (at < 0) {
            continue;
        }
        if (channel_of(part, layer, {"RY", "RY"}) >= 0) {
            throw Error("the picture stores luminance and chroma (Y, RY, BY), which are not read; "
                        "save it as R, G, B",
                        {file, 0, {}});
        }
        return at;
    }
    return -1;
}

/// Red, green or blue by itself: what a program keeps that saves one channel of a picture.
bool is_one_color(const PicturePart& part, int at) {
    const std::string name = split(part.channels[static_cast<std::size_t>(at)]).channel;
    return std::any_of(spellings.begin(), spellings.begin() + 3, [&](const Spelling& color) {
        return name == color.letter || name == color.word;
    });
}

int only_color_of(const std::array<int, 4>& found) {
    const auto there =
        std::count_if(found.begin(), found.begin() + 3, [](int at) { return at >= 0; });
    return there == 1 ? std::max({found[0], found[1], found[2]}) : -1;
}

std::vector<std::string> layers_of(const PicturePart& part) {
    std::vector<std::string> out;
    for (const std::string& channel : part.channels) {
        const std::string layer = split(channel).layer;
        if (std::find(out.begin(), out.end(), layer) == out.end()) {
            out.push_back(layer);
        }
    }
    return out;
}

PictureChannels by_place(const PicturePart& part) {
    const int count = static_cast<int>(part.channels.size());
    PictureChannels out;
    out.at = count < 3 ? std::array{0, 0, 0, -1} : std::array{0, 1, 2, -1};
    out.at[3] = part.alpha;
    return out;
}

// Smaller is taken sooner.
int rank(const PictureChannels& picture) {
    if (picture.layer.empty()) {
        return picture.grey() ? 2 : 0;
    }
    const std::string last = split(picture.layer).channel;
    const bool is_beauty =
        last == "COMBINED" || last == "BEAUTY" || last == "RGBA" || last == "RGB";
    return picture.grey() ? 4 : is_beauty ? 1 : 3;
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) {
        out += (out.empty() ? "" : ", ") + word;
    }
    return out;
}

} // namespace

std::vector<PictureChannels> pictures_among(const std::vector<PicturePart>& parts,
                                            const std::string& file) {
    std::vector<PictureChannels> out;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const PicturePart& part = parts[p];
        const std::size_t before = out.size();
        for (const std::string& layer : layers_of(part)) {
            PictureChannels found{p, layer};
            for (std::size_t c = 0; c < 4; ++c) {
                found.at[c] = channel_of(part, layer, spellings[c]);
            }
            if (found.at[0] < 0 || found.at[1] < 0 || found.at[2] < 0) {
                const int named = grey_of(part, layer, file);
                const int grey = named >= 0 ? named : only_color_of(found.at);
                found.at = {grey, grey, grey, found.at[3]};
            }
            if (found.at[0] >= 0) {
                out.push_back(std::move(found));
            }
        }
        if (out.size() == before && part.by_place && !part.channels.empty()) {
            out.push_back(by_place(part));
            out.back().part = p;
        }
    }
    std::stable_sort(
        out.begin(), out.end(),
        [](const PictureChannels& a, const PictureChannels& b) { return rank(a) < rank(b); });
    return out;
}

std::string layer_name(const PictureChannels& picture, const std::vector<PicturePart>& parts) {
    return picture.layer.empty() ? parts[picture.part].name : picture.layer;
}

const PictureChannels& require_picture(const std::vector<PictureChannels>& pictures,
                                       const std::vector<PicturePart>& parts,
                                       std::string_view layer, const std::string& file) {
    if (pictures.empty()) {
        std::vector<std::string> channels;
        for (const PicturePart& part : parts) {
            channels.insert(channels.end(), part.channels.begin(), part.channels.end());
        }
        throw Error("no channels R, G, B or Y; the file has " + joined(channels), {file, 0, {}});
    }
    if (layer.empty()) {
        return pictures.front();
    }
    std::vector<std::string> names;
    for (const PictureChannels& picture : pictures) {
        names.push_back(layer_name(picture, parts));
        if (upper(names.back()) == upper(layer)) {
            return picture;
        }
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    throw Error(no_such_name("layer", layer, views), {file, 0, {}});
}

std::vector<std::string> channel_remarks(const PictureChannels& taken,
                                         const std::vector<PictureChannels>& pictures,
                                         const std::vector<PicturePart>& parts) {
    std::vector<std::string> out;
    std::vector<std::string> others;
    for (const PictureChannels& picture : pictures) {
        if (picture.part != taken.part || picture.layer != taken.layer) {
            const std::string name = layer_name(picture, parts);
            others.push_back(name.empty() ? "part " + std::to_string(picture.part + 1) : name);
        }
    }
    if (taken.grey() && is_one_color(parts[taken.part], taken.at[0])) {
        out.push_back("the picture is taken to be grey: of R, G and B there is only the channel '" +
                      parts[taken.part].channels[static_cast<std::size_t>(taken.at[0])] + "'");
    }
    const std::string name = layer_name(taken, parts);
    if (!others.empty() || !taken.layer.empty()) {
        out.push_back("the picture is taken to be " +
                      (name.empty() ? std::string("the channels R, G, B") : "'" + name + "'") +
                      (others.empty() ? ""
                                      : "; also there, not graded: " + joined(others) +
                                            " (--layer grades another)"));
    }
    return out;
}

} // namespace lutlib::io
