// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "widgets/views/camera/mesh_layer.h"

namespace widgets {

/// How mesh layers are drawn, for all views.
struct LayerLook {
    MeshStyle style = MeshStyle::Shaded;
    double opacity = 0.35;
    bool leftShown = true;
    bool rightShown = true;
};

/// The layer as it is to be drawn; empty if none of its hands is shown.
std::optional<MeshLayer> withLook(MeshLayer layer, const LayerLook& look);

} // namespace widgets
