// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include "core/contour/forearm.h"
#include "core/geometry/camera.h"
#include "core/hand/skinned_surface.h"

namespace core {

/// A point of the rim: on the edge (vertexA, vertexB) of one hand's surface where the normal turns from towards the
/// camera to away from it.
struct RimPoint {
    int hand = 0;
    int vertexA = 0;
    int vertexB = 0;
    float t = 0;              ///< position on the edge: (1 - t) A + t B
    Eigen::Vector3f point;    ///< in the world, mm; bulged between A and B along the normals' curvature
    Eigen::Vector3f normal;   ///< outward, in the world, unit
    Eigen::Vector2f px;       ///< its recorded pixel
    Eigen::Vector2f normalPx; ///< outward image normal, unit, y down
};

/// How a drawn silhouette and an observed mask compare, areas in px^2.
struct SilhouetteComparison {
    double differencePx2 = 0; ///< where they disagree
    double deepPx2 = 0;       ///< the part of it where the mask is sure
    double unionPx2 = 0;      ///< where either is foreground
};

/// Silhouette of the union of surfaces at reduced resolution, for asking whether a pixel is covered.
class CoverageMask {
public:
    /// Forgets everything; from now on stands for the rectangle [minPx, maxPx] in cells of cellPx image pixels.
    void reset(const Eigen::Vector2f& minPx, const Eigen::Vector2f& maxPx, float cellPx);
    /// Adds one triangle given by image pixels.
    void add(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c);
    /// True if the cell under the pixel is covered; false outside.
    bool covers(const Eigen::Vector2f& px) const;
    /// Compares the coverage with a mask (CV_8U), sampled at the cells' centres. What lies in an `ignored` region does
    /// not count. unsure: CV_8U of the mask's size, not 0 where the mask may be wrong (near its outline); empty if it
    /// is sure everywhere.
    SilhouetteComparison compare(const cv::Mat& mask, const cv::Mat& unsure,
                                 std::span<const ConvexRegion> ignored = {}) const;
    int width() const { return m_width; }
    int height() const { return m_height; }

private:
    /// isIgnored: one per column of the row; left empty where nothing is ignored.
    void markIgnored(int row, std::span<const ConvexRegion> ignored, std::vector<unsigned char>& isIgnored) const;

    float m_cellPx = 1;
    Eigen::Vector2f m_originPx = Eigen::Vector2f::Zero();
    int m_width = 0;
    int m_height = 0;
    std::vector<unsigned char> m_cells;
};

/// One hand, posed: the fine level gives the rim, the coarse one the coverage.
struct RimSource {
    const SkinnedSurface* rimSurface;
    const PosedPoints* rimPoints;
    const SkinnedSurface* coverSurface;
    const PosedPoints* coverPoints;
};

struct RimOptions {
    float cellPx = 2;       ///< resolution of the coverage
    float outwardPx = 2.5f; ///< a rim point is on the outline if the pixel this far outside it is not covered
    int maxPoints = 300;    ///< per camera; more are thinned evenly
};

/// Scratch memory that is reused from call to call; one per thread.
struct RimScratch {
    CoverageMask coverage;
    std::vector<float> facing;
    std::vector<Eigen::Vector2f> px;
    std::vector<RimPoint> candidates;
};

/// Compares the hands' silhouette (of their coverage level, in cells of options.cellPx) with an observed mask, outside
/// the `ignored` regions; maskBounds holds all of the mask's foreground. unsure: see CoverageMask::compare.
SilhouetteComparison compareSilhouettes(const Camera& camera, const std::vector<RimSource>& hands,
                                        const RimOptions& options, const cv::Mat& mask, const cv::Mat& unsure,
                                        const cv::Rect& maskBounds, RimScratch& scratch,
                                        std::span<const ConvexRegion> ignored = {});

/// The visible outer rim of the union of all hands as seen by `camera`: no interior creases, no rim hidden by another
/// hand, no points outside the image. Deterministic. (method: P(theta, c))
void visibleRim(const Camera& camera, const std::vector<RimSource>& hands, const RimOptions& options,
                RimScratch& scratch, std::vector<RimPoint>& rim);

} // namespace core
