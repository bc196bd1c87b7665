// SPDX-License-Identifier: GPL-3.0-or-later
// The World Magnetic Model 2025 compared with its own published test values. Both files belong to NOAA and are not in
// the source. They are searched beside the checkout, or in the folder named by BORESIGHT_REFERENCE_DATA.
#include "core/base/numbers.h"
#include "core/geomagnetism/coefficient_file.h"
#include "core/geomagnetism/magnetic_model.h"
#include "tests/fakes/reference_data.h"
#include "tests/fakes/text_of.h"

#include <QFile>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <vector>

using namespace boresight;
using namespace boresight::geomagnetism;

namespace {

QString referenceFile(const char* name)
{
    return QString::fromStdString(fakes::referencePath(name));
}

// The 18 numbers of each row: year, km, latitude, longitude, D, I, H, X, Y, Z, F, and the changes of D I H X Y Z F.
std::vector<std::vector<double>> rowsOf(const QString& path)
{
    std::vector<std::vector<double>> rows;
    std::ifstream file(path.toStdString());
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::vector<double> row;
        for (std::string word; !line.starts_with('#') && words >> word;) {
            row.push_back(parseFinite(word).value());
        }
        if (!row.empty()) {
            rows.push_back(row);
        }
    }
    return rows;
}

class OfficialValues : public ::testing::Test
{
protected:
    void SetUp() override
    {
        const QString file = referenceFile("WMM2025.COF");
        if (!QFile::exists(file) || !QFile::exists(referenceFile("WMM2025_TEST_VALUES.txt"))) {
            GTEST_SKIP() << "no " << file.toStdString() << " and its test values (NOAA, World Magnetic Model 2025); "
                         << "set BORESIGHT_REFERENCE_DATA to their folder";
        }
        auto read = readCoefficients(file);
        ASSERT_TRUE(read) << textOf(read.error());
        m_model.emplace(std::move(*read));
    }

    std::optional<MagneticModel> m_model;
};

}  // namespace

// The angles are published to 0.01°, the changes of angles to 0.000001°, and all other values to 0.000001 nT.
// REQ-GEOMAGNETISM-02: The 100 official test values of WMM2025 are met to 0.001 nT, the angles to their last digit.
TEST_F(OfficialValues, AreMetInAllRows)
{
    const auto rows = rowsOf(referenceFile("WMM2025_TEST_VALUES.txt"));
    ASSERT_EQ(rows.size(), 100U);
    double worst = 0.0;
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 18U);
        const Site site{Angle::fromDegrees(row[2]), Angle::fromDegrees(row[3]), 1000.0 * row[1]};
        const auto field = m_model->at(site, row[0]);
        ASSERT_TRUE(field) << textOf(field.error());
        const auto& [now, change] = *field;
        EXPECT_NEAR(now.declination.degrees(), row[4], 0.00501);
        EXPECT_NEAR(now.inclination.degrees(), row[5], 0.00501);
        EXPECT_NEAR(change.declination.degrees(), row[11], 1e-6);
        EXPECT_NEAR(change.inclination.degrees(), row[12], 1e-6);
        const double ours[] = {now.horizontal,    now.north,    now.east,    now.down,    now.total,
                               change.horizontal, change.north, change.east, change.down, change.total};
        const double theirs[] = {row[6], row[7], row[8], row[9], row[10], row[13], row[14], row[15], row[16], row[17]};
        for (std::size_t i = 0; i < std::size(ours); ++i) {
            EXPECT_NEAR(ours[i], theirs[i], 0.001) << "latitude " << row[2] << ", longitude " << row[3] << ", " << i;
            worst = std::max(worst, std::abs(ours[i] - theirs[i]));
        }
    }
    RecordProperty("worst_nT", std::to_string(worst));
}

// In November 2026.
TEST_F(OfficialValues, TellTheDeclinationOfKnownPlaces)
{
    const auto declination = [&](double latitude, double longitude) {
        return m_model->at({Angle::fromDegrees(latitude), Angle::fromDegrees(longitude)}, 2026.88)
            .value()
            .now.declination.degrees();
    };
    EXPECT_NEAR(declination(38.757, -9.117), -0.87, 0.03);
    EXPECT_NEAR(declination(-33.87, 151.21), 12.83, 0.03);
    EXPECT_NEAR(declination(78.23, 15.39), 12.78, 0.03);
}

// The north magnetic pole of the model lies near 86° N, 139° E in 2025 (World Magnetic Model 2025, report): blackout.
// REQ-GEOMAGNETISM-06
TEST_F(OfficialValues, KnowWhereACompassFails)
{
    const auto zone = [&](double latitude, double longitude) {
        return compassZone(
            m_model->at({Angle::fromDegrees(latitude), Angle::fromDegrees(longitude)}, 2025.0).value().now);
    };
    EXPECT_EQ(zone(86.0, 139.0), CompassZone::Blackout);
    EXPECT_EQ(zone(90.0, 0.0), CompassZone::Blackout);
    EXPECT_EQ(zone(76.0, -100.0), CompassZone::Caution);
    EXPECT_EQ(zone(78.23, 15.39), CompassZone::Good);
    EXPECT_EQ(zone(38.757, -9.117), CompassZone::Good);
}

// REQ-GEOMAGNETISM-05
TEST_F(OfficialValues, ArePastFrom2030)
{
    EXPECT_EQ(m_model->name(), "WMM-2025");
    EXPECT_FALSE(m_model->at({}, 2031.5));
    EXPECT_FALSE(m_model->expiry(2029.9).isEmpty());
}
