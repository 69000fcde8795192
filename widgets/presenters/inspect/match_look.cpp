// SPDX-License-Identifier: MIT
#include "widgets/presenters/inspect/match_look.h"

#include <algorithm>
#include <string>

#include "core/hand/hand_chains.h"
#include "widgets/text/local_text.h"
#include "widgets/views/joint_colours.h"

namespace widgets {

namespace {

constexpr LocalText matchWords{"widgets::MatchLook"};
constexpr LocalText probeWords{"widgets::InspectProbe"};

constexpr std::array kPartTexts{
    QT_TRANSLATE_NOOP("widgets::MatchLook", "thumb"),  QT_TRANSLATE_NOOP("widgets::MatchLook", "index"),
    QT_TRANSLATE_NOOP("widgets::MatchLook", "middle"), QT_TRANSLATE_NOOP("widgets::MatchLook", "ring"),
    QT_TRANSLATE_NOOP("widgets::MatchLook", "little"), QT_TRANSLATE_NOOP("widgets::MatchLook", "palm")};
constexpr std::array kChoiceIds{"distance", "finger", "thumb", "index", "middle", "ring", "little", "palm"};
constexpr std::size_t kFirstPart = 2; ///< of the choices

} // namespace

HandPart handPart(const core::HandModel& hand, std::uint8_t bone) {
    if (bone >= hand.skeleton.bones.size())
        return HandPart::Palm;
    const std::string& name = hand.skeleton.bones[bone].name;
    for (std::size_t finger = 0; finger < core::kFingers.size(); ++finger)
        if (name.compare(0, name.find('_'), core::kFingers[finger]) == 0)
            return static_cast<HandPart>(finger);
    return HandPart::Palm;
}

QColor handPartColour(HandPart part) {
    return fingerColour(part == HandPart::Palm ? std::string_view("wrist")
                                               : core::kFingers[static_cast<std::size_t>(part)]);
}

QString handPartText(HandPart part) {
    return matchWords(kPartTexts[static_cast<std::size_t>(part)]);
}

QString matchChoiceId(MatchChoice choice) {
    return QLatin1String(kChoiceIds[static_cast<std::size_t>(choice)]);
}

std::optional<MatchChoice> matchChoiceOf(const QString& id) {
    for (const MatchChoice choice : kMatchChoices)
        if (matchChoiceId(choice) == id)
            return choice;
    return std::nullopt;
}

QString matchChoiceText(MatchChoice choice) {
    switch (choice) {
    case MatchChoice::ByDistance:
        return matchWords(QT_TRANSLATE_NOOP("widgets::MatchLook", "All, by distance"));
    case MatchChoice::ByFinger:
        return matchWords(QT_TRANSLATE_NOOP("widgets::MatchLook", "All, by finger"));
    default:
        break;
    }
    const auto part = static_cast<HandPart>(static_cast<std::size_t>(choice) - kFirstPart);
    return matchWords(QT_TRANSLATE_NOOP("widgets::MatchLook", "Only: %1")).arg(handPartText(part));
}

bool isChosen(MatchChoice choice, HandPart part) {
    const auto index = static_cast<std::size_t>(choice);
    return index < kFirstPart || index - kFirstPart == static_cast<std::size_t>(part);
}

// Of the colours of Okabe and Ito those that neither the scale of distances nor the outline's red and blue is near to.
RefusalLook refusalLook(core::MatchVerdict verdict) {
    switch (verdict) {
    case core::MatchVerdict::Gate:
        return {QColor(0xFF, 0x9E, 0xE6), Qt::DotLine};
    case core::MatchVerdict::Truncated:
        return {QColor(0xFF, 0xA0, 0x20), Qt::DashDotLine};
    case core::MatchVerdict::EmptyBin:
        return {QColor(0xFF, 0xFF, 0xFF), Qt::SolidLine};
    case core::MatchVerdict::Forearm:
        return {QColor(0x9A, 0xA0, 0xA6), Qt::DashDotDotLine};
    case core::MatchVerdict::Orientation:
    case core::MatchVerdict::Kept:
        break;
    }
    return {QColor(0xFF, 0x4D, 0x3D), Qt::DashLine};
}

QString verdictInWords(core::MatchVerdict verdict) {
    switch (verdict) {
    case core::MatchVerdict::Orientation:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "the directions differ"));
    case core::MatchVerdict::Gate:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "beyond the gate"));
    case core::MatchVerdict::Truncated:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "too far to count"));
    case core::MatchVerdict::EmptyBin:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "no outline in this bin"));
    case core::MatchVerdict::Forearm:
        return probeWords(QT_TRANSLATE_NOOP("widgets::InspectProbe", "beyond the end of the hand"));
    case core::MatchVerdict::Kept:
        break;
    }
    return {};
}

} // namespace widgets
