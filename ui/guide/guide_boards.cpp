// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_boards.h"

#include "ui/guide/bus_picture.h"
#include "ui/kit/axes.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

bool anyShared(const DrivesStatus& drives)
{
    return std::ranges::any_of(drives.boards, &BoardOnBus::shared);
}

bool wantsTwo(const StationStatus& status)
{
    return driveOf(status, Axis::Azimuth).present && driveOf(status, Axis::Elevation).present;
}

QString boardName(const BoardOnBus& board)
{
    return board.uuid.isEmpty() ? GuideBoards::tr("id %1, UUID unread").arg(board.id)
                                : GuideBoards::tr("id %1, UUID %2").arg(board.id).arg(board.uuid);
}

}  // namespace

GuideBoards::GuideBoards(RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_picture(new BusPicture(&controls())),
      m_sentence(new ValueLabel(tr("What to do with the boards"), fonts::label(), {}, &controls())),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, &controls())),
      m_buttons{new CommandButton(tr("Assign to azimuth …"),
                                  tr("Give the only connected board the id of the azimuth. Asks first"), desk,
                                  *m_notice, &controls()),
                new CommandButton(tr("Assign to elevation …"),
                                  tr("Give the only connected board the id of the elevation. Asks first"), desk,
                                  *m_notice, &controls())}
{
    build();
    for (const Axis axis : kAxes) {
        connect(m_buttons[axisIndex(axis)], &QPushButton::clicked, this, [this, axis] { assign(axis); });
    }
}

void GuideBoards::build()
{
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_sentence->setStretching(true);
    m_sentence->setLines(6);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    auto* const top = new QHBoxLayout;
    top->addWidget(m_picture, 0, Qt::AlignTop);
    top->addWidget(m_sentence, 1);
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    for (CommandButton* const button : m_buttons) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    column->addLayout(top);
    column->addStretch(1);
    column->addLayout(row);
    column->addWidget(m_notice);
}

bool GuideBoards::isNeeded(const StationStatus& status)
{
    if (!status.drives || status.drives->released || status.drives->driveCheck == DriveCheckState::Done) {
        return false;
    }
    const DrivesStatus& drives = *status.drives;
    const bool oneMissing = drives.boards.size() == 1 && wantsTwo(status);
    return anyShared(drives) || drives.boardWork.running || drives.boardWork.failed || oneMissing;
}

void GuideBoards::showStatus(const StationStatus& status)
{
    m_status = status;
    const DrivesStatus& drives = drivesOf(status);
    m_picture->showBoards(anyShared(drives) ? BusPicture::Boards::BothWithOneId : BusPicture::Boards::One);
    showSentence(drives);
    for (const Axis axis : kAxes) {
        m_buttons[axisIndex(axis)]->setVisible(driveOf(status, axis).present);
        m_buttons[axisIndex(axis)]->setBlocked(status.permissions.reason(assignBoardAction(axis)));
    }
    showWhetherPossible(status);
}

void GuideBoards::showSentence(const DrivesStatus& drives)
{
    const BoardWork& work = drives.boardWork;
    if (work.running) {
        m_sentence->setValue(work.text, Tone::Advisory, Symbol::Advisory);
    } else if (anyShared(drives)) {
        m_sentence->setValue(tr("Two boards have the same id, as from the factory. Their replies collide. Switch the "
                                "power off. Disconnect one board. Leave the board connected that needs another id. "
                                "Switch the power on. This page continues when that board answers."),
                             Tone::Warning, Symbol::Warning);
    } else if (work.failed) {
        m_sentence->setValue(work.text, Tone::Warning, Symbol::Warning);
    } else if (!work.text.isEmpty()) {
        m_sentence->setValue(work.text);
    } else if (drives.boards.size() == 1) {
        m_sentence->setValue(
            tr("One board replies: %1. If the other board is connected, check its power and plugs. If both boards had "
               "the same id, choose the axis of this board. Boresight then sets the id of that axis.")
                .arg(boardName(drives.boards.front())));
    } else {
        m_sentence->setValue({});
    }
}

void GuideBoards::assign(Axis axis)
{
    const auto& boards = drivesOf(m_status).boards;
    if (boards.size() != 1) {
        return;  // the button shows the reason
    }
    const int id = m_status.profile->axis(axis).id;
    askFirst(
        {.title = tr("Give this board the id %1?").arg(id),
         .text =
             tr("Board: %1.\nAxis: %2. New id: %3.\n\nBoresight sets the id. It checks that the same board replies. It "
                "reads the id back and stores it. If a check fails, Boresight stores nothing. Nothing moves.")
                 .arg(boardName(boards.front()), name(axis))
                 .arg(id),
         .act = tr("Write"),
         .request = request::AssignBoard{.board = boards.front().uuid, .axis = axis},
         .action = assignBoardAction(axis)},
        m_status);
}

}  // namespace boresight::ui

#include "moc_guide_boards.cpp"
