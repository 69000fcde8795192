// SPDX-License-Identifier: MIT
#include "widgets/panels/compare/method_form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QLabel>
#include <QVBoxLayout>

#include "core/fitting/method_name.h"
#include "core/text/number_text.h"
#include "widgets/panels/state_colours.h"
#include "widgets/text/local_text.h"
#include "widgets/text/method_text.h"

namespace widgets {

namespace {

/// Where a slider goes; the field beside it takes all that the option takes.
struct SliderRange {
    std::string_view key;
    double low, high, step;
    int decimals;
};
constexpr std::array kSliders{SliderRange{"tau", 0, 90, 2.5, 2},         SliderRange{"lambda", 0, 60, 1, 1},
                              SliderRange{"bins", 0, 32, 1, 0},          SliderRange{"gate", 0, 200, 5, 1},
                              SliderRange{"centre", 0, 0.95, 0.05, 3},   SliderRange{"robust", 0, 20, 0.5, 2},
                              SliderRange{"truncate", 0, 10000, 100, 0}, SliderRange{"epsilon", 0.25, 5, 0.25, 2},
                              SliderRange{"iterations", 1, 60, 1, 0},    SliderRange{"damping", 0, 0.1, 0.001, 4}};
/// Those that come first.
constexpr std::array<std::string_view, 10> kFirst{"tau",  "lambda", "bins",  "gate",     "signed",
                                                  "live", "prior",  "noise", "schedule", "forearm"};

bool comesFirst(const core::MethodOption& option) {
    return std::find(kFirst.begin(), kFirst.end(), option.key) != kFirst.end();
}

SliderRange sliderRange(const core::MethodOption& option) {
    for (const SliderRange& range : kSliders)
        if (range.key == option.key)
            return range;
    const core::OptionDomain& domain = option.domain;
    return {option.key, domain.low, domain.high, domain.isWhole ? 1 : (domain.high - domain.low) / 100,
            domain.isWhole ? 0 : 3};
}

bool isFlag(const core::MethodOption& option) {
    return option.domain.words[0] == "0";
}

} // namespace

MethodForm::MethodForm(QWidget* parent)
    : QWidget(parent)
    , m_more(new QToolButton(this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpacing / 2);
    m_more->setText(tr("More options"));
    m_more->setCheckable(true);
    m_more->setAutoRaise(true);
    m_more->setArrowType(Qt::RightArrow);
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_more->setFocusPolicy(Qt::NoFocus);
    m_more->setToolTip(tr("The options that are seldom changed"));
    connect(m_more, &QToolButton::toggled, this, [this](bool on) {
        m_more->setArrowType(on ? Qt::DownArrow : Qt::RightArrow);
        if (m_rest)
            m_rest->setVisible(on);
    });
    column->addWidget(m_more, 0, Qt::AlignLeft);
    m_more->hide();
}

void MethodForm::setMethod(const std::string& name) {
    m_method = core::parseMethod(name);
    const core::Method plain = core::parseMethod(name.substr(0, name.find(':')));
    if (m_rows.empty() || !(plain == m_plain)) {
        m_plain = plain;
        rebuild();
    }
    showValues();
}

void MethodForm::rebuild() {
    delete m_host;
    delete m_rest;
    m_rows.clear();
    m_host = new QWidget(this);
    m_rest = new QWidget(this);
    for (QWidget* part : {m_host, m_rest}) {
        auto* grid = new QGridLayout(part);
        grid->setContentsMargins(0, 0, 0, 0);
        grid->setHorizontalSpacing(kSpacing);
        grid->setVerticalSpacing(2);
        grid->setColumnStretch(1, 1);
        for (const core::MethodOption& option : core::methodOptions())
            if (option.appliesTo(m_plain) && comesFirst(option) == (part == m_host))
                addRow(option, *grid);
    }
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->insertWidget(0, m_host);
    column->addWidget(m_rest);
    m_rest->setVisible(m_more->isChecked());
    m_more->show();
}

void MethodForm::addRow(const core::MethodOption& option, QGridLayout& grid) {
    const int line = grid.rowCount();
    grid.setRowMinimumHeight(line, QDoubleSpinBox().sizeHint().height()); // also of boxes to tick
    const QString key = toQString(option.key), meaning = optionMeaning(option.key);
    Row row{&option};
    auto* label = new QLabel(key, this);
    label->setToolTip(meaning);
    grid.addWidget(label, line, 0);
    const std::string name(option.key);
    if (option.domain.isNumber()) {
        addNumber(row, grid, line);
    } else if (isFlag(option)) {
        row.flag = new QCheckBox(this);
        row.flag->setToolTip(meaning);
        row.flag->setAccessibleName(key);
        row.flag->setFocusPolicy(Qt::NoFocus);
        grid.addWidget(row.flag, line, 1);
        connect(row.flag, &QCheckBox::toggled, this, [this, name] {
            if (!m_showing)
                emit edited(name);
        });
    } else {
        row.choice = new QComboBox(this);
        for (const std::string_view word : option.domain.words)
            row.choice->addItem(toQString(word));
        row.choice->setToolTip(meaning);
        row.choice->setAccessibleName(key);
        row.choice->setFocusPolicy(Qt::NoFocus);
        grid.addWidget(row.choice, line, 1, 1, 2);
        connect(row.choice, qOverload<int>(&QComboBox::currentIndexChanged), this, [this, name] {
            if (!m_showing)
                emit edited(name);
        });
    }
    m_rows.push_back(row);
}

void MethodForm::addNumber(Row& row, QGridLayout& grid, int line) {
    const core::MethodOption& option = *row.option;
    const SliderRange range = sliderRange(option);
    const bool hasUsual = option.print(m_plain) == "0" && option.domain.low > 0; // the method's own default
    row.sliderStep = range.step;
    row.slider = new QSlider(Qt::Horizontal, this);
    row.slider->setRange(static_cast<int>(std::lround(range.low / range.step)),
                         static_cast<int>(std::lround(range.high / range.step)));
    row.slider->setFocusPolicy(Qt::NoFocus);
    row.slider->setMinimumWidth(60);
    row.number = new QDoubleSpinBox(this);
    row.number->setDecimals(range.decimals);
    row.number->setRange(hasUsual ? 0 : option.domain.low, option.domain.high);
    row.number->setSingleStep(range.step);
    row.number->setAlignment(Qt::AlignRight);
    row.number->setFocusPolicy(Qt::ClickFocus);
    row.number->setKeyboardTracking(false);
    if (hasUsual || option.key == "gate")
        row.number->setSpecialValueText(tr("usual"));
    for (QWidget* part : std::initializer_list<QWidget*>{row.slider, row.number}) {
        part->setToolTip(optionMeaning(option.key));
        part->setAccessibleName(toQString(option.key));
    }
    grid.addWidget(row.slider, line, 1);
    grid.addWidget(row.number, line, 2);
    connect(row.slider, &QSlider::valueChanged, row.number, [this, number = row.number, step = row.sliderStep](int at) {
        if (!m_showing)
            number->setValue(at * step);
    });
    connect(row.number, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this, name = std::string(option.key), slider = row.slider, step = row.sliderStep](double value) {
                if (m_showing)
                    return;
                m_showing = true;
                slider->setValue(static_cast<int>(std::lround(value / step)));
                m_showing = false;
                emit edited(name);
            });
}

void MethodForm::showValues() {
    m_showing = true;
    for (const Row& row : m_rows) {
        const std::string text = row.option->print(m_method);
        const auto& words = row.option->domain.words;
        const int word = text == words[1] ? 1 : 0;
        if (row.flag)
            row.flag->setChecked(word == 1);
        if (row.choice)
            row.choice->setCurrentIndex(word);
        double value = 0;
        if (row.number && core::parseNumber(text, value)) {
            row.number->setValue(value);
            row.slider->setValue(static_cast<int>(std::lround(value / row.sliderStep)));
        }
    }
    m_showing = false;
}

double MethodForm::valueOf(const Row& row) const {
    if (row.number)
        return row.number->value();
    return row.flag ? (row.flag->isChecked() ? 1 : 0) : row.choice->currentIndex();
}

std::string MethodForm::valueText(const Row& row) const {
    if (row.number)
        return core::exactText(row.number->value());
    return std::string(row.option->domain.words[valueOf(row) > 0 ? 1 : 0]);
}

std::string MethodForm::method() const {
    core::Method method = m_plain;
    for (const Row& row : m_rows)
        if (const std::string text = valueText(row); text != row.option->print(m_plain))
            row.option->parse(method, text);
    return core::methodName(method);
}

const MethodForm::Row* MethodForm::rowOf(std::string_view key) const {
    const auto found =
        std::find_if(m_rows.begin(), m_rows.end(), [&](const Row& row) { return row.option->key == key; });
    return found == m_rows.end() ? nullptr : &*found;
}

bool MethodForm::hasOption(std::string_view key) const {
    return rowOf(key) != nullptr;
}

double MethodForm::value(std::string_view key) const {
    const Row* row = rowOf(key);
    return row ? valueOf(*row) : std::nan("");
}

void MethodForm::setValue(std::string_view key, double value) {
    const Row* row = rowOf(key);
    if (!row)
        return;
    if (row->number)
        row->number->setValue(value);
    else if (row->flag)
        row->flag->setChecked(value > 0);
    else
        row->choice->setCurrentIndex(value > 0 ? 1 : 0);
}

} // namespace widgets
