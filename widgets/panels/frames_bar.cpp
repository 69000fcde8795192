// SPDX-License-Identifier: MIT
#include "widgets/panels/frames_bar.h"

#include <algorithm>

#include <QAction>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "core/annotation/raters.h"
#include "widgets/panels/state_colours.h"
#include "widgets/panels/timeline_legend.h"

namespace widgets {

namespace {

QToolButton* flatButton(QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    return button;
}

} // namespace

FramesBar::FramesBar(Selection& selection, const AnnotationDocument& document, const AnnotationCoverage& coverage,
                     const JointList& joints, QWidget* parent)
    : QWidget(parent)
    , m_selection(selection)
    , m_document(document)
    , m_coverage(coverage)
    , m_joints(joints)
    , m_sequences(new QComboBox(this))
    , m_previous(flatButton(this))
    , m_frame(new QSpinBox(this))
    , m_next(flatButton(this))
    , m_play(flatButton(this))
    , m_timeline(new Timeline(this))
    , m_legend(flatButton(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpacing, kSpacing / 2, kSpacing, kSpacing / 2);
    row->setSpacing(kSpacing);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_sequences, m_previous, m_frame, m_next, m_play})
        row->addWidget(widget);
    row->addWidget(m_timeline, 1);
    row->addWidget(m_legend);
    m_legend->setText(QStringLiteral("?"));
    m_legend->setToolTip(tr("What the colours of the timeline mean"));
    connect(m_legend, &QToolButton::clicked, this, &FramesBar::showLegend);
    m_sequences->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_sequences->setMinimumContentsLength(8);
    m_sequences->setFocusPolicy(Qt::NoFocus);
    m_sequences->setToolTip(tr("Sequence"));
    m_frame->setAlignment(Qt::AlignRight);
    m_frame->setKeyboardTracking(false);
    m_frame->setFocusPolicy(Qt::ClickFocus);
    m_frame->setToolTip(tr("Frame: type a number and press Enter"));
    m_frame->setPrefix(tr("Frame "));
    connect(m_sequences, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { emit sequenceRequested(m_sequences->itemText(index)); });
    connect(m_frame, qOverload<int>(&QSpinBox::valueChanged), &m_selection, &Selection::setFrame);
    connect(m_frame, &QSpinBox::editingFinished, m_frame, &QWidget::clearFocus);
    connect(m_timeline, &Timeline::frameRequested, &m_selection, &Selection::setFrame);
    connect(&m_selection, &Selection::frameChanged, this, &FramesBar::refreshFrame);
    connect(&m_selection, &Selection::frameCountChanged, this, &FramesBar::refreshFrame);
    connect(&m_coverage, &AnnotationCoverage::changed, this, &FramesBar::refreshCoverage);
    connect(&m_joints, &JointList::changed, this, &FramesBar::refreshCoverage);
    connect(&m_document, &AnnotationDocument::opened, this, &FramesBar::refreshNotes);
    connect(&m_document, &AnnotationDocument::opened, this, &FramesBar::refreshOthers);
    connect(&m_document, &AnnotationDocument::raterChanged, this, &FramesBar::refreshOthers);
    connect(&m_document, &AnnotationDocument::changed, this, [this](const core::Edit& edit) {
        if (!edit.notes.empty())
            refreshNotes();
        if (std::any_of(edit.marks.begin(), edit.marks.end(),
                        [this](const auto& change) { return change.key.rater != m_document.rater(); }))
            refreshOthers();
    });
    refreshFrame();
}

void FramesBar::setActions(QAction* previous, QAction* next, QAction* play) {
    m_previous->setDefaultAction(previous);
    m_next->setDefaultAction(next);
    m_play->setDefaultAction(play);
}

void FramesBar::setDataset(const core::Dataset& dataset) {
    const QSignalBlocker blocker(m_sequences);
    m_sequences->clear();
    for (const core::Sequence& sequence : dataset.sequences)
        m_sequences->addItem(QString::fromStdString(sequence.name));
}

void FramesBar::setSequence(const QString& name) {
    const QSignalBlocker blocker(m_sequences);
    m_sequences->setCurrentText(name);
    refreshFrame();
}

void FramesBar::askForFrame() {
    m_frame->setFocus(Qt::ShortcutFocusReason);
    m_frame->selectAll();
}

void FramesBar::showLegend() {
    auto* legend = new TimelineLegend(this);
    legend->setAttribute(Qt::WA_DeleteOnClose);
    legend->adjustSize();
    legend->move(m_legend->mapToGlobal(QPoint(m_legend->width() - legend->width(), m_legend->height())));
    legend->show();
}

void FramesBar::refreshFrame() {
    const QSignalBlocker blocker(m_frame);
    const int last = std::max(0, m_selection.frameCount() - 1);
    m_frame->setRange(0, last);
    m_frame->setSuffix(QStringLiteral(" / %1").arg(last));
    m_frame->setValue(m_selection.frame());
    m_frame->setEnabled(m_selection.frameCount() > 0);
    m_timeline->setFrameCount(m_selection.frameCount());
    m_timeline->setFrame(m_selection.frame());
}

void FramesBar::refreshCoverage() {
    m_timeline->setCoverage(m_coverage.frames(), m_joints.count(core::Side::Left), m_joints.count(core::Side::Right));
}

void FramesBar::refreshOthers() {
    std::map<int, QString> frames;
    const std::string own = core::ownRaterName(m_document.rater());
    const bool mustNotKnow = core::isRepeatRater(m_document.rater());
    const core::MarkKey* before = nullptr; // marks of one frame and rater follow each other
    for (const auto& [key, mark] : m_document.annotations().marks) {
        const bool isCounted = before && before->frame == key.frame && before->rater == key.rater;
        if (mustNotKnow || isCounted || !mark.isSettled() || core::ownRaterName(key.rater) == own)
            continue;
        before = &key;
        QString& names = frames[key.frame];
        names += (names.isEmpty() ? QString() : QStringLiteral(", ")) + QString::fromStdString(key.rater);
    }
    m_timeline->setOthersFrames(frames);
}

void FramesBar::refreshNotes() {
    std::set<int> frames;
    for (const auto& [frame, note] : m_document.annotations().notes)
        frames.insert(frame);
    m_timeline->setNotedFrames(frames);
}

} // namespace widgets
