// SPDX-License-Identifier: MIT
#include "widgets/views/joint_colours.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace {

using namespace widgets;

TEST(JointColours, FingersHaveTheirOwn) {
    EXPECT_EQ(fingerColour("thumb_ip"), QColor(0xE6, 0x9F, 0x00));
    EXPECT_EQ(fingerColour("index_mcp"), QColor(0x56, 0xB4, 0xE9));
    EXPECT_EQ(fingerColour("middle_tip"), QColor(0x00, 0x9E, 0x73));
    EXPECT_EQ(fingerColour("ring_dip"), QColor(0xF0, 0xE4, 0x42));
    EXPECT_EQ(fingerColour("little_cmc"), QColor(0xCC, 0x79, 0xA7));
    for (const char* other : {"wrist", "forearm", "", "elbow_1"})
        EXPECT_EQ(fingerColour(other), QColor(0xBB, 0xBB, 0xBB));
}

TEST(JointColours, MethodsKeepTheirsWhateverTheirOptions) {
    EXPECT_EQ(methodColour("dch-thres:tau=45:signed=0"), QColor(0x56, 0xB4, 0xE9));
    EXPECT_EQ(methodColour("best:live=1"), methodColour("best"));
    std::set<QRgb> all;
    for (const char* name : {"start", "truth", "ch", "dch-thres", "dch-quant", "dch-quant2", "dch-dt3", "best"})
        all.insert(methodColour(name).rgb());
    EXPECT_EQ(all.size(), 8u);
}

double luminance(const QColor& c) {
    return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF();
}

TEST(JointColours, ErrorsGetLighterAllTheWay) {
    for (int i = 0; i < 100; ++i)
        EXPECT_LT(luminance(errorColour(i / 100.0)), luminance(errorColour((i + 1) / 100.0)) + 1e-3) << i;
    EXPECT_EQ(errorColour(-3), errorColour(0));
    EXPECT_EQ(errorColour(7), errorColour(1));
    EXPECT_EQ(errorColour(NAN), errorColour(0));
}

TEST(JointColours, OrientationHasNoSeam) {
    for (double a = -7; a < 7; a += 0.01) {
        EXPECT_EQ(orientationColour(a).rgb(), orientationColour(a + 4 * M_PI).rgb());
        const QColor here = orientationColour(a), next = orientationColour(a + 0.01);
        EXPECT_LT(std::abs(here.redF() - next.redF()) + std::abs(here.greenF() - next.greenF()) +
                      std::abs(here.blueF() - next.blueF()),
                  0.05)
            << a;
    }
    EXPECT_NE(orientationColour(0).rgb(), orientationColour(M_PI).rgb());
}

} // namespace
