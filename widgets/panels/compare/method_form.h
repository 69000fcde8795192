// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "core/fitting/method.h"
#include "core/fitting/method_options.h"

namespace widgets {

/// The options of one method, a row each, from the table of method options: numbers with a slider, choices, flags.
/// The rows that are asked for most come first; the others are folded away.
class MethodForm : public QWidget {
    Q_OBJECT

public:
    explicit MethodForm(QWidget* parent = nullptr);

    /// Shows a method; `name` as core::parseMethod reads it.
    void setMethod(const std::string& name);
    /// With what the person has changed, as on the command line.
    std::string method() const;
    bool hasOption(std::string_view key) const;
    /// Of a number; 0 or 1 of flags and choices.
    double value(std::string_view key) const;
    /// As a person would by moving the slider. Does nothing without that option.
    void setValue(std::string_view key, double value);

signals:
    /// A person has changed that option.
    void edited(const std::string& key);

private:
    struct Row {
        const core::MethodOption* option;
        QSlider* slider = nullptr;
        QDoubleSpinBox* number = nullptr;
        QCheckBox* flag = nullptr;
        QComboBox* choice = nullptr;
        double sliderStep = 1;
    };
    void rebuild();
    void addRow(const core::MethodOption& option, QGridLayout& grid);
    void addNumber(Row& row, QGridLayout& grid, int line);
    void showValues();
    std::string valueText(const Row& row) const;
    double valueOf(const Row& row) const;
    const Row* rowOf(std::string_view key) const;

    core::Method m_plain;  ///< the method without options
    core::Method m_method; ///< that was set
    std::vector<Row> m_rows;
    QWidget* m_host = nullptr;
    QToolButton* m_more;
    QWidget* m_rest = nullptr;
    bool m_showing = false;
};

} // namespace widgets
