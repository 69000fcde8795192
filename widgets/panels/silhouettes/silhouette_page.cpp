// SPDX-License-Identifier: MIT
#include "widgets/panels/silhouettes/silhouette_page.h"

#include <algorithm>

#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QVBoxLayout>
#include <opencv2/core.hpp>

#include "widgets/panels/state_colours.h"

namespace widgets {

namespace {

using core::SegmentationMethod;

/// In the order of core::kSegmentationMethods.
QStringList methodTexts() {
    return {SilhouettePage::tr("Around the joints"), SilhouettePage::tr("Around the posed hand model"),
            SilhouettePage::tr("What differs from the empty room"),
            SilhouettePage::tr("What has not the backdrop's colour"),
            SilhouettePage::tr("What has the colour of skin")};
}

QDoubleSpinBox* makeNumber(QWidget* parent, double low, double high, double step, double value, int decimals) {
    auto* box = new QDoubleSpinBox(parent);
    box->setDecimals(decimals);
    box->setRange(low, high);
    box->setSingleStep(step);
    box->setValue(value);
    box->setAlignment(Qt::AlignRight);
    return box;
}

} // namespace

SilhouettePage::SilhouettePage(SilhouetteStudy& study, const Selection& selection, QWidget* parent)
    : QWidget(parent)
    , m_study(study)
    , m_selection(selection)
    , m_message(new MessageBar(this))
    , m_method(new QComboBox(this))
    , m_band(makeNumber(this, 1, 30, 1, study.options().bandMm, 0))
    , m_forearm(makeNumber(this, 0, core::kForearmPalms, 0.1, study.options().forearmPalms, 1))
    , m_found(new QLabel(this))
    , m_brush(new QToolButton(this))
    , m_radius(makeNumber(this, 1, 200, 1, 12, 0))
    , m_undo(new QToolButton(this))
    , m_redo(new QToolButton(this))
    , m_from(new QSpinBox(this))
    , m_to(new QSpinBox(this))
    , m_step(new QSpinBox(this))
    , m_attach(new QCheckBox(tr("Give them to this sequence"), this))
    , m_make(new QPushButton(tr("Make silhouettes"), this))
    , m_progress(new QProgressBar(this))
    , m_stop(new QPushButton(tr("Stop"), this)) {
    build();
    connectStudy();
    showMethod();
    showRunning();
    showUndo();
}

SilhouettePage::~SilhouettePage() {
    m_study.disconnect(this);
    m_study.undoStack()->disconnect(this);
    m_study.setOn(false);
}

void SilhouettePage::build() {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing);
    m_method->addItems(methodTexts());
    m_method->setCurrentIndex(static_cast<int>(m_study.options().method));
    m_band->setSuffix(tr(" mm"));
    m_band->setToolTip(tr("By how much the pose may be wrong: that far from the model the picture decides"));
    m_forearm->setToolTip(tr("How much of the forearm is kept, in lengths of the palm from the wrist"));
    m_found->setWordWrap(true);
    m_attach->setChecked(true);
    m_attach->setToolTip(tr("Poses are fitted to them then"));
    m_progress->setTextVisible(false);
    m_progress->setRange(0, 1000);
    column->addWidget(m_message);
    column->addLayout(makeMethod());
    column->addWidget(m_found);
    column->addLayout(makeBrush());
    column->addLayout(makeFrames());
    column->addLayout(makeButtons());
    column->addStretch(1);
}

QLayout* SilhouettePage::makeMethod() {
    auto* form = new QFormLayout;
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->addRow(tr("Found"), m_method);
    form->addRow(tr("Pose may be off by"), m_band);
    form->addRow(tr("Forearm, in palms"), m_forearm);
    return form;
}

QLayout* SilhouettePage::makeBrush() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    m_brush->setText(tr("Brush"));
    m_brush->setIcon(QIcon::fromTheme(QStringLiteral("draw-brush")));
    m_brush->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_brush->setCheckable(true);
    m_brush->setToolTip(tr("In the views: the left button adds to the silhouette, the right one (or Shift) takes away; "
                           "Ctrl and the wheel change the size"));
    m_radius->setSuffix(tr(" px"));
    m_radius->setToolTip(tr("Radius of the brush, pixels of the picture"));
    m_undo->setIcon(QIcon::fromTheme(QStringLiteral("edit-undo")));
    m_redo->setIcon(QIcon::fromTheme(QStringLiteral("edit-redo")));
    row->addWidget(m_brush);
    row->addWidget(m_radius);
    row->addStretch(1);
    row->addWidget(m_undo);
    row->addWidget(m_redo);
    return row;
}

QLayout* SilhouettePage::makeFrames() {
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    const int last = std::max(0, m_selection.frameCount() - 1);
    for (QSpinBox* box : {m_from, m_to}) {
        box->setRange(0, last);
        box->setAlignment(Qt::AlignRight);
    }
    m_to->setValue(last);
    m_step->setRange(1, 1000);
    m_step->setAlignment(Qt::AlignRight);
    for (const auto& [text, box] : {std::pair(tr("Frames"), m_from), {tr("to"), m_to}, {tr("every"), m_step}}) {
        auto* label = new QLabel(text, this);
        label->setBuddy(box);
        row->addWidget(label);
        row->addWidget(box);
    }
    row->addStretch(1);
    return row;
}

QLayout* SilhouettePage::makeButtons() {
    auto* column = new QVBoxLayout;
    auto* row = new QHBoxLayout;
    row->setSpacing(kSpacing);
    row->addWidget(m_make);
    row->addWidget(m_progress, 1);
    row->addWidget(m_stop);
    row->addStretch(1);
    column->addWidget(m_attach);
    column->addLayout(row);
    return column;
}

void SilhouettePage::connectStudy() {
    connect(m_method, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &SilhouettePage::applyMethod);
    for (QDoubleSpinBox* box : {m_band, m_forearm})
        connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &SilhouettePage::applyMethod);
    connect(m_brush, &QToolButton::toggled, this, &SilhouettePage::brushRequested);
    connect(m_radius, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &SilhouettePage::brushRadiusRequested);
    connect(m_undo, &QToolButton::clicked, m_study.undoStack(), &QUndoStack::undo);
    connect(m_redo, &QToolButton::clicked, m_study.undoStack(), &QUndoStack::redo);
    connect(m_study.undoStack(), &QUndoStack::indexChanged, this, &SilhouettePage::showUndo);
    connect(m_make, &QPushButton::clicked, this, &SilhouettePage::run);
    connect(m_stop, &QPushButton::clicked, &m_study, &SilhouetteStudy::stop);
    connect(&m_study, &SilhouetteStudy::changed, this, &SilhouettePage::showFound);
    connect(&m_study, &SilhouetteStudy::cleared, this, &SilhouettePage::showFound);
    connect(&m_study, &SilhouetteStudy::runningChanged, this, &SilhouettePage::showRunning);
    connect(&m_study, &SilhouetteStudy::failed, m_message, &MessageBar::setMessage);
    connect(&m_study, &SilhouetteStudy::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(1000 * fraction)); });
    connect(&m_study, &SilhouetteStudy::made, this, [this](int masks, int kept, bool attached) {
        QString text = tr("%n silhouette(s) made, %1 were there already.", nullptr, masks).arg(kept);
        if (attached)
            text += QLatin1Char(' ') + tr("The sequence uses them now.");
        m_message->offer(text, {});
    });
}

void SilhouettePage::applyMethod() {
    core::SilhouetteOptions options = m_study.options();
    options.method = core::kSegmentationMethods.at(static_cast<std::size_t>(m_method->currentIndex()));
    options.bandMm = m_band->value();
    options.forearmPalms = m_forearm->value();
    m_message->setMessage({});
    showMethod();
    m_study.setOptions(options);
}

void SilhouettePage::showMethod() {
    const auto method = core::kSegmentationMethods.at(static_cast<std::size_t>(m_method->currentIndex()));
    m_band->setEnabled(method == SegmentationMethod::Model);
    m_forearm->setEnabled(method != SegmentationMethod::Model);
}

/// In how many views there is a silhouette, and what to do if there is none.
void SilhouettePage::showFound() {
    int found = 0, kept = 0;
    for (const auto& [camera, shown] : m_study.shown()) {
        found += cv::countNonZero(shown.silhouette.mask) > 0 ? 1 : 0;
        kept += shown.isKept ? 1 : 0;
    }
    QString text = tr("This frame: a silhouette in %n view(s)", nullptr, found);
    if (kept > 0)
        text += tr(", %n of them kept on disk", nullptr, kept);
    const auto method = m_study.options().method;
    const bool byHands = method == SegmentationMethod::Landmarks || method == SegmentationMethod::Model;
    if (found == 0 && byHands)
        text = tr("Looking for silhouettes. Nothing appears where no joints of the frame are known: annotate some, or "
                  "choose another way.");
    m_found->setText(text);
}

void SilhouettePage::showRunning() {
    const bool isRunning = m_study.isRunning();
    m_make->setEnabled(!isRunning);
    m_method->setEnabled(!isRunning);
    m_progress->setVisible(isRunning);
    m_stop->setVisible(isRunning);
    if (isRunning)
        m_progress->setValue(0);
}

void SilhouettePage::showUndo() {
    const QUndoStack& stack = *m_study.undoStack();
    m_undo->setEnabled(stack.canUndo());
    m_redo->setEnabled(stack.canRedo());
    m_undo->setToolTip(stack.canUndo() ? tr("Undo %1").arg(stack.undoText()) : tr("Undo"));
    m_redo->setToolTip(stack.canRedo() ? tr("Redo %1").arg(stack.redoText()) : tr("Redo"));
}

void SilhouettePage::showBrush(bool on, double radiusPx) {
    m_brush->setChecked(on);
    m_radius->setValue(radiusPx);
}

void SilhouettePage::run() {
    if (m_study.isRunning())
        return;
    const QString others = m_attach->isChecked() ? m_study.otherMasks() : QString();
    if (others.isEmpty()) {
        start(m_attach->isChecked());
        return;
    }
    m_message->offer(tr("This sequence has masks already (%1). They stay on disk.").arg(others),
                     {{tr("Use the new ones instead"), [this] { start(true); }},
                      {tr("Make them only"), [this] { start(false); }},
                      {tr("Cancel"), [] {}}});
}

void SilhouettePage::start(bool attach) {
    SilhouetteRun run;
    run.attach = attach;
    for (int frame = m_from->value(); frame <= m_to->value(); frame += m_step->value())
        run.frames.push_back(frame);
    m_message->setMessage({});
    if (run.frames.empty())
        m_message->setMessage(tr("The last frame lies before the first one."));
    else
        m_study.run(run);
}

void SilhouettePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_study.setOn(true);
}

void SilhouettePage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    emit brushRequested(false);
    m_study.setOn(false);
}

} // namespace widgets
