// SPDX-License-Identifier: MIT
#include "core/distance/dt3_tensor.h"

#include <cmath>

#include "core/distance/envelope.h"
#include "core/distance/grid_sites.h"
#include "core/error.h"

namespace core {

namespace {

/// Costs and argmins of one image row for all bins: bins x cols, row-major.
class BinRows {
public:
    BinRows(int binCount, int cols)
        : m_bins(binCount)
        , m_cols(static_cast<std::size_t>(cols))
        , m_cost(m_cols * static_cast<std::size_t>(binCount))
        , m_index(m_cost.size()) {}

    float* cost(int bin) { return m_cost.data() + static_cast<std::size_t>(bin) * m_cols; }
    int* index(int bin) { return m_index.data() + static_cast<std::size_t>(bin) * m_cols; }

    /// 1.5 laps forward and 1.5 back around the circle of bins, `step` px from bin to bin.
    void relax(float step) {
        const int steps = m_bins + (m_bins + 1) / 2;
        for (int i = 1; i <= steps; ++i)
            offer((i - 1) % m_bins, i % m_bins, step);
        for (int i = steps; i >= 1; --i)
            offer(i % m_bins, (i - 1) % m_bins, step);
    }

private:
    /// Lets the bin `to` take over what `from` has, where that is cheaper.
    void offer(int from, int to, float step) {
        const float* fromCost = cost(from);
        const int* fromIndex = index(from);
        float* toCost = cost(to);
        int* toIndex = index(to);
        for (std::size_t x = 0; x < m_cols; ++x) {
            const float offered = fromCost[x] + step;
            const bool take = offered < toCost[x];
            toCost[x] = take ? offered : toCost[x];
            toIndex[x] = take ? fromIndex[x] : toIndex[x];
        }
    }

    int m_bins;
    std::size_t m_cols;
    std::vector<float> m_cost;
    std::vector<int> m_index;
};

std::vector<ColumnDistances> columnsByBin(const OrientedContour& contour, const OrientationBins& bins,
                                          const cv::Rect& region) {
    std::vector<ColumnDistances> columns;
    for (const std::vector<GridSite>& sites : gridSitesByBin(contour, bins, region))
        columns.push_back(nearestInColumns(sites, region.size()));
    return columns;
}

void storeRow(BinRows& rows, int row, Dt3Tensor& tensor) {
    for (int bin = 0; bin < tensor.bins.count(); ++bin) {
        const int* index = rows.index(bin);
        std::uint16_t* out = tensor.nearest.data() + tensor.at(bin, tensor.region.x, tensor.region.y + row);
        for (int x = 0; x < tensor.region.width; ++x)
            out[x] = static_cast<std::uint16_t>(index[x]); // -1 becomes kNone
    }
}

} // namespace

Dt3Tensor computeDt3Tensor(const OrientedContour& contour, const OrientationBins& bins, double lambdaPxPerRad,
                           const cv::Rect& region) {
    if (contour.size() >= Dt3Tensor::kNone) {
        throw Error(ErrorCode::Unsupported, "", "contour",
                    std::to_string(contour.size()) + " points are too many for a DT3 tensor (at most 65534)");
    }
    Dt3Tensor tensor{bins, lambdaPxPerRad, region, {}};
    tensor.nearest.resize(static_cast<std::size_t>(bins.count()) * static_cast<std::size_t>(region.area()));
    const std::vector<ColumnDistances> columns = columnsByBin(contour, bins, region);
    BinRows rows(bins.count(), region.width);
    RowEnvelope envelope(region.width);
    for (int row = 0; row < region.height; ++row) {
        for (int bin = 0; bin < bins.count(); ++bin)
            envelope.run(columns[static_cast<std::size_t>(bin)], row, rows.cost(bin), rows.index(bin));
        rows.relax(static_cast<float>(lambdaPxPerRad * bins.widthRad()));
        storeRow(rows, row, tensor);
    }
    return tensor;
}

std::optional<DirectMatch> nearestFromTensor(const Dt3Tensor& tensor, const OrientedContour& contour,
                                             const Eigen::Vector2d& px, double angleRad) {
    const int x = static_cast<int>(std::lround(px.x()));
    const int y = static_cast<int>(std::lround(px.y()));
    const int bin = tensor.bins.binOf(angleRad);
    if (!tensor.contains(x, y))
        return nearestQuantisedPoint(contour, tensor.bins, px, bin, tensor.lambdaPxPerRad);
    const std::uint16_t nearest = tensor.nearest[tensor.at(bin, x, y)];
    if (nearest == Dt3Tensor::kNone)
        return std::nullopt;
    const int contourBin = tensor.bins.binOf(contour.angleRad[nearest]);
    const double orientationPx = tensor.lambdaPxPerRad * tensor.bins.distanceRad(bin, contourBin);
    return DirectMatch{nearest, distancePx(contour, nearest, px) + orientationPx};
}

} // namespace core
