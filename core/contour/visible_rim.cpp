// SPDX-License-Identifier: MIT
#include "core/contour/visible_rim.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/lens_model.h"

namespace core {

void CoverageMask::reset(const Eigen::Vector2f& minPx, const Eigen::Vector2f& maxPx, float cellPx) {
    m_cellPx = cellPx;
    m_originPx = minPx;
    m_width = std::max(0, static_cast<int>(std::ceil((maxPx.x() - minPx.x()) / m_cellPx)) + 1);
    m_height = std::max(0, static_cast<int>(std::ceil((maxPx.y() - minPx.y()) / m_cellPx)) + 1);
    m_cells.assign(static_cast<std::size_t>(m_width) * m_height, 0);
}

void CoverageMask::add(const Eigen::Vector2f& a, const Eigen::Vector2f& b, const Eigen::Vector2f& c) {
    const float scale = 1.0f / m_cellPx;
    std::array<Eigen::Vector2f, 3> p{(a - m_originPx) * scale, (b - m_originPx) * scale, (c - m_originPx) * scale};
    const auto order = [&](int u, int v) {
        if (p[v].y() < p[u].y())
            std::swap(p[u], p[v]);
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    const int y0 = std::max(0, static_cast<int>(std::ceil(p[0].y())));
    const int y1 = std::min(m_height - 1, static_cast<int>(std::floor(p[2].y())));
    const auto slope = [](const Eigen::Vector2f& from, const Eigen::Vector2f& to) {
        return to.y() > from.y() ? (to.x() - from.x()) / (to.y() - from.y()) : 0.0f;
    };
    const float longSlope = slope(p[0], p[2]), upperSlope = slope(p[0], p[1]), lowerSlope = slope(p[1], p[2]);
    for (int y = y0; y <= y1; ++y) {
        const float row = static_cast<float>(y);
        const float xLong = p[0].x() + (row - p[0].y()) * longSlope;
        const float xShort =
            row < p[1].y() ? p[0].x() + (row - p[0].y()) * upperSlope : p[1].x() + (row - p[1].y()) * lowerSlope;
        const int x0 = std::max(0, static_cast<int>(std::ceil(std::min(xLong, xShort))));
        const int x1 = std::min(m_width - 1, static_cast<int>(std::floor(std::max(xLong, xShort))));
        unsigned char* cells = m_cells.data() + static_cast<std::size_t>(y) * m_width;
        for (int x = x0; x <= x1; ++x)
            cells[x] = 1;
    }
}

bool CoverageMask::covers(const Eigen::Vector2f& px) const {
    const int x = static_cast<int>(std::lround((px.x() - m_originPx.x()) / m_cellPx));
    const int y = static_cast<int>(std::lround((px.y() - m_originPx.y()) / m_cellPx));
    if (x < 0 || y < 0 || x >= m_width || y >= m_height)
        return false;
    return m_cells[static_cast<std::size_t>(y) * m_width + x] != 0;
}

void CoverageMask::markIgnored(int row, std::span<const ConvexRegion> ignored,
                               std::vector<unsigned char>& isIgnored) const {
    if (ignored.empty())
        return;
    isIgnored.assign(static_cast<std::size_t>(m_width), 0);
    for (const ConvexRegion& region : ignored) {
        const auto span = region.span(m_originPx.y() + static_cast<float>(row) * m_cellPx);
        if (!span)
            continue;
        const int first = std::max(0, static_cast<int>(std::ceil((span->first - m_originPx.x()) / m_cellPx)));
        const int last =
            std::min(m_width - 1, static_cast<int>(std::floor((span->second - m_originPx.x()) / m_cellPx)));
        for (int column = first; column <= last; ++column)
            isIgnored[static_cast<std::size_t>(column)] = 1;
    }
}

SilhouetteComparison CoverageMask::compare(const cv::Mat& mask, const cv::Mat& unsure,
                                           std::span<const ConvexRegion> ignored) const {
    std::size_t different = 0, deep = 0, either = 0;
    std::vector<unsigned char> isIgnored;
    for (int row = 0; row < m_height; ++row) {
        const long y = std::lround(m_originPx.y() + static_cast<float>(row) * m_cellPx);
        if (y < 0 || y >= mask.rows)
            continue;
        const auto* observed = mask.ptr<unsigned char>(static_cast<int>(y));
        const auto* isUnsure = unsure.empty() ? nullptr : unsure.ptr<unsigned char>(static_cast<int>(y));
        const unsigned char* drawn = m_cells.data() + static_cast<std::size_t>(row) * m_width;
        markIgnored(row, ignored, isIgnored);
        for (int column = 0; column < m_width; ++column) {
            const long x = std::lround(m_originPx.x() + static_cast<float>(column) * m_cellPx);
            if (x < 0 || x >= mask.cols || (!isIgnored.empty() && isIgnored[static_cast<std::size_t>(column)] != 0))
                continue;
            const bool isObserved = observed[x] != 0, isDrawn = drawn[column] != 0;
            either += isObserved || isDrawn;
            different += isObserved != isDrawn;
            deep += isObserved != isDrawn && (!isUnsure || isUnsure[x] == 0);
        }
    }
    const auto cellPx2 = static_cast<double>(m_cellPx * m_cellPx);
    return {static_cast<double>(different) * cellPx2, static_cast<double>(deep) * cellPx2,
            static_cast<double>(either) * cellPx2};
}

namespace {

/// The camera in single precision, and its lens where it has one.
struct FastCamera {
    explicit FastCamera(const Camera& c)
        : camera(c)
        , rotation(c.cameraFromWorld.rotation.cast<float>())
        , translation(c.cameraFromWorld.translation.cast<float>())
        , centre(c.centreInWorld().cast<float>())
        , intrinsics(c.intrinsics.cast<float>())
        , hasLens(c.hasLens())
        , lens(c.distortion, c.fisheye) {}

    Eigen::Vector2f project(const Eigen::Vector3f& world) const {
        const Eigen::Vector3f p = rotation * world + translation;
        Eigen::Vector2f n = p.head<2>() / std::max(p.z(), 1.0f);
        if (hasLens)
            n = lens.distort(n.cast<double>()).cast<float>();
        return {intrinsics(0, 0) * n.x() + intrinsics(0, 1) * n.y() + intrinsics(0, 2),
                intrinsics(1, 1) * n.y() + intrinsics(1, 2)};
    }

    /// False beyond the fold of the lens model, where a point would be shown mirrored.
    bool holdsAt(const Eigen::Vector3f& world) const {
        const Eigen::Vector3f p = rotation * world + translation;
        return lens.holds((p.head<2>() / std::max(p.z(), 1.0f)).cast<double>());
    }

    /// Image normal at a rim point: the camera-frame normal over the focal lengths, carried through the lens by the
    /// inverse transpose of its Jacobian.
    Eigen::Vector2f imageNormal(const Eigen::Vector3f& world, const Eigen::Vector3f& normal) const {
        const Eigen::Vector3f n = rotation * normal;
        Eigen::Vector2f m = n.head<2>();
        if (hasLens) {
            const Eigen::Vector3f p = rotation * world + translation;
            Eigen::Matrix2d jacobian;
            lens.distort((p.head<2>() / std::max(p.z(), 1.0f)).cast<double>(), &jacobian);
            const Eigen::Matrix2f j = jacobian.cast<float>();
            const float det = j.determinant();
            m = Eigen::Vector2f(j(1, 1) * m.x() - j(1, 0) * m.y(), -j(0, 1) * m.x() + j(0, 0) * m.y()) / det;
        }
        return Eigen::Vector2f(m.x() / intrinsics(0, 0),
                               (m.y() - m.x() * intrinsics(0, 1) / intrinsics(0, 0)) / intrinsics(1, 1))
            .normalized();
    }

    const Camera& camera;
    Eigen::Matrix3f rotation;
    Eigen::Vector3f translation;
    Eigen::Vector3f centre;
    Eigen::Matrix3f intrinsics;
    bool hasLens;
    LensModel lens;
};

/// `alsoPx`: a rectangle of the image that the coverage must stand for, too.
void drawCoverage(const FastCamera& camera, const std::vector<RimSource>& hands, float cellPx, const cv::Rect& alsoPx,
                  RimScratch& scratch) {
    std::size_t count = 0;
    for (const RimSource& hand : hands)
        count += hand.coverPoints->positions.size();
    scratch.px.resize(count);
    Eigen::Vector2f low(1e9f, 1e9f), high(-1e9f, -1e9f);
    if (!alsoPx.empty()) {
        low = {static_cast<float>(alsoPx.x), static_cast<float>(alsoPx.y)};
        high = {static_cast<float>(alsoPx.br().x), static_cast<float>(alsoPx.br().y)};
    }
    std::size_t i = 0;
    for (const RimSource& hand : hands) {
        for (const Eigen::Vector3f& p : hand.coverPoints->positions) {
            scratch.px[i] = camera.project(p);
            low = low.cwiseMin(scratch.px[i]);
            high = high.cwiseMax(scratch.px[i]);
            ++i;
        }
    }
    const Eigen::Vector2f size(static_cast<float>(camera.camera.size.width),
                               static_cast<float>(camera.camera.size.height));
    const Eigen::Vector2f margin(8, 8);
    low = low.cwiseMax(-margin);
    high = high.cwiseMin(size + margin);
    scratch.coverage.reset(low, high, cellPx);
    std::size_t offset = 0;
    for (const RimSource& hand : hands) {
        for (const auto& [a, b, c] : hand.coverSurface->triangles) {
            const Eigen::Vector2f &pa = scratch.px[offset + a], &pb = scratch.px[offset + b],
                                  &pc = scratch.px[offset + c];
            const float area = (pb.x() - pa.x()) * (pc.y() - pa.y()) - (pb.y() - pa.y()) * (pc.x() - pa.x());
            if (area < 0) // faces the camera (y down)
                scratch.coverage.add(pa, pb, pc);
        }
        offset += hand.coverPoints->positions.size();
    }
}

/// The point of the edge where the normal is perpendicular to the view, lifted off the chord towards the tangent planes
/// of both ends (Phong tessellation with weight 3/4, Boubekeur and Alexa 2008): a coarse level then keeps the rim of
/// the fine one.
RimPoint crossing(const PosedPoints& points, int hand, int a, int b, float t) {
    constexpr float kBulge = 0.75f;
    RimPoint rim;
    rim.hand = hand;
    rim.vertexA = a;
    rim.vertexB = b;
    rim.t = t;
    const Eigen::Vector3f &pa = points.positions[a], &pb = points.positions[b];
    const Eigen::Vector3f &na = points.normals[a], &nb = points.normals[b];
    const Eigen::Vector3f chord = pa + t * (pb - pa);
    const Eigen::Vector3f fromA = ((chord - pa).dot(na) / na.squaredNorm()) * na;
    const Eigen::Vector3f fromB = ((chord - pb).dot(nb) / nb.squaredNorm()) * nb;
    rim.point = chord - kBulge * ((1 - t) * fromA + t * fromB);
    rim.normal = (na + t * (nb - na)).normalized();
    return rim;
}

void collectCandidates(const FastCamera& camera, const RimSource& source, int hand, float outwardPx,
                       RimScratch& scratch) {
    const PosedPoints& points = *source.rimPoints;
    const std::size_t count = points.positions.size();
    scratch.facing.resize(count);
    for (std::size_t v = 0; v < count; ++v)
        scratch.facing[v] = points.normals[v].dot(points.positions[v] - camera.centre);
    const float right = static_cast<float>(camera.camera.size.width) - 1.5f;
    const float bottom = static_cast<float>(camera.camera.size.height) - 1.5f;
    for (const auto& [a, b] : source.rimSurface->edges) {
        const float fa = scratch.facing[a], fb = scratch.facing[b];
        if ((fa < 0) == (fb < 0))
            continue;
        RimPoint rim = crossing(points, hand, a, b, fa / (fa - fb));
        rim.px = camera.project(rim.point);
        if (rim.px.x() < 0.5f || rim.px.y() < 0.5f || rim.px.x() > right || rim.px.y() > bottom)
            continue;
        if (camera.hasLens && !camera.holdsAt(rim.point))
            continue;
        rim.normalPx = camera.imageNormal(rim.point, rim.normal);
        if (!scratch.coverage.covers(rim.px + outwardPx * rim.normalPx))
            scratch.candidates.push_back(rim);
    }
}

} // namespace

SilhouetteComparison compareSilhouettes(const Camera& camera, const std::vector<RimSource>& hands,
                                        const RimOptions& options, const cv::Mat& mask, const cv::Mat& unsure,
                                        const cv::Rect& maskBounds, RimScratch& scratch,
                                        std::span<const ConvexRegion> ignored) {
    drawCoverage(FastCamera(camera), hands, options.cellPx, maskBounds, scratch);
    return scratch.coverage.compare(mask, unsure, ignored);
}

void visibleRim(const Camera& camera, const std::vector<RimSource>& hands, const RimOptions& options,
                RimScratch& scratch, std::vector<RimPoint>& rim) {
    const FastCamera fast(camera);
    drawCoverage(fast, hands, options.cellPx, {}, scratch);
    scratch.candidates.clear();
    for (std::size_t h = 0; h < hands.size(); ++h)
        collectCandidates(fast, hands[h], static_cast<int>(h), options.outwardPx, scratch);
    rim.clear();
    const std::size_t found = scratch.candidates.size();
    const std::size_t wanted = std::min<std::size_t>(found, static_cast<std::size_t>(options.maxPoints));
    for (std::size_t i = 0; i < wanted; ++i)
        rim.push_back(scratch.candidates[i * found / wanted]);
}

} // namespace core
