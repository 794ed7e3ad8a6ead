#include "preview/frame/usual_finish.h"

#include "preview/finish/picture_settings.h"
#include "preview/scene/scene.h"

namespace preview {

UsualFinish usual_finish(std::string_view input) {
    const PictureSettings usual;
    UsualFinish out{usual.tonemap, usual.bloom};
    if (const SceneInfo* const info = scene_named(input)) {
        if (!info->tonemap.empty()) {
            out.tonemap = tonemap_named(info->tonemap);
        }
        out.is_antialiased = info->is_antialiased;
        if (!info->bloom.empty()) {
            out.bloom = bloom_named(info->bloom);
        }
    }
    return out;
}

} // namespace preview
