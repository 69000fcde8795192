// SPDX-License-Identifier: MIT
#include "app/desktop/windows/calibration_page.h"

#include <set>

#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QIcon>
#include <QVBoxLayout>

#include "app/desktop/windows/path_field.h"
#include "core/geometry/camera_target.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/camera_fault_text.h"
#include "widgets/text/error_text.h"

namespace app {

namespace {

constexpr int kCalibrationTypingMs = 400;

} // namespace

CalibrationPage::CalibrationPage(QWidget* parent)
    : QWidget(parent)
    , m_path(new QLineEdit(this))
    , m_unit(new QComboBox(this))
    , m_summary(new QLabel(this))
    , m_drawing(new widgets::RigDrawing(this))
    , m_findings(new QListWidget(this)) {
    m_unit->addItem(tr("as usual for its kind"), 0.0);
    m_unit->addItem(tr("millimetres"), 1.0);
    m_unit->addItem(tr("centimetres"), 10.0);
    m_unit->addItem(tr("metres"), 1000.0);
    m_summary->setWordWrap(true);
    m_findings->setWordWrap(true);
    m_findings->setSelectionMode(QAbstractItemView::NoSelection);
    m_findings->setFocusPolicy(Qt::NoFocus);
    auto* form = new QFormLayout;
    form->addRow(tr("Calibration"), withChooser(m_path, tr("The calibration"), PathKind::FileOrFolder, this));
    form->addRow(tr("Unit of length"), m_unit);
    auto* row = new QHBoxLayout;
    row->addWidget(m_drawing, 3);
    row->addWidget(m_findings, 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(m_summary);
    column->addLayout(row, 1);
    m_wait.setSingleShot(true);
    m_wait.setInterval(kCalibrationTypingMs);
    connect(&m_wait, &QTimer::timeout, this, &CalibrationPage::changed);
    connect(m_path, &QLineEdit::textChanged, this, [this] {
        clear();
        m_wait.start();
    });
    connect(m_unit, qOverload<int>(&QComboBox::currentIndexChanged), this, &CalibrationPage::changed);
    clear();
}

void CalibrationPage::setPath(const QString& path) {
    m_path->setText(path);
    m_wait.stop();
    emit changed();
}

std::optional<double> CalibrationPage::mmPerUnit() const {
    const double unit = m_unit->currentData().toDouble();
    return unit > 0 ? std::optional(unit) : std::nullopt;
}

void CalibrationPage::clear() {
    m_look.reset();
    m_failure.clear();
    m_findings->clear();
    m_drawing->setCameras({});
    m_summary->setText(tr("Anipose, OpenCV, EasyMocap, JARVIS, MATLAB and others: the kind is recognised."));
}

void CalibrationPage::show(const widgets::CalibrationLook& look) {
    m_look = look;
    m_failure.clear();
    std::set<int> odd;
    m_findings->clear();
    for (const core::CameraFault& fault : look.faults) {
        odd.insert(fault.camera);
        auto* item = new QListWidgetItem(
            QIcon::fromTheme(fault.isFatal() ? QStringLiteral("dialog-error") : QStringLiteral("dialog-warning")),
            widgets::cameraFaultText(fault, look.cameras), m_findings);
        item->setToolTip(item->text());
    }
    if (look.faults.empty())
        m_findings->addItem(new QListWidgetItem(
            QIcon::fromTheme(QStringLiteral("dialog-ok-apply")),
            tr("Sizes, rotations and lenses make sense, and every camera sees where the others look.")));
    m_drawing->setCameras(look.cameras, odd);
    m_summary->setText(summary());
}

QString CalibrationPage::summary() const {
    const core::RigScale scale = core::rigScale(m_look->cameras);
    QString text =
        tr("Recognised as %1: %n camera(s).", nullptr, static_cast<int>(m_look->cameras.size())).arg(m_look->kind);
    if (scale.distanceMm > 0 && scale.hasTarget)
        text += QLatin1Char(' ') +
                tr("They stand about %1 mm from where they look.").arg(QLocale().toString(scale.distanceMm, 'f', 0));
    return text;
}

void CalibrationPage::showFailure(const QString& message) {
    clear();
    m_failure = message;
    m_findings->addItem(
        new QListWidgetItem(QIcon::fromTheme(QStringLiteral("dialog-error")), widgets::withoutDetail(message)));
}

QString CalibrationPage::problem() const {
    if (path().isEmpty())
        return tr("Choose the calibration of the cameras.");
    if (!QFileInfo::exists(path()))
        return tr("There is no such calibration file.");
    if (!m_failure.isEmpty())
        return tr("The calibration cannot be read.");
    if (!m_look)
        return tr("The calibration is being read...");
    for (const core::CameraFault& fault : m_look->faults)
        if (fault.isFatal())
            return widgets::cameraFaultText(fault, m_look->cameras);
    return {};
}

} // namespace app
