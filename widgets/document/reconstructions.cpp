// SPDX-License-Identifier: MIT
#include "widgets/document/reconstructions.h"

#include <algorithm>
#include <set>

namespace widgets {

Reconstructions::Reconstructions(const AnnotationDocument& document, const Selection& selection, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_selection(selection) {
    connect(&document, &AnnotationDocument::opened, this, &Reconstructions::rebuild);
    connect(&document, &AnnotationDocument::raterChanged, this, &Reconstructions::rebuild);
    connect(&document, &AnnotationDocument::changed, this, &Reconstructions::update);
    connect(&selection, &Selection::frameChanged, this, &Reconstructions::rebuild);
    connect(&selection, &Selection::jointChanged, this, &Reconstructions::selectJoint);
}

void Reconstructions::setDataset(std::shared_ptr<const core::Dataset> dataset) {
    m_dataset = std::move(dataset);
    m_gaps = {};
    m_sigmas = {};
    rebuild();
}

void Reconstructions::setPictureGaps(core::PictureGaps gaps) {
    if (gaps == m_gaps)
        return;
    m_gaps = std::move(gaps);
    rebuild();
}

void Reconstructions::setClickSigmas(core::ClickSigmas sigmas) {
    m_sigmas = std::move(sigmas);
    rebuild();
}

core::ReconstructionOptions Reconstructions::optionsAt(int frame, bool details) const {
    return {m_options, details, std::nullopt, m_gaps.at(frame)};
}

const core::JointReconstruction* Reconstructions::find(const core::JointId& joint) const {
    const auto at = m_joints.find(joint);
    return at == m_joints.end() ? nullptr : &at->second;
}

core::JointReconstruction Reconstructions::compute(int frame, const core::JointId& joint) const {
    if (!m_dataset)
        return {};
    core::ReconstructionOptions options = optionsAt(frame, true);
    options.nearInWorld = nearPoint(joint.hand);
    return core::reconstruct(m_document.annotations(), m_dataset->cameras, frame, m_document.rater(), joint, options);
}

void Reconstructions::rebuild() {
    m_joints.clear();
    m_options = m_sigmas.optionsFor(m_document.rater());
    if (m_dataset) {
        m_joints = core::reconstructFrame(m_document.annotations(), m_dataset->cameras, m_selection.frame(),
                                          m_document.rater(), optionsAt(m_selection.frame(), false));
    }
    refreshSelected();
    emit changed();
}

void Reconstructions::update(const core::Edit& edit) {
    if (!m_dataset)
        return;
    std::set<core::JointId> touched;
    for (const core::MarkChange& change : edit.marks)
        if (change.key.frame == m_selection.frame() && change.key.rater == m_document.rater())
            touched.insert(change.key.joint);
    if (touched.empty())
        return;
    const core::ReconstructionOptions options = optionsAt(m_selection.frame(), false);
    for (const core::JointId& joint : touched) {
        auto found = core::reconstruct(m_document.annotations(), m_dataset->cameras, m_selection.frame(),
                                       m_document.rater(), joint, options);
        const bool marked = std::any_of(found.views.begin(), found.views.end(),
                                        [](const core::ViewReconstruction& view) { return view.mark.has_value(); });
        if (marked)
            m_joints[joint] = std::move(found);
        else
            m_joints.erase(joint);
    }
    refreshSelected();
    emit changed();
}

void Reconstructions::selectJoint() {
    refreshSelected();
    emit changed();
}

void Reconstructions::refreshSelected() {
    m_selected = compute(m_selection.frame(), m_selection.joint());
}

std::optional<Eigen::Vector3d> Reconstructions::nearPoint(core::Side hand) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (const auto& [joint, found] : m_joints) {
        if (joint.hand == hand && found.hasPoint()) {
            sum += found.result.point->pointInWorld;
            ++count;
        }
    }
    return count > 0 ? std::optional<Eigen::Vector3d>(sum / count) : std::nullopt;
}

} // namespace widgets
