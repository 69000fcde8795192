// SPDX-License-Identifier: MIT
#include "core/fitting/fit_target.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "core/fitting/stopwatch.h"

namespace core {

namespace {

/// Around the outline: rim points are rarely farther out; those that are fall back to a search.
const cv::Point kTensorMargin(60, 60);

/// Points whose ray the lens model cannot give are dropped.
CameraTarget makeTarget(const Camera& camera, int index, const cv::Mat& mask, const cv::Rect& bounds,
                        const OrientedContour& found, const FitTargetOptions& options) {
    const Stopwatch watch;
    OrientedContour kept;
    std::vector<Eigen::Vector3d> directions;
    const Eigen::Matrix3d worldFromCamera = camera.cameraFromWorld.rotation.transpose();
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto normalised = undistort(camera, {found.x[i], found.y[i]});
        if (!normalised)
            continue;
        kept.x.push_back(found.x[i]);
        kept.y.push_back(found.y[i]);
        kept.angleRad.push_back(found.angleRad[i]);
        directions.push_back((worldFromCamera * normalised->homogeneous()).normalized());
    }
    ContourIndex searched = contourIndex(kept, options.bins, options.wholePixels);
    std::optional<Dt3Tensor> tensor;
    if (options.tensorLambdaPxPerRad >= 0) {
        const cv::Rect region =
            cv::Rect(bounds.tl() - kTensorMargin, bounds.br() + kTensorMargin) & cv::Rect(0, 0, mask.cols, mask.rows);
        tensor = computeDt3Tensor(kept, options.bins, options.tensorLambdaPxPerRad, region);
    }
    return {index,
            mask,
            bounds,
            std::move(kept),
            std::move(directions),
            camera.centreInWorld(),
            std::move(searched),
            std::move(tensor),
            false,
            0,
            watch.seconds()};
}

constexpr std::size_t kLeastSpeckPx = 4, kMostSpeckPx = 39; ///< length of a speck's outline
constexpr double kSpecksPerMask = 8;

template <typename Work>
void forEachOf(const std::vector<Camera>& cameras, int threads, Work&& work) {
    tbb::task_arena(threads).execute([&] { tbb::parallel_for(std::size_t{0}, cameras.size(), work); });
}

} // namespace

bool isSpeckled(const std::vector<std::vector<PixelChain>>& outlinesPerMask) {
    std::size_t masks = 0, specks = 0;
    for (const std::vector<PixelChain>& outlines : outlinesPerMask) {
        masks += outlines.empty() ? 0 : 1;
        for (const PixelChain& outline : outlines)
            specks += outline.size() >= kLeastSpeckPx && outline.size() <= kMostSpeckPx ? 1 : 0;
    }
    return static_cast<double>(specks) > kSpecksPerMask * static_cast<double>(masks);
}

ContourIndex contourIndex(const OrientedContour& contour, const OrientationBins& bins, bool wholePixels) {
    if (!wholePixels)
        return {contour, bins};
    OrientedContour searched = contour;
    for (std::size_t i = 0; i < searched.size(); ++i) {
        searched.x[i] = std::round(searched.x[i]);
        searched.y[i] = std::round(searched.y[i]);
    }
    return {searched, bins};
}

std::vector<CameraTarget> makeFitTargets(const std::vector<Camera>& cameras, const std::vector<cv::Mat>& masks,
                                         const FitTargetOptions& options, int threads) {
    std::vector<cv::Rect> bounds(cameras.size());
    std::vector<std::vector<PixelChain>> outlines(cameras.size());
    std::vector<double> seconds(cameras.size());
    forEachOf(cameras, threads, [&](std::size_t c) {
        const Stopwatch watch;
        bounds[c] = maskBounds(masks[c]);
        outlines[c] = maskOutlines(masks[c], bounds[c]);
        seconds[c] = watch.seconds();
    });
    const bool speckled = options.withoutSpecks && isSpeckled(outlines);
    ContourOptions contourOptions = options.contour;
    if (speckled)
        contourOptions.minLengthPx = std::max(contourOptions.minLengthPx, static_cast<int>(kMostSpeckPx) + 1);
    std::vector<std::optional<CameraTarget>> made(cameras.size());
    forEachOf(cameras, threads, [&](std::size_t c) {
        const Stopwatch watch;
        const OrientedContour contour = orientedContour(outlines[c], masks[c].size(), contourOptions);
        seconds[c] += watch.seconds();
        if (!contour.empty()) {
            made[c] = makeTarget(cameras[c], static_cast<int>(c), masks[c], bounds[c], contour, options);
            made[c]->secondsContour = seconds[c];
            made[c]->isSpeckled = speckled;
        }
    });
    std::vector<CameraTarget> targets;
    for (auto& target : made)
        if (target)
            targets.push_back(std::move(*target));
    return targets;
}

} // namespace core
