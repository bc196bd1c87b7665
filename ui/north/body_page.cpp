// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/body_page.h"

#include "ui/hold/jog_pad.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/touch_combo.h"
#include "ui/kit/value_label.h"
#include "ui/north/body_box.h"
#include "ui/north/calibration_words.h"
#include "ui/north/landmark_box.h"
#include "ui/north/scan_box.h"

#include <QButtonGroup>
#include <QGridLayout>

namespace boresight::ui {

namespace {
constexpr Angle kSteps[] = {0.01_deg, 0.05_deg, 0.1_deg, 0.5_deg, 1_deg};
constexpr int kFirstStep = 2;
constexpr int kBodyPageComboLetters = 7;  // in widths of X: the widest text is narrower
}  // namespace

BodyPage::BodyPage(const Clock& clock, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_warning(new ValueLabel(tr("Eyes and feed"), fonts::label(), {}, this)),
      m_pad(new JogPad(clock, desk, *m_notice, this)),
      m_body(new BodyBox(desk, *m_notice, this)),
      m_landmark(new LandmarkBox(desk, *m_notice, this)),
      m_scan(new ScanBox(desk, *m_notice, this)),
      m_boxes(makeBoxes()),
      m_grid(new QGridLayout(this)),
      m_step(new TouchCombo(tr("Step of the pad"), tr("Step of one press on the pad or of an arrow key"), this))
{
    m_pad->setAccessibleName(tr("Nudge pad"));
    m_pad->setStepMode(true);
    m_pad->setNarrow();
    build();
    choose(Aim::Sun);
}

void BodyPage::build()
{
    fillSteps();
    for (QWidget* const byHand : {static_cast<QWidget*>(m_pad), static_cast<QWidget*>(m_step)}) {
        QSizePolicy policy = byHand->sizePolicy();
        policy.setRetainSizeWhenHidden(true);  // the choices must not move
        byHand->setSizePolicy(policy);
    }
    m_grid->setContentsMargins(6, 4, 6, 0);
    m_grid->setHorizontalSpacing(6);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(0, 2);
    m_grid->setColumnStretch(1, 3);
    m_grid->setRowStretch(1, 1);
    m_grid->addWidget(m_pad, 0, 0, 2, 1);
    m_grid->addLayout(makeChoices(), 0, 1);
}

QWidget* BodyPage::makeBoxes()
{
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    m_warning->setStretching(true);
    auto* const holder = new QWidget(this);
    auto* const boxes = new QVBoxLayout(holder);
    boxes->setContentsMargins(0, 0, 0, 0);
    boxes->setSpacing(4);
    boxes->addWidget(m_warning);
    for (QWidget* const box :
         {static_cast<QWidget*>(m_body), static_cast<QWidget*>(m_landmark), static_cast<QWidget*>(m_scan)}) {
        boxes->addWidget(box);
    }
    boxes->addStretch(1);
    boxes->addWidget(m_notice);
    return holder;
}

QLayout* BodyPage::makeChoices()
{
    auto* const row = new QHBoxLayout;
    row->setSpacing(2);
    auto* const group = new QButtonGroup(this);
    const std::pair<QString, QString> words[] = {{bodyName(ephemeris::Body::Sun), tr("Points by the Sun")},
                                                 {bodyName(ephemeris::Body::Moon), tr("Points by the Moon")},
                                                 {tr("Mark"), tr("A landmark whose direction is known")},
                                                 {tr("Peak"), tr("The peak of the received power, by a cross scan")}};
    for (std::size_t place = 0; place < m_choices.size(); ++place) {
        auto* const button = new ChoiceButton(words[place].first, words[place].second, this);
        m_choices[place] = button;
        group->addButton(button);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, place] { choose(static_cast<Aim>(place)); });
    }
    row->addSpacing(2);
    row->addWidget(m_step);
    return row;
}

void BodyPage::fillSteps()
{
    QStringList sizes;
    for (const Angle step : kSteps) {
        sizes << tr("step %1").arg(angleText(step));
    }
    m_step->setLines(sizes);
    m_step->setMinimumContentsLength(kBodyPageComboLetters);
    m_step->setCurrentIndex(kFirstStep);
    m_pad->setStep(kSteps[kFirstStep]);
    connect(m_step, &QComboBox::activated, this, [this](int index) { m_pad->setStep(kSteps[index]); });
}

void BodyPage::choose(Aim aim)
{
    m_aim = aim;
    for (QWidget* const box :
         {static_cast<QWidget*>(m_body), static_cast<QWidget*>(m_landmark), static_cast<QWidget*>(m_scan)}) {
        box->hide();  // hide first: two boxes at the same time would not fit
    }
    m_notice->setValue({});
    m_choices[static_cast<std::size_t>(aim)]->setChecked(true);
    for (QWidget* const byHand : {static_cast<QWidget*>(m_pad), static_cast<QWidget*>(m_step)}) {
        byHand->setVisible(aim != Aim::Scan);  // a scan moves by itself
    }
    const int column = aim == Aim::Scan ? 0 : 1;  // otherwise the pad is shown there
    m_grid->removeWidget(m_boxes);
    m_grid->addWidget(m_boxes, 1, column, 1, 2 - column);
    m_warning->setLines(aim == Aim::Scan ? 2 : 4);  // beside the pad the warning is narrow
    m_warning->updateGeometry();
    showWarning();
    switch (aim) {
        case Aim::Sun:
        case Aim::Moon:
            chooseBody(aim == Aim::Sun ? ephemeris::Body::Sun : ephemeris::Body::Moon);
            m_body->show();
            break;
        case Aim::Landmark:
            m_landmark->show();
            break;
        case Aim::Scan:
            m_scan->show();
            break;
    }
}

void BodyPage::chooseBody(ephemeris::Body body)
{
    m_body->setBody(body);
    m_scan->setBody(body);
    m_scan->showStatus(m_status);
}

void BodyPage::showWarning()
{
    const CalibrationStatus& calibration = calibrationOf(m_status);
    const bool scansSun = m_aim == Aim::Scan && m_scan->body() == ephemeris::Body::Sun;
    const QString text = !calibration.warning.isEmpty()  ? calibration.warning
                         : m_aim == Aim::Sun || scansSun ? sunWarning()
                                                         : QString();
    m_warning->setValue(text, Tone::Warning, text.isEmpty() ? Symbol::None : Symbol::Warning);
}

void BodyPage::showStatus(const StationStatus& status)
{
    m_status = status;
    m_pad->showStatus(status);
    m_body->showStatus(status);
    m_landmark->showStatus(status);
    m_scan->showStatus(status);
    showWarning();
}

void BodyPage::beat()
{
    m_pad->disarmWhenUnused();
}

}  // namespace boresight::ui

#include "moc_body_page.cpp"
