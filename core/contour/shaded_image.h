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
    const std::vector<Eigen::Vector3d>* normalsInWorld = nullptr; ///< unit, one per vertex; nullptr: computed here
    Eigen::Vector3f colour{0.85f, 0.64f, 0.53f};                  ///< RGB, sRGB encoded, 0..1
};

/// Lights of a shaded image. They travel with the camera, as a photographer's would, so that every view is well lit.
struct Lighting {
    Eigen::Vector3f keyInCamera{-0.45f, -0.65f, -0.61f};  ///< towards the light; y is down, z is away from the camera
    Eigen::Vector3f fillInCamera{0.80f, -0.10f, -0.59f};
    float ambient = 0.28f;
    float key = 0.62f;
    float fill = 0.22f;
    float rim = 0.25f; ///< brightening where the surface turns away
    float specular = 0.06f;
};

struct BackdropOptions {
    Eigen::Vector3f centre{0.235f, 0.245f, 0.26f}; ///< RGB behind the hands, sRGB encoded
    Eigen::Vector3f corner{0.10f, 0.105f, 0.115f};
};

/// Skin tones of the left and the right hand: alike, yet told apart.
Eigen::Vector3f skinColour(Side side);

/// A picture of smoothly shaded surfaces on a plain backdrop: CV_8UC3 BGR of the camera's size. Its silhouette is renderMask's, pixel for pixel.
/// Uses the calling thread only; several cameras may be drawn at once.
cv::Mat renderShaded(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const Lighting& lighting = {},
                     const BackdropOptions& backdrop = {});

/// The hands of a dataset in their poses, in skin tones: the image of views of kind "rendered".
cv::Mat renderHandsShaded(const Camera& camera, const std::vector<HandModel>& hands, const HandPoses& poses);

enum class OverlayStyle { Shaded, Wireframe };

struct OverlayOptions {
    OverlayStyle style = OverlayStyle::Shaded;
    float opacity = 0.35f;      ///< of the faces or wires
    bool silhouetteEdge = true; ///< the silhouette's outermost pixels at full strength
};

/// The surfaces alone, to be laid over an image: CV_8UC4 BGRA, premultiplied, transparent outside the silhouette (renderMask's).
cv::Mat renderOverlay(const Camera& camera, const std::vector<ShadedSurface>& surfaces, const OverlayOptions& options,
                      const Lighting& lighting = {});

} // namespace core
