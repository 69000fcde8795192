// SPDX-License-Identifier: MIT
#include "core/rig/camera_course.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/rig/residual_regression.h"

namespace core {

namespace {

/// The clicks of a camera with a mean per sequence and a common variation over the image.
class Course {
public:
    Course(const std::vector<CourseClick>& clicks, const std::vector<SequenceHealth>& sequences)
        : m_clicks(clicks)
        , m_fixed(2 * static_cast<Eigen::Index>(sequences.size()) + 4) {
        const auto count = static_cast<Eigen::Index>(clicks.size());
        m_design = Eigen::MatrixXd::Zero(2 * count, m_fixed + 2);
        m_residuals.resize(2 * count);
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (const CourseClick& click : clicks)
            middle += click.place / static_cast<double>(count);
        for (Eigen::Index i = 0; i < count; ++i) {
            const CourseClick& click = clicks[static_cast<std::size_t>(i)];
            const Eigen::RowVector2d place = (click.place - middle).transpose();
            const auto sequence = std::find_if(sequences.begin(), sequences.end(), [&](const SequenceHealth& health) {
                return health.sequence == click.sequence;
            });
            const Eigen::Index column = 4 + 2 * (sequence - sequences.begin());
            m_design.block<1, 2>(2 * i, 0) = place;
            m_design.block<1, 2>(2 * i + 1, 2) = place;
            m_design.block<2, 2>(2 * i, column).setIdentity();
            m_residuals.segment<2>(2 * i) = click.residualPx;
        }
    }

    std::optional<Regression> still() const { return regress(m_design.leftCols(m_fixed), m_residuals); }

    /// With one more cause, which moves the residual of click i by cause(click) times two unknowns, the last two.
    template <typename Cause>
    std::optional<Regression> with(Cause cause) {
        for (std::size_t i = 0; i < m_clicks.size(); ++i)
            m_design.block<2, 2>(2 * static_cast<Eigen::Index>(i), m_fixed) =
                cause(m_clicks[i]) * Eigen::Matrix2d::Identity();
        return regress(m_design, m_residuals);
    }
    Eigen::Index changeColumn() const { return m_fixed; }

private:
    const std::vector<CourseClick>& m_clicks;
    Eigen::Index m_fixed;
    Eigen::MatrixXd m_design;
    Eigen::VectorXd m_residuals;
};

/// Weighted sums of the rest, by frame.
struct FrameSum {
    Eigen::Vector2d sumPx = Eigen::Vector2d::Zero();
    double weight = 0;
    int clicks = 0;
};

/// The frame from which the rest differs most from what it was before: the largest squared difference of both means
/// over its variance. Empty with too few clicks on either side.
std::optional<std::pair<int, int>> bestSplit(const std::map<int, FrameSum>& frames, int leastClicks) {
    FrameSum before, after;
    for (const auto& [frame, sum] : frames)
        after = {after.sumPx + sum.sumPx, after.weight + sum.weight, after.clicks + sum.clicks};
    double most = 0;
    std::optional<std::pair<int, int>> split;
    for (auto at = frames.begin(); at != frames.end() && std::next(at) != frames.end(); ++at) {
        const FrameSum& sum = at->second;
        before = {before.sumPx + sum.sumPx, before.weight + sum.weight, before.clicks + sum.clicks};
        after = {after.sumPx - sum.sumPx, after.weight - sum.weight, after.clicks - sum.clicks};
        if (before.clicks < leastClicks || after.clicks < leastClicks || !(before.weight > 0) || !(after.weight > 0))
            continue;
        const double gain = (before.sumPx / before.weight - after.sumPx / after.weight).squaredNorm() /
                            (1 / before.weight + 1 / after.weight);
        if (gain > most) {
            most = gain;
            split = {at->first, std::next(at)->first};
        }
    }
    return split;
}

/// Squared length of the last two unknowns over their variance.
double gainOf(const Regression& fit, Eigen::Index column) {
    return fit.unknowns.segment<2>(column).squaredNorm() / fit.covariance(column, column);
}

void judgeSequence(Course& course, const std::vector<CourseClick>& clicks, const Regression& still, Eigen::Index index,
                   const CourseOptions& options, SequenceHealth& health) {
    const Eigen::Index mean = 4 + 2 * index, change = course.changeColumn();
    health.meanPx = still.unknowns.segment<2>(mean);
    health.meanSigmaPx = std::sqrt(still.covariance(mean, mean));
    std::map<int, FrameSum> frames;
    for (std::size_t i = 0; i < clicks.size(); ++i) {
        if (clicks[i].sequence == health.sequence) {
            const auto row = 2 * static_cast<Eigen::Index>(i);
            FrameSum& sum = frames[clicks[i].frame];
            sum.sumPx += still.weights[row] * still.rest.segment<2>(row);
            sum.weight += still.weights[row];
            ++sum.clicks;
        }
    }
    health.firstFrame = frames.begin()->first;
    health.lastFrame = frames.rbegin()->first;
    const double middle = 0.5 * (health.firstFrame + health.lastFrame);
    const auto slope = course.with([&](const CourseClick& click) {
        return click.sequence == health.sequence ? (click.frame - middle) / 100 : 0.0;
    });
    if (slope) {
        health.driftPx = slope->unknowns.segment<2>(change);
        health.driftSigmaPx = std::sqrt(slope->covariance(change, change));
    }
    const auto split = bestSplit(frames, options.leastClicks / 2);
    const auto step = split ? course.with([&](const CourseClick& click) {
        return click.sequence == health.sequence && click.frame >= split->second ? 1.0 : 0.0;
    })
                            : std::nullopt;
    const double slopeGain = slope ? gainOf(*slope, change) : 0, stepGain = step ? gainOf(*step, change) : 0;
    const double gate = std::pow(1.5 * options.significance, 2);
    const double drifted = slope ? health.driftPx->norm() * (health.lastFrame - health.firstFrame) / 100 : 0;
    if (stepGain > std::max(gate, slopeGain)) {
        CameraStep found{split->first,
                         split->second,
                         step->unknowns.segment<2>(mean),
                         {},
                         std::sqrt(step->covariance(change, change))};
        found.afterPx = found.beforePx + step->unknowns.segment<2>(change);
        if (found.changePx() > options.leastOffPx)
            health.step = found;
    } else if (slopeGain > gate && drifted > options.leastOffPx) {
        health.isDrifting = true;
    }
}

} // namespace

std::vector<SequenceHealth> judgeCourse(std::vector<CourseClick> clicks, const CourseOptions& options) {
    std::map<int, int> counts;
    for (const CourseClick& click : clicks)
        ++counts[click.sequence];
    std::erase_if(
        counts, [&](const auto& item) { return item.second < options.leastClicks; });
    std::erase_if(clicks, [&](const CourseClick& click) { return !counts.contains(click.sequence); });
    std::vector<SequenceHealth> sequences;
    for (const auto& [sequence, count] : counts) {
        sequences.emplace_back();
        sequences.back().sequence = sequence;
        sequences.back().clicks = count;
    }
    if (sequences.empty())
        return {};
    Course course(clicks, sequences);
    const auto still = course.still();
    if (!still)
        return {};
    for (std::size_t s = 0; s < sequences.size(); ++s)
        judgeSequence(course, clicks, *still, static_cast<Eigen::Index>(s), options, sequences[s]);
    return sequences;
}

} // namespace core
