// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/accessibility.h"

#include <QAccessibleWidget>
#include <QHash>
#include <QWidget>

namespace boresight::ui {

namespace {

// The accessible value of the widget is its description: a readout in words, a picture in numbers.
class Described : public QAccessibleWidget
{
public:
    Described(QWidget* widget, QAccessible::Role role) : QAccessibleWidget(widget, role) {}

    [[nodiscard]] QString text(QAccessible::Text what) const override
    {
        return what == QAccessible::Value ? widget()->accessibleDescription() : QAccessibleWidget::text(what);
    }
};

const QHash<QString, QAccessible::Role>& roles()
{
    static const QHash<QString, QAccessible::Role> all{
        {QStringLiteral("boresight::ui::ValueLabel"), QAccessible::StaticText},
        {QStringLiteral("boresight::ui::PolarPlot"), QAccessible::Chart},
        {QStringLiteral("boresight::ui::PlotEditor"), QAccessible::Graphic},
        {QStringLiteral("boresight::ui::StripCharts"), QAccessible::Chart},
        {QStringLiteral("boresight::ui::CableBar"), QAccessible::Indicator},
        {QStringLiteral("boresight::ui::LimitBar"), QAccessible::Indicator},
        {QStringLiteral("boresight::ui::TurnBar"), QAccessible::Indicator},
        {QStringLiteral("boresight::ui::DirectionArrow"), QAccessible::Graphic},
        {QStringLiteral("boresight::ui::CompassDial"), QAccessible::Dial},
        {QStringLiteral("boresight::ui::LevelBar"), QAccessible::Indicator},
        {QStringLiteral("boresight::ui::DeviationPlot"), QAccessible::Chart},
        {QStringLiteral("boresight::ui::ResidualSky"), QAccessible::Chart},
        {QStringLiteral("boresight::ui::JogPad"), QAccessible::Grouping},
    };
    return all;
}

// Qt asks with the names of the object's class and its base classes, and owns the result.
QAccessibleInterface* describe(const QString& className, QObject* object)
{
    const auto role = roles().constFind(className);
    auto* const widget = qobject_cast<QWidget*>(object);
    return role != roles().constEnd() && widget != nullptr ? new Described(widget, *role) : nullptr;
}

}  // namespace

void describeOwnWidgets()
{
    QAccessible::installFactory(describe);
}

}  // namespace boresight::ui
