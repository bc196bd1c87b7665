// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/go_to_bar.h"

#include "core/base/numbers.h"
#include "ui/jog/nearest_offer.h"
#include "ui/jog/select_by_click.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/touch_combo.h"
#include "ui/kit/value_label.h"
#include "ui/look/paint.h"

#include <QAbstractItemView>
#include <QHBoxLayout>
#include <QLineEdit>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr qsizetype kRecent = 10;

QLineEdit* angleField(const QString& name, QWidget* parent)
{
    auto* const field = new QLineEdit(parent);
    field->setFont(fonts::text());
    field->setAccessibleName(name);
    field->setToolTip(GoToBar::tr("%1 in degrees, for example 113.5 (Ctrl+G, then Enter to go)").arg(name));
    field->setAlignment(Qt::AlignRight);
    field->setMaxLength(12);
    field->setMinimumHeight(kTouchSize);
    field->setFixedWidth(field->fontMetrics().horizontalAdvance(QStringLiteral("-000.00")) + 2 * kGrid);
    new SelectByClick(*field);
    return field;
}

QString fixed(Angle angle)
{
    return QString::fromStdString(formatFixed(angle.degrees(), 2));
}

// Empty if nothing or no number is typed.
std::optional<Angle> typed(const QLineEdit& field)
{
    const auto number = parseFinite(field.text().trimmed().toStdString());
    return number ? std::optional(Angle::fromDegrees(*number)) : std::nullopt;
}

// A file that was edited by hand may contain anything.
QStringList readable(const QStringList& lines)
{
    QStringList kept;
    std::ranges::copy_if(lines, std::back_inserter(kept), [](const QString& line) {
        const QStringList numbers = line.split(QLatin1Char(' '));
        return numbers.size() == 2 && std::ranges::all_of(numbers, [](const QString& number) {
                   return parseFinite(number.toStdString()).has_value();
               });
    });
    return kept.mid(0, kRecent);
}

}  // namespace

GoToBar::GoToBar(RequestDesk& desk, ValueLabel& notice, NearestOffer& offer, const QStringList& recent, QWidget* parent)
    : QWidget(parent),
      m_notice(notice),
      m_offer(offer),
      m_azimuth(angleField(tr("Azimuth"), this)),
      m_elevation(angleField(tr("Elevation"), this)),
      m_go(new CommandButton(tr("Go"), tr("Go to this direction by the shortest way (Enter)"), desk, notice, this)),
      m_recentBox(new TouchCombo(tr("Recent directions"),
                                 tr("Copy a recent direction into the fields. Nothing moves before Go."), this)),
      m_recent(readable(recent))
{
    build();
    showRecent();
    connect(m_go, &QPushButton::clicked, this, &GoToBar::go);
    connect(m_go, &CommandButton::accepted, this, &GoToBar::leaveFields);
    connect(m_go, &CommandButton::accepted, this, &GoToBar::remember);
    connect(m_go, &CommandButton::refused, this, &GoToBar::offerNearest);
    connect(m_azimuth, &QLineEdit::returnPressed, this, &GoToBar::go);
    connect(m_elevation, &QLineEdit::returnPressed, this, &GoToBar::go);
    for (const QLineEdit* const field : {m_azimuth, m_elevation}) {
        connect(field, &QLineEdit::textEdited, this, &GoToBar::forgetRefusal);  // the refusal was about other numbers
    }
    connect(m_recentBox, &QComboBox::activated, this, &GoToBar::fillIn);
}

void GoToBar::build()
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid / 2);
    row->addWidget(makeCaption(tr("Go to"), *m_azimuth));
    for (const auto& [text, field] : {std::pair(tr("Az"), m_azimuth), std::pair(tr("El"), m_elevation)}) {
        field->setPlaceholderText(text + QStringLiteral(" °"));
        row->addWidget(field);
    }
    row->addWidget(m_go);
    row->addWidget(m_recentBox);
    row->addStretch(1);
    setEmphasis(*m_go, Emphasis::Primary);
    m_recentBox->setMinimumContentsLength(0);  // its lines are wider than the box
    m_recentBox->setFixedWidth(kTouchSize);
}

void GoToBar::setBlocked(const QString& reason)
{
    m_go->setBlocked(reason);
    m_offer.setBlocked(reason);
}

void GoToBar::focusFields()
{
    m_azimuth->setFocus(Qt::ShortcutFocusReason);
    m_azimuth->selectAll();
}

void GoToBar::complain(QLineEdit& field, const QString& text)
{
    m_notice.setValue(text, Tone::Warning, Symbol::Warning);
    field.setFocus();
    field.selectAll();
}

void GoToBar::forgetRefusal()
{
    m_notice.setValue({});
    m_offer.drop();
}

void GoToBar::go()
{
    m_offer.drop();
    if (!m_go->isEnabled()) {
        m_notice.setValue(m_go->toolTip(), Tone::Warning, Symbol::Warning);
        return;
    }
    if (!isNumber(*m_azimuth,
                  tr("Go: The azimuth is not a number. Type it with a decimal point, for example 113.5.")) ||
        !isNumber(*m_elevation,
                  tr("Go: The elevation is not a number. Type it with a decimal point, for example 10.5."))) {
        return;
    }
    const auto azimuth = typed(*m_azimuth);
    const auto elevation = typed(*m_elevation);
    if (!azimuth && !elevation) {
        complain(*m_azimuth, tr("Go: Enter an azimuth, an elevation or both."));
        return;
    }
    m_asked = {azimuth, elevation};
    if (azimuth && elevation) {
        m_go->ask(request::PointSky{{*azimuth, *elevation}});
    } else {
        m_go->ask(azimuth ? request::PointAxis{Axis::Azimuth, *azimuth}
                          : request::PointAxis{Axis::Elevation, *elevation});
    }
}

// An axis that was not typed stays where it is, so its angle is a part of the refused direction.
void GoToBar::offerNearest()
{
    const bool isWhole = m_asked.azimuth && m_asked.elevation;
    if (isWhole || m_present) {
        const SkyPointing present = m_present.value_or(SkyPointing{});
        m_offer.offerFor({m_asked.azimuth.value_or(present.azimuth), m_asked.elevation.value_or(present.elevation)});
    }
}

std::optional<Angle> GoToBar::azimuth() const
{
    return typed(*m_azimuth);
}

// An empty field is valid: its axis stays where it is.
bool GoToBar::isNumber(QLineEdit& field, const QString& otherwise)
{
    if (field.text().trimmed().isEmpty() || typed(field)) {
        return true;
    }
    complain(field, otherwise);
    return false;
}

// Moves the focus away, so that the next Esc stops the mount. With the focus in a field, Esc would only leave the
// field.
void GoToBar::leaveFields()
{
    if (m_azimuth->hasFocus() || m_elevation->hasFocus()) {
        m_go->setFocus();
    }
}

void GoToBar::remember()
{
    if (!m_asked.azimuth || !m_asked.elevation) {
        return;  // one axis alone is no direction
    }
    const QString line = fixed(*m_asked.azimuth) + QLatin1Char(' ') + fixed(*m_asked.elevation);
    m_recent.removeAll(line);
    m_recent.prepend(line);
    m_recent = m_recent.mid(0, kRecent);
    showRecent();
    Q_EMIT recentChanged(m_recent);
}

void GoToBar::showRecent()
{
    QStringList lines;
    for (const QString& one : m_recent) {
        lines += tr("az %1°  el %2°").arg(one.section(QLatin1Char(' '), 0, 0), one.section(QLatin1Char(' '), 1, 1));
    }
    m_recentBox->setLines(lines);
    m_recentBox->setEnabled(!lines.isEmpty());
    const QFontMetrics metrics = m_recentBox->fontMetrics();
    m_recentBox->view()->setMinimumWidth(
        metrics.horizontalAdvance(lines.isEmpty() ? QString() : tr("az %1°  el %2°").arg(u"-000.00", u"-000.00")) +
        4 * kGrid);
}

void GoToBar::fillIn(int recent)
{
    const QString line = m_recent.value(recent);
    m_azimuth->setText(line.section(QLatin1Char(' '), 0, 0));
    m_elevation->setText(line.section(QLatin1Char(' '), 1, 1));
    m_recentBox->setCurrentIndex(-1);
    m_go->setFocus();
}

}  // namespace boresight::ui

#include "moc_go_to_bar.cpp"
