// SPDX-License-Identifier: MIT
#include "widgets/text/method_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QStringList>

#include "core/fitting/method_name.h"
#include "core/fitting/method_options.h"
#include "widgets/text/local_text.h"

namespace widgets {

namespace {

constexpr LocalText methodWords{"widgets::MethodText"};

using Meaning = std::pair<std::string_view, const char*>;

// clang-format off
constexpr std::array kMeanings{
    Meaning{"tau", QT_TRANSLATE_NOOP("widgets::MethodText", "A match is kept if the directions differ by less, degrees")},
    Meaning{"signed", QT_TRANSLATE_NOOP("widgets::MethodText", "Directions over 360 degrees; off: lines over 180 degrees")},
    Meaning{"lambda", QT_TRANSLATE_NOOP("widgets::MethodText", "Weight of the direction, pixels per radian")},
    Meaning{"bins", QT_TRANSLATE_NOOP("widgets::MethodText", "Bins of direction")},
    Meaning{"centre", QT_TRANSLATE_NOOP("widgets::MethodText", "Where the bins are centred: 0 on the x axis, or that share of a bin beside it")},
    Meaning{"weights", QT_TRANSLATE_NOOP("widgets::MethodText", "The two matches weigh by how near their bins are")},
    Meaning{"backend", QT_TRANSLATE_NOOP("widgets::MethodText", "How matches are searched: both find the same ones")},
    Meaning{"live", QT_TRANSLATE_NOOP("widgets::MethodText", "The real-time variant")},
    Meaning{"palm", QT_TRANSLATE_NOOP("widgets::MethodText", "The palm is placed before the fingers move")},
    Meaning{"coarse", QT_TRANSLATE_NOOP("widgets::MethodText", "Coarse levels of the mesh first")},
    Meaning{"wide", QT_TRANSLATE_NOOP("widgets::MethodText", "Tau narrows from 45 degrees to 22.5")},
    Meaning{"across", QT_TRANSLATE_NOOP("widgets::MethodText", "The distance along the outline counts a tenth")},
    Meaning{"prior", QT_TRANSLATE_NOOP("widgets::MethodText", "A weak pull of the angles to those of the start")},
    Meaning{"learnt", QT_TRANSLATE_NOOP("widgets::MethodText", "The pull knows how fingers move together")},
    Meaning{"restarts", QT_TRANSLATE_NOOP("widgets::MethodText", "Other starts where silhouettes are left unexplained")},
    Meaning{"apart", QT_TRANSLATE_NOOP("widgets::MethodText", "Fingers and hands do not penetrate each other on the way from other starts")},
    Meaning{"polish", QT_TRANSLATE_NOOP("widgets::MethodText", "The last iterations on the full mesh")},
    Meaning{"noise", QT_TRANSLATE_NOOP("widgets::MethodText", "What counts as a difference follows the noise of the outlines")},
    Meaning{"both", QT_TRANSLATE_NOOP("widgets::MethodText", "Contour points pull the model, too")},
    Meaning{"within", QT_TRANSLATE_NOOP("widgets::MethodText", "Only contour points within tau are searched")},
    Meaning{"robust", QT_TRANSLATE_NOOP("widgets::MethodText", "Cauchy weights with that scale, mm; 0 for none")},
    Meaning{"gate", QT_TRANSLATE_NOOP("widgets::MethodText", "Longest distance of a match, pixels; 0 for the usual one")},
    Meaning{"truncate", QT_TRANSLATE_NOOP("widgets::MethodText", "K of the truncated penalty, square pixels; 0 for none")},
    Meaning{"epsilon", QT_TRANSLATE_NOOP("widgets::MethodText", "How far the outline's polygon may be off, pixels")},
    Meaning{"tangent", QT_TRANSLATE_NOOP("widgets::MethodText", "The outline's direction from its polygon or from a chord")},
    Meaning{"forearm", QT_TRANSLATE_NOOP("widgets::MethodText", "Contour beyond the end of a hand model: left out, or as any other")},
    Meaning{"iterations", QT_TRANSLATE_NOOP("widgets::MethodText", "Most iterations of a fit")},
    Meaning{"damping", QT_TRANSLATE_NOOP("widgets::MethodText", "Damping relative to the diagonal of the normal matrix")},
    Meaning{"schedule", QT_TRANSLATE_NOOP("widgets::MethodText", "rigid: a first phase moves each hand as a whole; paper: all at once")},
};
// clang-format on

QString limitText(double value) {
    return QLocale().toString(value, 'g', 6);
}

/// What values the option takes, as a sentence about a wrong one.
QString domainProblem(const core::MethodOption& option, const QString& value) {
    const core::OptionDomain& domain = option.domain;
    const QString key = toQString(option.key);
    if (!domain.isNumber())
        return methodWords(QT_TRANSLATE_NOOP("widgets::MethodText", "%1 must be %2 or %3, not \"%4\"."))
            .arg(key, toQString(domain.words[0]), toQString(domain.words[1]), value);
    const QString sentence =
        domain.isWhole
            ? methodWords(
                  QT_TRANSLATE_NOOP("widgets::MethodText", "%1 must be a whole number from %2 to %3, not \"%4\"."))
            : methodWords(QT_TRANSLATE_NOOP("widgets::MethodText", "%1 must be a number from %2 to %3, not \"%4\"."));
    return sentence.arg(key, limitText(domain.low), limitText(domain.high), value);
}

QString optionProblem(core::Method& method, const QString& name, const QString& part) {
    const QString key = part.section(QLatin1Char('='), 0, 0), value = part.section(QLatin1Char('='), 1);
    if (!part.contains(QLatin1Char('=')))
        return methodWords(QT_TRANSLATE_NOOP("widgets::MethodText", "Write \"%1\" as name=value.")).arg(part);
    QStringList known;
    for (const core::MethodOption& option : core::methodOptions()) {
        if (!option.appliesTo(method))
            continue;
        if (toQString(option.key) == key)
            return option.parse(method, value.toStdString()).empty() ? QString() : domainProblem(option, value);
        known << toQString(option.key);
    }
    return methodWords(QT_TRANSLATE_NOOP("widgets::MethodText", "%1 has no option \"%2\"; it has %3."))
        .arg(name, key, known.join(QStringLiteral(", ")));
}

} // namespace

QString optionMeaning(std::string_view key) {
    const auto found =
        std::find_if(kMeanings.begin(), kMeanings.end(), [&](const Meaning& meaning) { return meaning.first == key; });
    return found == kMeanings.end() ? QString() : methodWords(found->second);
}

QString methodProblem(const QString& method) {
    const QStringList parts = method.split(QLatin1Char(':'));
    const std::vector<std::string> names = core::plainMethodNames();
    if (std::find(names.begin(), names.end(), parts.front().toStdString()) == names.end()) {
        QStringList known;
        for (const std::string& name : names)
            known << QString::fromStdString(name);
        return methodWords(QT_TRANSLATE_NOOP("widgets::MethodText", "\"%1\" is not a method; the methods are %2."))
            .arg(parts.front(), known.join(QStringLiteral(", ")));
    }
    core::Method parsed = core::parseMethod(parts.front().toStdString());
    for (int i = 1; i < parts.size(); ++i)
        if (const QString problem = optionProblem(parsed, parts.front(), parts[i]); !problem.isEmpty())
            return problem;
    return {};
}

} // namespace widgets
