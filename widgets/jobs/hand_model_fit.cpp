// SPDX-License-Identifier: MIT
#include "widgets/jobs/hand_model_fit.h"

#include <cmath>

namespace widgets {

namespace {

void addProposals(ModelFit& fit, const core::HandModel& hand, const core::Pose& pose, const core::JointPoints& points) {
    const auto joints = core::jointPositions(hand.skeleton, pose);
    for (std::size_t bone = 0; bone < joints.size(); ++bone) {
        const core::JointId joint{hand.side, hand.skeleton.bones[bone].name};
        if (!points.count(joint))
            fit.proposals.push_back({joint, joints[bone]});
    }
}

} // namespace

std::optional<ModelFit> fitModelToPoints(const core::Dataset& dataset, int frame, const core::JointPoints& points) {
    ModelFit fit;
    fit.frame = frame;
    double squaredMm2 = 0;
    for (const core::HandModel& hand : dataset.hands) {
        const auto found = core::fitHandToPoints(hand, points);
        fit.poses.push_back(found ? found->pose : core::Pose());
        if (!found)
            continue;
        const auto joints = static_cast<double>(found->residualMm.size());
        fit.joints += static_cast<int>(found->residualMm.size());
        squaredMm2 += found->rmsMm * found->rmsMm * joints;
        addProposals(fit, hand, found->pose, points);
    }
    if (fit.joints == 0)
        return std::nullopt;
    fit.rmsMm = std::sqrt(squaredMm2 / fit.joints);
    return fit;
}

HandModelFit::HandModelFit(const AnnotationDocument& document, const Selection& selection,
                           const Reconstructions& reconstructions, JobPool& pool, QObject* parent)
    : QObject(parent)
    , m_selection(selection)
    , m_reconstructions(reconstructions)
    , m_job(pool)
    , m_onceJob(pool) {
    connect(&reconstructions, &Reconstructions::changed, this, &HandModelFit::refresh);
    const auto drop = [this] { m_onceJob.stop(); }; // its answer would land elsewhere
    connect(&document, &AnnotationDocument::opened, this, drop);
    connect(&document, &AnnotationDocument::raterChanged, this, drop);
    connect(&m_onceJob, &Job::failed, this, &HandModelFit::impossible);
}

void HandModelFit::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_onceJob.stop();
    m_dataset = std::move(dataset);
    refresh();
}

void HandModelFit::setOn(bool on) {
    m_on = on;
    refresh();
}

void HandModelFit::fitOnce() {
    if (!m_dataset || m_dataset->hands.empty()) {
        emit impossible(tr("This dataset has no hand models."));
        return;
    }
    m_onceJob.start([this, dataset = m_dataset, frame = m_selection.frame(),
                     points = points()](const JobContext&) -> Job::Delivery {
        const auto fit = fitModelToPoints(*dataset, frame, points);
        return [this, fit] {
            if (fit)
                emit fitted(*fit);
            else
                emit impossible(
                    tr("The hand model needs three joints of a hand that have a 3D point and are not on a line."));
        };
    });
}

void HandModelFit::refresh() {
    if (!m_on || !m_dataset) {
        m_job.stop();
        if (m_fit) {
            m_fit.reset();
            emit changed();
        }
        return;
    }
    m_job.start([this, dataset = m_dataset, frame = m_selection.frame(),
                 points = points()](const JobContext& context) -> Job::Delivery {
        if (context.stop.stop_requested())
            return {}; // a drag is many
        return [this, fit = fitModelToPoints(*dataset, frame, points)] {
            m_fit = fit;
            emit changed();
        };
    });
}

core::JointPoints HandModelFit::points() const {
    core::JointPoints points;
    for (const auto& [joint, found] : m_reconstructions.joints())
        if (found.hasPoint())
            points.emplace(joint, *found.result.point);
    return points;
}

} // namespace widgets
