// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/turn_page.h"

#include "core/base/numbers.h"
#include "ui/drives/place_button.h"
#include "ui/drives/turn_bar.h"
#include "ui/hold/unwind_buttons.h"
#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <QButtonGroup>
#include <QEvent>
#include <QGridLayout>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace boresight::ui {

namespace {

// After the answer the question of the other axis may follow at once. The second press of a double click must not
// answer it.
constexpr std::chrono::milliseconds kFresh{800};
constexpr int kPlacesInRow = 4;

}  // namespace

TurnPage::TurnPage(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_title(new QLabel(this)),
      m_bar(new TurnBar(this)),
      m_evidence(new QPlainTextEdit(this)),
      m_few(new QWidget(this)),
      m_many(new QWidget(this)),
      m_group(new QButtonGroup(this)),
      m_field(new QLineEdit(this)),
      m_selected(new ValueLabel(tr("Selected place"), fonts::label(), {}, this)),
      m_moved(new ValueLabel(tr("Moved since the question"), fonts::label(), tr("moved +000.0° since"), this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_answer(new CommandButton(tr("Confirm position"), tr("Store the selected place as the position of the axis"),
                                 desk, *m_notice, this)),
      m_unwind(new UnwindButtons(desk, *m_notice, this))
{
    m_fresh.setSingleShot(true);
    m_fresh.setInterval(kFresh);
    makeFew();
    makeMany();
    build();
    connect(&m_fresh, &QTimer::timeout, this, &TurnPage::showAnswer);
    connect(m_group, &QButtonGroup::idClicked, this, [this](int place) {
        m_choice.pick(m_choice.question().candidates[static_cast<std::size_t>(place)]);
        showAnswer();
    });
    connect(m_field, &QLineEdit::textEdited, this, &TurnPage::readField);
    connect(m_answer, &QPushButton::clicked, this, &TurnPage::answer);
}

void TurnPage::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 6, 6, 6);
    grid->setVerticalSpacing(6);
    m_title->setFont(fonts::text());
    m_evidence->setFont(fonts::label());
    m_evidence->setReadOnly(true);
    m_evidence->setTabChangesFocus(true);
    m_evidence->setAccessibleName(tr("Evidence"));
    m_evidence->setMinimumHeight(3 * m_evidence->fontMetrics().lineSpacing() + 12);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    m_few->hide();  // only one of them is ever shown, because both would not fit
    m_many->hide();
    grid->addWidget(m_title, 0, 0, 1, 2);
    grid->addWidget(m_bar, 1, 0, 1, 2);
    grid->addWidget(m_evidence, 2, 0, 1, 2);
    grid->addWidget(m_few, 3, 0, 1, 2);
    grid->addWidget(m_many, 4, 0, 1, 2);
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    buttons->addWidget(m_answer, 1);
    buttons->addWidget(m_unwind);
    buttons->addWidget(m_moved);
    grid->addLayout(buttons, 5, 0, 1, 2);
    grid->addWidget(m_notice, 6, 0, 1, 2);
    grid->setRowStretch(2, 1);
}

void TurnPage::makeFew()
{
    auto* const grid = new QGridLayout(m_few);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(2);
    for (std::size_t place = 0; place < kFew; ++place) {
        auto* const button = new PlaceButton(m_few);
        const int number = static_cast<int>(place);
        m_group->addButton(button, number);
        grid->addWidget(button, number / kPlacesInRow, number % kPlacesInRow);
        m_places[place] = button;
    }
}

void TurnPage::makeMany()
{
    auto* const row = new QHBoxLayout(m_many);
    row->setContentsMargins(0, 0, 0, 0);
    m_field->setFont(fonts::text());
    m_field->setAlignment(Qt::AlignRight);
    m_field->setMaxLength(12);
    m_field->setMinimumHeight(kTouchSize);
    m_field->setFixedWidth(m_field->fontMetrics().horizontalAdvance(QStringLiteral("-000.00")) + 20);
    m_field->setAccessibleName(tr("Angle read off the mount"));
    m_field->setToolTip(tr("Where the axis stands, in degrees of its own travel, e.g. 45.5 or -120"));
    m_selected->setStretching(true);
    m_field->installEventFilter(this);
    row->addWidget(makeCaption(tr("The axis stands at about"), *m_field));
    row->addWidget(m_field);
    row->addWidget(makeCaption(QStringLiteral("°"), m_many));
    row->addWidget(m_selected, 1);
}

// Delayed, because the press that gives the focus sets the cursor afterwards. Typing then replaces the proposed angle.
bool TurnPage::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::FocusIn) {
        QMetaObject::invokeMethod(m_field, &QLineEdit::selectAll, Qt::QueuedConnection);
    }
    return QWidget::eventFilter(watched, event);
}

void TurnPage::showStatus(const StationStatus& status)
{
    m_status = status;
    const std::optional<Axis> axis = askingAxis(status);
    if (!axis) {
        m_axis.reset();
        return;
    }
    const TurnQuestion& question = *driveOf(status, *axis).turnQuestion;
    if (axis != m_axis) {
        begin(*axis, question);
    } else {
        m_choice.follow(question);
    }
    showQuestion(question);
    m_unwind->showStatus(status);
    showAnswer();
}

void TurnPage::begin(Axis axis, const TurnQuestion& question)
{
    m_axis = axis;
    m_choice.begin(question);
    m_fresh.start();
    m_notice->setValue({});
    m_title->setText(tr("Where is the %1 axis now?").arg(name(axis)));
    m_unwind->setAxis(axis);
    const auto proposed = m_choice.angle();
    m_field->setText(proposed ? QString::fromStdString(formatFixed(proposed->degrees(), 1)) : QString());
}

void TurnPage::showQuestion(const TurnQuestion& question)
{
    QStringList evidence;
    for (const QString& sentence : question.evidence) {
        evidence << QStringLiteral("• ") + sentence;
    }
    evidence << (question.proposed ? tr("Boresight proposes %1. Look at the mount before you confirm it.")
                                         .arg(angleText(*question.proposed, 1))
                                   : tr("Not enough evidence. Look at the mount."));
    const QString text = evidence.join(QLatin1Char('\n'));
    if (text != m_evidence->toPlainText()) {
        m_evidence->setPlainText(text);
    }
    const std::size_t count = question.candidates.size();
    const bool few = count > 0 && count <= kFew;
    m_few->setVisible(few);
    m_many->setVisible(!few);
    for (std::size_t place = 0; place < kFew; ++place) {
        m_places[place]->setVisible(few && place < count);
        if (few && place < count) {
            const QString angle = angleText(question.candidates[place], 1);
            m_places[place]->setText(angle);
            m_places[place]->setAccessibleName(tr("The axis stands at %1").arg(angle));
        }
    }
    m_moved->setValue(question.movedSince == 0_deg ? tr("not moved")
                                                   : tr("moved %1 since").arg(signedAngleText(question.movedSince, 1)),
                      Tone::Secondary);
}

void TurnPage::showAnswer()
{
    if (!m_axis) {
        return;
    }
    const auto index = m_choice.index();
    const auto angle = m_choice.angle();
    m_group->setExclusive(false);  // otherwise the last checked button could not be unchecked
    for (std::size_t place = 0; place < kFew; ++place) {
        m_places[place]->setChecked(index == place);
    }
    m_group->setExclusive(true);
    m_bar->show(axisOf(m_status, *m_axis).travel, m_choice.question().candidates, angle);
    if (index) {
        m_selected->setValue(tr("selects %1, place %2 of %3")
                                 .arg(angleText(*angle, 1))
                                 .arg(*index + 1)
                                 .arg(m_choice.question().candidates.size()));
    } else {
        m_selected->setValue(angle ? tr("stands at %1").arg(angleText(*angle, 1)) : tr("nothing selected"),
                             Tone::Secondary);
    }
    m_answer->setBlocked(!angle               ? tr("first select the position of the axis")
                         : m_fresh.isActive() ? tr("read the question first")
                                              : m_status.permissions.reason(chooseTurnAction(*m_axis)));
}

void TurnPage::readField()
{
    if (const auto degrees = parseFinite(m_field->text().trimmed().toStdString())) {
        m_choice.enter(Angle::fromDegrees(*degrees));
    } else {
        m_choice.clear();
    }
    showAnswer();
}

void TurnPage::answer()
{
    if (m_axis && m_choice.angle()) {
        m_answer->ask(request::ChooseTurn{*m_axis, *m_choice.angle()});
    }
}

}  // namespace boresight::ui

#include "moc_turn_page.cpp"
