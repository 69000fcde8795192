// SPDX-License-Identifier: MIT
#include "widgets/views/joint_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace widgets {

namespace {

using NamedColour = std::pair<std::string_view, QRgb>;

// Okabe and Ito's palette: told apart with every common kind of colour vision.
constexpr std::array kFingers{NamedColour{"thumb", 0xFFE69F00}, NamedColour{"index", 0xFF56B4E9},
                              NamedColour{"middle", 0xFF009E73}, NamedColour{"ring", 0xFFF0E442},
                              NamedColour{"little", 0xFFCC79A7}};
constexpr QRgb kOtherJoint = 0xFFBBBBBB;

constexpr std::array kMethods{
    NamedColour{"start", 0xFF9AA0A6},      NamedColour{"truth", 0xFFFFFFFF},     NamedColour{"recorded", 0xFFE8EAEE},
    NamedColour{"ch", 0xFFE69F00},         NamedColour{"dch-thres", 0xFF56B4E9}, NamedColour{"dch-quant", 0xFFCC79A7},
    NamedColour{"dch-quant2", 0xFFD55E00}, NamedColour{"dch-dt3", 0xFF009E73},   NamedColour{"best", 0xFFF0E442}};
constexpr QRgb kOtherMethod = 0xFF7F9FD5;

// cividis at nine equal steps (Nunez, Anderton and Renslow 2018).
constexpr std::array<QRgb, 9> kCividis{0xFF00224E, 0xFF123570, 0xFF3B496C, 0xFF575D6D, 0xFF707173,
                                       0xFF8A8678, 0xFFA59C74, 0xFFC3B369, 0xFFFEE838};

QColor mixed(QRgb a, QRgb b, double t) {
    const auto mix = [t](int x, int y) { return static_cast<int>(std::lround(x + t * (y - x))); };
    return QColor(mix(qRed(a), qRed(b)), mix(qGreen(a), qGreen(b)), mix(qBlue(a), qBlue(b)));
}

template <std::size_t N>
QColor find(const std::array<NamedColour, N>& table, std::string_view name, QRgb otherwise) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const NamedColour& c) { return c.first == name; });
    return QColor::fromRgb(found == table.end() ? otherwise : found->second);
}

} // namespace

QColor fingerColour(std::string_view joint) {
    return find(kFingers, joint.substr(0, joint.find('_')), kOtherJoint);
}

QColor methodColour(std::string_view method) {
    return find(kMethods, method.substr(0, method.find(':')), kOtherMethod);
}

QColor errorColour(double t) {
    constexpr int kLast = static_cast<int>(kCividis.size()) - 1;
    const double position = std::clamp(std::isnan(t) ? 0.0 : t, 0.0, 1.0) * kLast;
    const int below = std::min(static_cast<int>(position), kLast - 1);
    return mixed(kCividis[static_cast<std::size_t>(below)], kCividis[static_cast<std::size_t>(below) + 1],
                 position - below);
}

QColor orientationColour(double angleRad) {
    const double turn = angleRad / (2 * M_PI);
    // Equal lightness would waste it on dark footage; a gentle wave keeps opposite directions apart in grey, too.
    const double hue = turn - std::floor(turn);
    const double lightness = 0.62 + 0.10 * std::cos(2 * M_PI * hue);
    return QColor::fromHslF(hue, 0.62, lightness);
}

} // namespace widgets
