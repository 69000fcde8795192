// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/what_if_panel.h"

#include <algorithm>

#include <QSignalBlocker>

#include "widgets/panels/compare/what_if_sweep.h"
#include "widgets/text/method_text.h"
#include "widgets/views/method_chip.h"

namespace widgets {

void WhatIfPanel::showColumn(std::size_t column) {
    if (column >= m_columns.count() || m_columns.columns()[column].kind != InspectColumn::Kind::Method)
        return;
    m_column->setCurrentIndex(m_column->findData(QString::fromStdString(m_columns.columns()[column].name)));
}

/// The columns have changed: what is changed here stays, if its column does.
void WhatIfPanel::takeColumns() {
    QStringList methods;
    for (const std::string& column : methodColumns())
        methods << QString::fromStdString(column);
    QStringList before;
    for (int i = 0; i < m_column->count(); ++i)
        before << m_column->itemData(i).toString();
    m_hint->setVisible(methods.isEmpty());
    m_content->setVisible(!methods.isEmpty());
    if (methods != before) {
        const QSignalBlocker blocker(m_column);
        m_column->clear();
        for (const QString& method : methods)
            m_column->addItem(methodChip(method.toStdString()), method, method);
        const QString next = QString::fromStdString(methods.contains(QString::fromStdString(m_next)) ? m_next : m_base);
        m_column->setCurrentIndex(std::max(0, methods.indexOf(next)));
        if (next != QString::fromStdString(m_base))
            m_next.clear();
        makeCameraBoxes();
    }
    const bool isOther = m_fits.outcome() && !(m_pair && isSamePair(*m_pair, *m_fits.outcome()));
    if (m_fits.outcome())
        m_pair = m_fits.outcome();
    if (isOther && isVisible())
        m_runner.prepare();
    const std::string chosen = m_column->currentData().toString().toStdString();
    const bool isOtherColumn = chosen != m_base;
    m_base = chosen;
    if (isOther) // of another pair, nothing stays
        goBack();
    else if (isOtherColumn)
        showSettings();
    std::erase_if(
        m_shown, [&](const auto& shown) { return !methods.contains(QString::fromStdString(shown.first)); });
    std::erase_if(m_tried, [&](const auto& tried) { return !methods.contains(QString::fromStdString(tried.first)); });
    catchUp();
    showSweep();
}

void WhatIfPanel::makeCameraBoxes() {
    const auto& dataset = m_datasets.dataset();
    const std::size_t count = dataset ? dataset->cameras.size() : 0;
    bool isSame = m_cameras.size() == count;
    for (std::size_t c = 0; isSame && c < count; ++c)
        isSame = m_cameras[c]->objectName().toStdString() == dataset->cameras[c].name;
    if (isSame)
        return;
    qDeleteAll(m_cameras);
    m_cameras.clear();
    m_without.clear();
    constexpr int kAcross = 2;
    for (std::size_t c = 0; c < count; ++c) {
        const QString name = QString::fromStdString(dataset->cameras[c].name);
        auto* box = new QCheckBox(name, this);
        box->setObjectName(name);
        box->setChecked(true);
        box->setFocusPolicy(Qt::NoFocus);
        box->setToolTip(tr("Whether this camera's silhouette takes part"));
        m_cameraGrid->addWidget(box, static_cast<int>(c) / kAcross, static_cast<int>(c) % kAcross);
        connect(box, &QCheckBox::toggled, this, [this] { explore(kCamerasKey); });
        m_cameras.push_back(box);
    }
}

void WhatIfPanel::takeLine() {
    const QString written = m_line->text().trimmed();
    const QString problem = methodProblem(written);
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_apply->setEnabled(problem.isEmpty());
    m_add->setEnabled(problem.isEmpty());
    if (!problem.isEmpty())
        return;
    m_form->setMethod(written.toStdString());
    explore({});
}

void WhatIfPanel::edit(const std::string& key) {
    const QSignalBlocker blocker(m_line);
    m_line->setText(QString::fromStdString(m_form->method()));
    m_problem->hide();
    m_apply->setEnabled(true);
    m_add->setEnabled(true);
    explore(key);
}

void WhatIfPanel::apply() {
    const std::string method = m_form->method(), base = m_base;
    goBack();
    for (std::size_t column = 0; column < m_columns.count(); ++column) {
        if (columnId(m_columns.columns()[column]) == base) {
            m_next = method; // once it is fitted
            m_columns.replace(column, method);
            return;
        }
    }
}

void WhatIfPanel::addColumn() {
    const std::string method = m_form->method();
    goBack();
    m_next = method;
    m_columns.add({InspectColumn::Kind::Method, method});
}

void WhatIfPanel::goBack() {
    m_runner.stop();
    m_isSweeping = false;
    m_tried.clear();
    m_shown.clear();
    setCase({});
    showSettings();
    showSweep();
    showTrial();
}

/// Those of the column, in the form; what was explored of another is over.
void WhatIfPanel::showSettings() {
    m_key.clear();
    m_without.clear();
    showCameraTexts();
    if (!m_base.empty()) {
        m_form->setMethod(tried(m_base));
        m_line->setText(QString::fromStdString(tried(m_base)));
    }
    m_problem->hide();
    m_answer->clear();
    startCurve({});
}

} // namespace widgets
