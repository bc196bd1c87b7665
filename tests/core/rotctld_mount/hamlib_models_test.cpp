// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/hamlib_models.h"

#include <QStandardPaths>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

namespace boresight::rotctl {
namespace {

// From Hamlib 4.5.4 on Debian 12.
const QString kListing = QStringLiteral(
    " Rot #  Mfg                    Model                   Version         Status        Macro\n"
    "     1  Hamlib                 Dummy                   20220531.0      Stable        ROT_MODEL_DUMMY\n"
    "   405  Green Heron            RT-21                   20220104.0      Stable        ROT_MODEL_RT21\n"
    "   901  SPID                   Rot2Prog                20220109.0      Stable        ROT_MODEL_SPID_ROT2PROG\n"
    "  1001  M2                     RC2800                  20210129        Stable        ROT_MODEL_RC2800\n"
    "  1501  DG9OAA                 Ether6 (via ethernet)   20220109.0      Stable        ROT_MODEL_ETHER6\n");

// REQ-ROTCTLDMOUNT-60: The models of Hamlib are read from the output of `rotctl -l`: number, maker and model.
TEST(HamlibModels, AreReadFromTheListing)
{
    EXPECT_EQ(parseModels(kListing),
              (std::vector<RotatorModel>{{1, QStringLiteral("Hamlib Dummy")},
                                         {405, QStringLiteral("Green Heron RT-21")},
                                         {901, QStringLiteral("SPID Rot2Prog")},
                                         {1001, QStringLiteral("M2 RC2800")},
                                         {1501, QStringLiteral("DG9OAA Ether6 (via ethernet)")}}));
}

// REQ-ROTCTLDMOUNT-60
TEST(HamlibModels, WhatIsNoListingHasNone)
{
    for (const char* const text : {"", "\n\n", "rotctl: not found\n", " Rot #  Model  Mfg\n  1 a b\n",
                                   " Rot #  Mfg   Model   Version\n  x  SPID  Rot2    1\n  -3  SPID  Rot2    1\n  7\n",
                                   "     1  Hamlib                 Dummy                   20220531.0\n"}) {
        EXPECT_TRUE(parseModels(QString::fromLatin1(text)).empty()) << text;
    }
}

// REQ-ROTCTLDMOUNT-60
TEST(HamlibModels, ThoseOfThisComputerAreListed)
{
    const RotatorModels models = hamlibModels(std::chrono::minutes(2));
    if (QStandardPaths::findExecutable(QStringLiteral("rotctl")).isEmpty()) {
        EXPECT_TRUE(models.problem.contains(QStringLiteral("libhamlib-utils")));
        GTEST_SKIP() << "rotctl is not installed (Debian package libhamlib-utils)";
    }
    EXPECT_EQ(models.problem, QString());
    for (const int number : {1, 202, 204, 603, 901, 902, 1703}) {
        EXPECT_NE(std::ranges::find(models.list, number, &RotatorModel::number), models.list.end()) << number;
    }
}

}  // namespace
}  // namespace boresight::rotctl
