// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hold/jog_pad.h"

#include "ui/hold/jog_button.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/request_desk.h"
#include "ui/kit/value_label.h"
#include "ui/link/motion_state.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr std::chrono::minutes kArmedFor{1};
constexpr QSize kLargestButton{96, 72};  // of a direction button: a larger target is no improvement

std::optional<JogDirection> directionOf(int key)
{
    switch (key) {
        case Qt::Key_Up:
            return JogDirection::Up;
        case Qt::Key_Down:
            return JogDirection::Down;
        case Qt::Key_Left:
            return JogDirection::Left;
        case Qt::Key_Right:
            return JogDirection::Right;
        default:
            return std::nullopt;
    }
}

QString heldHelp(JogDirection direction)
{
    switch (direction) {
        case JogDirection::Up:
            return JogPad::tr("Elevation up while held");
        case JogDirection::Down:
            return JogPad::tr("Elevation down while held");
        case JogDirection::Left:
            return JogPad::tr("Azimuth counter-clockwise while held");
        case JogDirection::Right:
            break;
    }
    return JogPad::tr("Azimuth clockwise while held");
}

QString stepHelp(JogDirection direction, Angle step)
{
    const auto text = [direction] {
        switch (direction) {
            case JogDirection::Up:
                return JogPad::tr("Elevation up by %1");
            case JogDirection::Down:
                return JogPad::tr("Elevation down by %1");
            case JogDirection::Left:
                return JogPad::tr("Azimuth counter-clockwise by %1");
            case JogDirection::Right:
                break;
        }
        return JogPad::tr("Azimuth clockwise by %1");
    };
    return text().arg(angleText(step, 2));
}

}  // namespace

JogPad::JogPad(const Clock& clock, RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_clock(clock),
      m_desk(desk),
      m_notice(notice),
      m_buttons{{JogDirection::Up, new JogButton(QStringLiteral("▲"), heldHelp(JogDirection::Up), this)},
                {JogDirection::Down, new JogButton(QStringLiteral("▼"), heldHelp(JogDirection::Down), this)},
                {JogDirection::Left, new JogButton(QStringLiteral("◀"), heldHelp(JogDirection::Left), this)},
                {JogDirection::Right, new JogButton(QStringLiteral("▶"), heldHelp(JogDirection::Right), this)}},
      m_hold(new CommandButton(tr("Hold"), tr("Stop the motion and hold the position (Ctrl+H)"), desk, notice, this)),
      m_caption(new ValueLabel(tr("Arrow keys"), fonts::label(), {}, this))
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Jog pad"));
    setAccessibleDescription(
        tr("Press Enter to arm the arrow keys. An armed arrow key moves the mount while it is held."));
    build();
    for (const auto& [direction, button] : m_buttons) {
        connectButton(direction);
    }
    connect(&m_deadMan, &DeadMan::jog, this, &JogPad::sendJog);
    connect(m_hold, &QPushButton::clicked, this, &JogPad::hold);
    applyRate();
    disarm();
}

void JogPad::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(kGrid / 2, kGrid / 2, kGrid / 2, kGrid / 2);
    grid->setSpacing(kGrid);
    grid->addWidget(m_buttons.at(JogDirection::Up), 1, 2);
    grid->addWidget(m_buttons.at(JogDirection::Left), 2, 1);
    grid->addWidget(m_hold, 2, 2);
    grid->addWidget(m_buttons.at(JogDirection::Right), 2, 3);
    grid->addWidget(m_buttons.at(JogDirection::Down), 3, 2);
    grid->addWidget(m_caption, 5, 0, 1, 5);
    m_hold->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    m_hold->setMaximumSize(kLargestButton);
    for (const auto& [direction, button] : m_buttons) {
        button->setMaximumSize(kLargestButton);
    }
    for (const int middle : {1, 2, 3}) {  // the remaining room of a large pad is around them
        grid->setRowStretch(middle, 1000);
        grid->setColumnStretch(middle, 1000);
    }
    for (const int rim : {0, 4}) {
        grid->setRowStretch(rim, 1);
        grid->setColumnStretch(rim, 1);
    }
    m_hold->setFocusPolicy(Qt::TabFocus);  // a click must not disarm the pad
    m_caption->setStretching(true);
    m_caption->setAlignment(Qt::AlignCenter);
    m_caption->setAttribute(Qt::WA_TransparentForMouseEvents);  // a click on this part of the pad arms it
}

void JogPad::connectButton(JogDirection direction)
{
    JogButton* const button = m_buttons.at(direction);
    connect(button, &JogButton::holdBegan, this, [this, direction] { press(direction, m_stepMode); });
    connect(button, &JogButton::holdEnded, this, [this, direction] { m_deadMan.letGo(direction); });
}

void JogPad::press(JogDirection direction, bool oneStep)
{
    const QString reason = m_status.permissions.reason(oneStep ? stepAction(direction) : jogAction(direction));
    if (!reason.isEmpty()) {
        if (oneStep) {  // the button is enabled, because it could still jog
            m_notice.setValue(tr("Step: %1").arg(reason), Tone::Warning, Symbol::Warning);
        }
        return;
    }
    m_notice.setValue({});
    if (oneStep) {
        sendStep(direction);
    } else {
        m_deadMan.hold(direction);
    }
}

void JogPad::sendJog(const AxisRates& rates)
{
    const bool ends = rates == AxisRates{};
    m_desk.send(request::Jog{rates}, this, [this, ends](const std::optional<Error>& error) {
        if (!ends) {  // after STOP even the request that ends a jog is refused, and the operator need not know this
            refused(error);
        }
    });
}

void JogPad::sendStep(JogDirection direction)
{
    request::Nudge step{};
    switch (direction) {
        case JogDirection::Up:
            step.elevation = m_step;
            break;
        case JogDirection::Down:
            step.elevation = -m_step;
            break;
        case JogDirection::Right:
            step.azimuth = m_step;
            break;
        case JogDirection::Left:
            step.azimuth = -m_step;
            break;
    }
    m_desk.send(step, this, [this](const std::optional<Error>& error) { refused(error); });
}

void JogPad::refused(const std::optional<Error>& error)
{
    if (error) {
        letGoAll();
        m_notice.setValue(tr("Jog: %1").arg(error->text), Tone::Warning, Symbol::Warning);
    }
}

void JogPad::hold()
{
    if (m_hold->isEnabled()) {
        letGoAll();
        m_hold->ask(request::Hold{});
    }
}

void JogPad::letGoAll()
{
    for (const auto& [direction, button] : m_buttons) {
        button->letGo();
    }
    m_deadMan.letGoAll();
    Q_EMIT interrupted();
}

void JogPad::showStatus(const StationStatus& status)
{
    m_status = status;
    for (const auto& [direction, button] : m_buttons) {
        const QString reason = status.permissions.reason(m_stepMode ? stepAction(direction) : jogAction(direction));
        button->setBlocked(reason);
        if (!reason.isEmpty()) {
            m_deadMan.letGo(direction);
        }
    }
    m_hold->setBlocked(status.permissions.reason(Action::Hold));
    applyRate();
    showCaption();
}

void JogPad::steer(double azimuth, double elevation)
{
    const auto permitted = [this](double part, JogDirection plus, JogDirection minus) {
        return part != 0.0 && m_status.permissions.allows(jogAction(part > 0.0 ? plus : minus)) ? part : 0.0;
    };
    const bool held = m_deadMan.isHeld();
    m_deadMan.steer(permitted(azimuth, JogDirection::Right, JogDirection::Left),
                    permitted(elevation, JogDirection::Up, JogDirection::Down));
    if (!held && m_deadMan.isHeld()) {
        m_notice.setValue({});
    }
}

void JogPad::setGamepad(const QString& name)
{
    m_gamepad = name;
    showCaption();
}

void JogPad::setRate(AngularRate rate)
{
    m_rate = rate;
    applyRate();
}

void JogPad::setStep(Angle step)
{
    m_step = step;
    showHelp();
}

void JogPad::setStepMode(bool on)
{
    m_stepMode = on;
    showHelp();
    letGoAll();
    showStatus(m_status);
}

void JogPad::showHelp()
{
    for (const auto& [direction, button] : m_buttons) {
        button->setHelp(m_stepMode ? stepHelp(direction, m_step) : heldHelp(direction));
    }
}

void JogPad::setNarrow()
{
    for (const auto& [direction, button] : m_buttons) {
        button->setMinimumWidth(kTouchSize);  // narrower than a button that also shows "requested"
    }
    m_hold->setMinimumWidth(3 * kTouchSize / 2);
    m_caption->setLines(2);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // takes the remaining room
}

void JogPad::applyRate()
{
    const AngularRate wanted = m_shift ? m_status.profile->jog.fast : m_rate;
    m_deadMan.setRate(std::min(wanted, m_status.permissions.fastestJog));
}

void JogPad::showCaption()
{
    if (isArmed()) {
        m_caption->setValue(
            m_stepMode ? tr("ARMED: an arrow key moves one step") : tr("ARMED: hold an arrow key to move"),
            Tone::Accent);
    } else if (followsAClient(m_status)) {
        m_caption->setValue(tr("A step trims the target (Ctrl + arrow)"), Tone::Secondary);
    } else if (!m_gamepad.isEmpty()) {
        m_caption->setValue(tr("Click to arm the arrow keys, or hold LB or RB"), Tone::Secondary);
    } else {
        m_caption->setValue(tr("Click here to arm the arrow keys"), Tone::Secondary);
    }
    m_caption->setToolTip(
        m_gamepad.isEmpty() ? QString()
                            : tr("%1: hold LB or RB and move the left stick to jog. Button B is STOP.").arg(m_gamepad));
}

void JogPad::arm()
{
    m_armedUntil = m_clock.now() + kArmedFor;
    showCaption();
    update();
}

void JogPad::disarm()
{
    m_armedUntil.reset();
    m_shift = false;
    applyRate();
    letGoAll();
    showCaption();
    update();
}

void JogPad::disarmWhenUnused()
{
    if (!isArmed()) {
        return;
    }
    if (m_deadMan.isHeld()) {
        m_armedUntil = m_clock.now() + kArmedFor;
    } else if (m_clock.now() >= *m_armedUntil) {
        disarm();
    }
}

bool JogPad::event(QEvent* event)
{
    if (event->type() == QEvent::WindowDeactivate) {
        disarm();
    }
    if (event->type() == QEvent::ShortcutOverride && isArmed() &&
        directionOf(static_cast<QKeyEvent*>(event)->key()).has_value()) {
        event->accept();  // an armed arrow key is used here, not as a shortcut
        return true;
    }
    return QWidget::event(event);
}

void JogPad::mousePressEvent(QMouseEvent*)
{
    setFocus(Qt::MouseFocusReason);
    arm();
}

void JogPad::keyPressEvent(QKeyEvent* event)
{
    const auto direction = directionOf(event->key());
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_Space) {
        if (!event->isAutoRepeat()) {
            isArmed() ? disarm() : arm();
        }
    } else if (event->key() == Qt::Key_Shift) {
        m_shift = true;
        applyRate();
    } else if (isArmed() && direction) {
        if (!event->isAutoRepeat()) {
            m_shift = event->modifiers().testFlag(Qt::ShiftModifier);
            applyRate();
            arm();
            press(*direction, m_stepMode || event->modifiers().testFlag(Qt::ControlModifier));
        }
    } else {
        QWidget::keyPressEvent(event);
    }
}

void JogPad::keyReleaseEvent(QKeyEvent* event)
{
    if (event->isAutoRepeat()) {
        return;
    }
    if (event->key() == Qt::Key_Shift) {
        m_shift = false;
        applyRate();
    }
    if (const auto direction = directionOf(event->key())) {
        m_deadMan.letGoSoon(*direction);
    }
    QWidget::keyReleaseEvent(event);
}

void JogPad::focusOutEvent(QFocusEvent* event)
{
    disarm();
    QWidget::focusOutEvent(event);
    update();
}

void JogPad::hideEvent(QHideEvent* event)
{
    disarm();
    QWidget::hideEvent(event);
}

void JogPad::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    if (!isArmed() && !hasFocus()) {
        return;
    }
    painter.setPen(isArmed() ? QPen(colours.accent, 3.0) : QPen(colours.accent, 1.0, Qt::DashLine));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5), kRounding, kRounding);
}

}  // namespace boresight::ui

#include "moc_jog_pad.cpp"
