// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/body_box.h"

#include "core/units/angle_between.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/touch_combo.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"

#include <QCheckBox>
#include <QGridLayout>

namespace boresight::ui {

namespace {
constexpr ephemeris::Refraction kRefractions[] = {ephemeris::Refraction::Light, ephemeris::Refraction::Radio,
                                                  ephemeris::Refraction::None};
constexpr int kComboLetters = 7;  // in widths of X: the widest text is narrower
}  // namespace

BodyBox::BodyBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_where(new ValueLabel(tr("Position of the body"), fonts::label(), {}, this)),
      m_follow(new CommandButton(tr("Track Sun"), {}, desk, notice, this)),
      m_take(new CommandButton(tr("Take point"), tr("The target is centred now. Store the position of the axes"), desk,
                               notice, this)),
      m_refraction(new TouchCombo(tr("Refraction"),
                                  tr("Refraction of the air: optical for a shadow, radio for the power"), this)),
      m_overTheTop(new QCheckBox(tr("Over the top"), this))
{
    build();
    connect(m_overTheTop, &QCheckBox::toggled, this, &BodyBox::describe);
    connect(m_follow, &QPushButton::clicked, this, &BodyBox::followOrHold);
    connect(m_take, &QPushButton::clicked, this, [this] { m_take->ask(request::TakePoint{}); });
}

void BodyBox::build()
{
    m_where->setStretching(true);
    m_where->setLines(4);
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(2);
    grid->addWidget(m_where, 0, 0, 1, 3);
    grid->addWidget(m_follow, 1, 0);
    grid->addWidget(m_take, 1, 1);
    grid->addWidget(m_refraction, 1, 2);
    grid->addWidget(m_overTheTop, 2, 0, 1, 3);
    m_overTheTop->setToolTip(
        tr("The antenna points from the other side, with the boom past the zenith. This separates north from "
           "collimation. Take 1 of 3 points this way, or 2 of 6."));
    m_overTheTop->setAccessibleName(m_overTheTop->text());
    m_overTheTop->hide();
    m_refraction->setLines({tr("optical"), tr("radio"), tr("off")});
    m_refraction->setMinimumContentsLength(kComboLetters);
    m_refraction->setCurrentIndex(0);
    for (CommandButton* const button : {m_follow, m_take}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        button->setMinimumWidth(2 * kTouchSize);  // narrower than a button that also shows "requested"
    }
}

void BodyBox::setBody(ephemeris::Body body)
{
    m_body = body;
    describe();
}

void BodyBox::showStatus(const StationStatus& status)
{
    m_status = status;
    describe();
}

bool BodyBox::isFollowed() const
{
    const CalibrationStatus& calibration = calibrationOf(m_status);
    return calibration.following && calibration.body == m_body;
}

QString BodyBox::whyNotFollowed() const
{
    return m_status.permissions.reason(followAction(m_body, m_overTheTop->isChecked()));
}

void BodyBox::describe()
{
    const bool reachesOverTheTop = axisOf(m_status, Axis::Elevation).travel.max > 90_deg;
    m_overTheTop->setVisible(reachesOverTheTop);
    const QString body = bodyName(m_body);
    const bool followed = isFollowed();
    if (followed || !reachesOverTheTop) {
        m_overTheTop->setChecked(followed && calibrationOf(m_status).overTheTop);
    }
    const QString reason = followed ? QString() : whyNotFollowed();
    m_follow->setCommand(followed ? tr("Hold") : tr("Track %1").arg(body),
                         followed ? tr("End tracking. The mount holds")
                                  : tr("Move the mount to the %1 and track it. The pad trims").arg(body));
    m_follow->setAccessibleName(followed ? tr("Hold and stop tracking the %1").arg(body) : tr("Track %1").arg(body));
    m_follow->setBlocked(reason);
    m_refraction->setEnabled(!followed);
    m_overTheTop->setEnabled(!followed);
    m_take->setBlocked(m_status.permissions.reason(actionOf(Action::TakeSun, m_body)));
    m_where->setValue(whereText(), reason.isEmpty() ? Tone::Normal : Tone::Secondary);
}

QString BodyBox::whereText() const
{
    const CalibrationStatus& calibration = calibrationOf(m_status);
    const BodyNow* const now = bodyNow(m_status, m_body);
    QString text = now != nullptr ? placeText(*now) : QString();
    const auto add = [&text](const QString& line) {
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + line;
    };
    if (!isFollowed()) {
        const QString reason = whyNotFollowed();
        add(reason.isEmpty() ? besideText() : tr("Not now: %1").arg(reason));
    } else {
        const SkyPointing trim = m_status.trim.value_or(SkyPointing{});
        const QString followed =
            calibration.overTheTop ? tr("tracked over the top, trim az %1 el %2") : tr("tracked, trim az %1 el %2");
        add(calibration.pointObstacle.isEmpty()
                ? followed.arg(signedAngleText(trim.azimuth), signedAngleText(trim.elevation))
                : calibration.pointObstacle);
    }
    if (!calibration.points.empty()) {
        add(tr("points taken: %1").arg(calibration.points.size()));
    }
    return text;
}

// Shown before a point is taken, for a body that was centred by hand.
QString BodyBox::besideText() const
{
    const BodyNow* const now = bodyNow(m_status, m_body);
    if (now == nullptr || !m_status.actual) {
        return tr("not tracked");
    }
    return tr("not tracked, beam %1 off").arg(angleText(angleBetween(*m_status.actual, now->direction), 1));
}

void BodyBox::followOrHold()
{
    if (isFollowed()) {
        m_follow->ask(request::Hold{});
        return;
    }
    m_follow->ask(request::FollowBody{.body = m_body,
                                      .refraction = kRefractions[m_refraction->currentIndex()],
                                      .overTheTop = m_overTheTop->isChecked()});
}

}  // namespace boresight::ui

#include "moc_body_box.cpp"
