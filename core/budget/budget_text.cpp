// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/budget/budget_text.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <QStringList>

namespace boresight::budget {

namespace {

constexpr double kNoLoss = 0.05;  // dB, shown as 0.0 dB

}  // namespace

QString nameOf(ErrorPart part)
{
    switch (part) {
        case ErrorPart::Servo:
            return Text::tr("Servo");
        case ErrorPart::Way:
            return Text::tr("Way to the target");
        case ErrorPart::Stream:
            return Text::tr("Between points");
        case ErrorPart::Clock:
            return Text::tr("Clock");
        case ErrorPart::Elements:
            return Text::tr("Age of elements");
        case ErrorPart::Calibration:
            return Text::tr("Calibration");
        case ErrorPart::Wind:
            return Text::tr("Wind");
    }
    return {};
}

QByteArray keyOf(ErrorPart part)
{
    switch (part) {
        case ErrorPart::Servo:
            return "servo";
        case ErrorPart::Way:
            return "way";
        case ErrorPart::Stream:
            return "stream";
        case ErrorPart::Clock:
            return "clock";
        case ErrorPart::Elements:
            return "elements";
        case ErrorPart::Calibration:
            return "calibration";
        case ErrorPart::Wind:
            return "wind";
    }
    return {};
}

QString lossText(const std::optional<double>& loss)
{
    if (!loss) {
        return {};
    }
    return (*loss < kNoLoss ? QStringLiteral("%1 dB") : QStringLiteral("-%1 dB")).arg(*loss, 0, 'f', 1);
}

QString sumText(const ErrorBudget& budget)
{
    const QString sum = degreesText(budget.sum, 2);
    return budget.isWhole ? sum : Text::tr("at least %1").arg(sum);
}

QString offByText(const ErrorBudget& budget)
{
    return Text::tr("Off by %1 (%2)")
        .arg(sumText(budget), budget.loss ? lossText(budget.loss) : Text::tr("beyond the main lobe"));
}

QString errorText(const ErrorLine& line)
{
    return line.error                     ? degreesText(*line.error, 3)
           : line.part == ErrorPart::Wind ? Text::tr("not in the sum")
                                          : Text::tr("unknown");
}

QString listText(const ErrorBudget& budget)
{
    QStringList lines;
    for (const ErrorLine& line : budget.lines) {
        lines << QStringLiteral("%1: %2. %3").arg(nameOf(line.part), errorText(line), line.basis);
    }
    lines << offByText(budget);
    return lines.join(QLatin1Char('\n'));
}

}  // namespace boresight::budget
