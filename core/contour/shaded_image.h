// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/contour/rasteriser.h"

namespace core {

/// A surface with its colour and its vertex normals, ready to be shaded.
struct ShadedSurface {
    PosedSurface surface;
    const std::vector<Eigen::Vector3d>* normalsInWorld = nullptr; ///< unit, one per vertex, outward; needed
    Eigen::Vector3f colour{0.85f, 0.64f, 0.53f};                  ///< RGB, sRGB encoded, 0..1
    const std::vector<Eigen::Vector3f>* vertexColours = nullptr;  ///< one per vertex, instead of the colour
};

/// Lights of a shaded image, as strengths of 0..1. They travel with the camera, as a photographer's would, so that
/// every view is well lit. Directions point towards the light in the camera's frame: x right, y down, z away from the
/// camera.
struct Lighting {
    Eigen::Vector3f keyDirection{-0.50f, -0.62f, -0.60f};
    Eigen::Vector3f fillDirection{0.85f, 0.15f, -0.50f};
    float ambient = 0.20f;
    float key = 0.72f;
    float fill = 0.20f;
    float rim = 0.22f;      ///< brightening where the surface turns away
    float specular = 0.05f; ///< of the key light
    float warmth = 0.10f;   ///< how much light bleeds, reddened, past the shadow's edge, as in skin
    float tint = 1; ///< how far lights and shadows have colours of their own; 0: shades of the surface's colour alone
};

/// Even and colourless, for surfaces whose colour means something: what is lit has its own colour on average.
Lighting overlayLighting();

/// What lies behind the surfaces: a plain backdrop that darkens towards the corners. RGB, sRGB encoded, 0..1.
struct Backdrop {
    Eigen::Vector3f centre{0.235f, 0.245f, 0.260f};
    Eigen::Vector3f corner{0.095f, 0.100f, 0.110f};
};

/// Skin tone of a hand; left and right differ a little in hue so that they can be told apart.
Eigen::Vector3f skinColour(Side side);

/// A picture of smoothly shaded surfaces on the backdrop: CV_8UC3 BGR of the camera's size. Its silhouette is
/// renderMask's, pixel for pixel. Uses the calling thread only; several cameras may be drawn at once.
cv::Mat renderShaded(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const Lighting& lighting = {},
                     const Backdrop& backdrop = {});

/// The hands of a dataset in their poses, in skin tones: the image of views of kind "rendered".
cv::Mat renderHandsShaded(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses);

enum class OverlayStyle {
    Shaded,
    Wireframe ///< the edges of the visible triangles, one pixel wide
};

struct OverlayOptions {
    OverlayStyle style = OverlayStyle::Shaded;
    float opacity = 0.35f;      ///< of the faces or wires
    bool silhouetteEdge = true; ///< the outermost pixels of the silhouette in full strength
};

/// The surfaces alone, to be laid over an image: CV_8UC4 BGRA, premultiplied, transparent outside the silhouette
/// (renderMask's).
cv::Mat renderOverlay(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const OverlayOptions& options,
                      const Lighting& lighting = overlayLighting());

} // namespace core
