// SPDX-License-Identifier: MIT
#include "app/desktop/script/benchmark_steps.h"

#include <algorithm>
#include <cmath>

#include <QJsonArray>

#include "app/desktop/main_window.h"
#include "app/desktop/script/idle_wait.h"
#include "app/desktop/script/step_fields.h"
#include "core/error.h"
#include "widgets/text/error_text.h"

namespace app {

namespace {

constexpr int kReadingMs = 10 * 60 * 1000;

core::Error senseless(const char* field, const QString& why) {
    return {core::ErrorCode::Usage, {}, field, why.toStdString()};
}

widgets::BenchmarkPairsView& shownPairs(MainWindow& window) {
    if (!window.session().benchmarks.results())
        throw senseless("do", QStringLiteral("there are no results of a benchmark"));
    return *window.workspaces().benchmarkPage()->results()->pairs();
}

/// The pair in a row of the table.
std::size_t pairOfRow(const widgets::BenchmarkPairsView& view, const QJsonValue& row, const char* field) {
    const int number = row.toInt(-1);
    if (number < 0 || number >= view.model().rowCount())
        throw senseless(field, QStringLiteral("the table has rows 0..%1").arg(view.model().rowCount() - 1));
    return view.model().shown()[static_cast<std::size_t>(number)];
}

void sortPairs(widgets::BenchmarkPairsView& view, const QJsonObject& step) {
    const QString name = textField(step, "sort");
    const auto quantity = core::parsePairQuantity(name.toStdString(), *view.model().table(), view.model().compared());
    const bool ascending = step.value(QLatin1String("ascending")).toBool(false);
    if (!quantity || !view.sortBy(*quantity, ascending ? Qt::AscendingOrder : Qt::DescendingOrder))
        throw senseless("sort", QStringLiteral("the table has no column \"%1\"").arg(name));
}

QJsonValue finiteOrNull(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

} // namespace

QJsonObject openResults(MainWindow& window, const QDir& out, const QJsonObject& step) {
    widgets::BenchmarkRunner& runner = window.session().benchmarks;
    QString error, note;
    bool ended = false;
    QObject scope;
    QObject::connect(&runner, &widgets::BenchmarkRunner::opened, &scope, [&](const QString&, const QString& said) {
        note = said;
        ended = true;
    });
    QObject::connect(&runner, &widgets::BenchmarkRunner::fileFailed, &scope, [&](const QString& message) {
        error = widgets::withDetailBehind(message);
        ended = true;
    });
    runner.open(out.absoluteFilePath(textField(step, "open")));
    waitFor(
        window, [&ended] { return ended; }, kReadingMs);
    if (!ended || !error.isEmpty())
        throw senseless("open", ended ? error : QStringLiteral("no answer in time"));
    QJsonArray methods;
    for (const std::string& method : runner.results()->methods)
        methods.append(QString::fromStdString(method));
    return {{QStringLiteral("pairs"), static_cast<int>(runner.pairTable()->pairs.size())},
            {QStringLiteral("results"), static_cast<int>(runner.results()->rows.size())},
            {QStringLiteral("methods"), methods},
            {QStringLiteral("note"), note}};
}

QJsonObject showPairs(MainWindow& window, const QJsonObject& step) {
    widgets::BenchmarkPairsView& view = shownPairs(window);
    window.workspaces().setCurrent(widgets::Workspaces::Kind::Benchmark);
    window.workspaces().benchmarkPage()->results()->showPairPlots();
    const auto has = [&step](const char* field) { return step.contains(QLatin1String(field)); };
    if (has("a") || has("b")) {
        const auto name = [&](const char* field, std::size_t current) {
            return has(field) ? textField(step, field) : QString::fromStdString(view.model().table()->methods[current]);
        };
        if (!view.setCompared(name("a", view.model().compared().a), name("b", view.model().compared().b)))
            throw senseless(has("a") ? "a" : "b", QStringLiteral("the results have no such method"));
    }
    if (has("filter")) {
        const bool isNone = step.value(QLatin1String("filter")).toString() == QLatin1String("");
        const QString problem = view.setFilter(isNone ? QString() : textField(step, "filter"));
        if (!problem.isEmpty())
            throw senseless("filter", problem);
    }
    if (has("sort"))
        sortPairs(view, step);
    if (has("select")) {
        std::vector<std::size_t> pairs;
        for (const QJsonValue& row : step.value(QLatin1String("select")).toArray())
            pairs.push_back(pairOfRow(view, row, "select"));
        view.select(pairs);
    }
    const QJsonObject answer{{QStringLiteral("shown"), view.model().rowCount()},
                             {QStringLiteral("of"), static_cast<int>(view.model().table()->pairs.size())}};
    if (has("inspect"))
        window.workspaces().benchmarkPage()->results()->openPair(
            pairOfRow(view, step.value(QLatin1String("inspect")), "inspect"));
    return answer;
}

QJsonObject printPairs(MainWindow& window, const QJsonObject& step) {
    const widgets::PairTableModel& model = shownPairs(window).model();
    const core::PairTable& table = *model.table();
    const int most = std::clamp(intField(step, "most", model.rowCount()), 0, model.rowCount());
    QJsonArray rows;
    for (int row = 0; row < most; ++row) {
        const std::size_t pair = model.shown()[static_cast<std::size_t>(row)];
        QJsonObject errors;
        for (std::size_t method = 0; method < table.methods.size(); ++method)
            errors[QString::fromStdString(table.methods[method])] = finiteOrNull(table.columns[method].errorMm[pair]);
        rows.append(QJsonObject{{QStringLiteral("sequence"), QString::fromStdString(table.pairs[pair].sequence)},
                                {QStringLiteral("start"), table.pairs[pair].start},
                                {QStringLiteral("test"), table.pairs[pair].test},
                                {QStringLiteral("initialErrorMm"), finiteOrNull(table.startErrorMm[pair])},
                                {QStringLiteral("errorMm"), errors}});
    }
    return {{QStringLiteral("pairs"), rows}};
}

} // namespace app
