// SPDX-License-Identifier: MIT
#include "widgets/presenters/layer_look.h"

namespace widgets {

std::optional<MeshLayer> withLook(MeshLayer layer, const LayerLook& look) {
    std::erase_if(layer.surfaces, [&](const ViewSurfacePtr& surface) {
        return surface->side == core::Side::Left ? !look.leftShown : !look.rightShown;
    });
    layer.style = look.style;
    layer.opacity = look.opacity;
    return layer.surfaces.empty() ? std::nullopt : std::optional(std::move(layer));
}

} // namespace widgets
