// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/value_label.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

class ValueLabelTest : public ::testing::Test
{
protected:
    ValueLabelTest() { label.setBySentences(true); }

    // The text in a label that is as wide as another text, and a little wider.
    [[nodiscard]] std::string visible(const QString& text, const QString& asWideAs)
    {
        label.setValue(text);
        label.resize(label.fontMetrics().horizontalAdvance(asWideAs) + 8, label.sizeHint().height());
        return label.visibleText().toStdString();
    }

    ValueLabel label{QStringLiteral("A line"), fonts::label(), {}};
};

// Story: below the state FAULT stood "the azimuth does not move: it moved 0.0°…", and the last line of the log ended
// with "Pointing continues, because t…".
// REQ-UI-1717 (ValueLabelTest.*): The reason of the state and the last line of the log do not end within a sentence.
TEST_F(ValueLabelTest, ALineThatIsTooLongEndsWithASentence)
{
    const QString line = QStringLiteral("The mount parks. Is it 1.5 m high? Wait until the wind stays below 10.0 m/s.");
    EXPECT_EQ(visible(line, line), line.toStdString());
    EXPECT_EQ(visible(line, QStringLiteral("The mount parks. Is it 1.5 m high? Wait")),
              "The mount parks. Is it 1.5 m high?");
    EXPECT_EQ(visible(line, QStringLiteral("The mount parks. Is it 1.5")), "The mount parks.");
}

TEST_F(ValueLabelTest, ASentenceThatIsTooLongEndsAtAColon)
{
    EXPECT_EQ(visible(QStringLiteral("the azimuth does not move: it moved 0.0° in 0.80 s"),
                      QStringLiteral("the azimuth does not move: it")),
              "the azimuth does not move");
    EXPECT_EQ(visible(QStringLiteral("Next attempt in 5 s. MQTT broker: No connection"),
                      QStringLiteral("Next attempt in 5 s. MQTT broker: No")),
              "Next attempt in 5 s.")
        << "a sentence before a colon";
}

// Story: the last line of the log read "07:00:22 station Cleared" at 1024 × 700.
TEST_F(ValueLabelTest, AShortWordBeforeAColonIsNotAllThatIsShown)
{
    const QString shown = QString::fromStdString(visible(QStringLiteral("Cleared: This computer stalled for 0.13 s"),
                                                         QStringLiteral("Cleared: This computer stalled")));
    EXPECT_TRUE(shown.startsWith(QStringLiteral("Cleared: This computer"))) << shown.toStdString();
}

TEST_F(ValueLabelTest, ASentenceThatIsTooLongIsCut)
{
    EXPECT_TRUE(
        QString::fromStdString(visible(QStringLiteral("The mount parks. It waits"), QStringLiteral("The mount")))
            .endsWith(QChar(0x2026)));
}

}  // namespace
}  // namespace boresight::ui
