// SPDX-License-Identifier: MIT
#include "widgets/presenters/residual_arrows.h"

#include <algorithm>
#include <map>
#include <utility>

namespace widgets {

namespace {

constexpr int kCellsAlongLongerSide = 8;
const QColor kInUseColour(0xFF, 0xA7, 0x26);
const QColor kRefinedColour(0x3D, 0xD6, 0x9A);

/// The clicks of one cell, weighed.
struct CellSum {
    double weight = 0;
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    Eigen::Vector2d residualPx = Eigen::Vector2d::Zero();
};

} // namespace

std::vector<ResidualArrow> residualArrows(const core::RigResiduals& residuals, int camera, const core::ImageSize& size,
                                          const QColor& colour) {
    const double cell = std::max(size.width, size.height) / static_cast<double>(kCellsAlongLongerSide);
    std::map<std::pair<int, int>, CellSum> cells;
    for (const core::RigResidual& click : residuals.clicks) {
        if (click.camera != camera)
            continue;
        CellSum& sum = cells[{static_cast<int>(click.px.x() / cell), static_cast<int>(click.px.y() / cell)}];
        sum.weight += click.weight;
        sum.px += click.weight * click.px;
        sum.residualPx += click.weight * click.leftOutPx;
    }
    constexpr double kLeastWeight = 0.1; // nothing but wrong clicks
    std::vector<ResidualArrow> arrows;
    for (const auto& [place, sum] : cells) {
        if (sum.weight < kLeastWeight)
            continue;
        const Eigen::Vector2d from = sum.px / sum.weight;
        const Eigen::Vector2d to = from + kResidualLengthening / sum.weight * sum.residualPx;
        arrows.push_back({{from.x(), from.y()}, {to.x(), to.y()}, colour});
    }
    return arrows;
}

ResidualArrows::ResidualArrows(const RigStudy& rig, CameraGrid& grid, QObject* parent)
    : QObject(parent)
    , m_rig(rig)
    , m_grid(grid) {
    connect(&rig, &RigStudy::changed, this, &ResidualArrows::refresh);
    connect(&rig, &RigStudy::proposalChanged, this, &ResidualArrows::refresh);
}

void ResidualArrows::setShown(bool shown) {
    m_shown = shown;
    refresh();
}

void ResidualArrows::refresh() {
    for (int camera = 0; camera < m_grid.count(); ++camera) {
        CameraView* view = m_grid.view(camera);
        std::vector<ResidualArrow> arrows;
        if (m_shown && m_rig.state())
            arrows = residualArrows(m_rig.state()->residuals, camera, view->camera().size, kInUseColour);
        if (m_shown && m_rig.proposal())
            for (const ResidualArrow& arrow :
                 residualArrows(m_rig.proposal()->residuals, camera, view->camera().size, kRefinedColour))
                arrows.push_back(arrow);
        view->setResidualArrows(arrows);
    }
}

} // namespace widgets
