#include "preview/graph/fingerprint.h"

#include "preview/graph/shape.h"

#include <map>

namespace preview {

namespace {

class Fingerprint {
  public:
    explicit Fingerprint(const Graph& graph)
        : graph_(graph), leads_(graph.passes().size(), false) {}

    std::string of(std::uint32_t version) {
        follow(version);
        add_place(version);
        for (std::size_t pass = 0; pass < leads_.size(); ++pass) {
            if (leads_[pass]) {
                add_pass(graph_.passes()[pass]);
            }
        }
        return text_.take();
    }

  private:
    /// Marks the passes that lead to a version.
    void follow(std::uint32_t version) {
        if (version == Version::none) {
            return;
        }
        const std::uint32_t producer = graph_.versions()[version].producer;
        if (producer == Version::none || leads_[producer]) {
            return;
        }
        leads_[producer] = true;
        for (const Use& use : graph_.passes()[producer].uses) {
            follow(use.writes ? graph_.versions()[use.version].previous : use.version);
        }
    }

    /// Resources by the order of their first appearance; what comes from outside by what it is.
    void add_place(std::uint32_t version) {
        if (version == Version::none) {
            text_.add(Version::none);
            return;
        }
        const std::uint32_t resource_index = graph_.versions()[version].resource;
        const auto [known, is_new] =
            numbers_.emplace(resource_index, static_cast<std::uint32_t>(numbers_.size()));
        text_.add(known->second);
        if (!is_new) {
            return;
        }
        const Resource& resource = graph_.resources()[resource_index];
        add_resource(text_, resource);
        text_.add_text({reinterpret_cast<const char*>(resource.data.data()), resource.data.size()});
    }

    void add_use(const Use& use) {
        add_place(use.version);
        add_binding(text_, use);
        text_.add(use.clears);
        for (const float value : use.clear) {
            text_.add(value);
        }
    }

    void add_pass(const PassRecord& pass) {
        text_.add(pass.kind);
        text_.add_text(pass.shader);
        text_.add_text(pass.fragment_shader);
        text_.add(pass.uses.size());
        for (const Use& use : pass.uses) {
            add_use(use);
        }
        text_.add(pass.constants.size());
        for (const std::uint32_t word : pass.constants) {
            text_.add(word);
        }
        text_.add_text({reinterpret_cast<const char*>(pass.push.data()), pass.push_bytes});
        for (const std::uint32_t count : pass.groups) {
            text_.add(count);
        }
        text_.add(pass.indirect_use);
        add_raster_state(text_, pass.raster);
        text_.add(pass.draws.size());
        for (const Draw& draw : pass.draws) {
            text_.add(draw);
        }
        text_.add(pass.fill_value);
    }

    const Graph& graph_;
    std::vector<bool> leads_; ///< by pass
    std::map<std::uint32_t, std::uint32_t> numbers_;
    ByteText text_;
};

} // namespace

std::string fingerprint_of(const Graph& graph, std::uint32_t version) {
    return Fingerprint(graph).of(version);
}

} // namespace preview
