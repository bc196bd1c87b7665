// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/drives/turn_choice.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <optional>

class QButtonGroup;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

// The question about the wrap of an axis: a picture of its travel with the possible positions, the evidence for each,
// and the answer. The answer is one of a few positions, or an angle read off the mount that selects the nearest of
// many. Nothing is selected unless the evidence proposes it, and nothing is sent without a press. One axis at a time,
// azimuth first.
// More than 15 members: the widgets that it composes.
namespace boresight::ui {

class CommandButton;
class PlaceButton;
class RequestDesk;
class TurnBar;
class UnwindButtons;
class ValueLabel;

class TurnPage : public QWidget
{
    Q_OBJECT

public:
    static constexpr std::size_t kFew = 7;  // up to this number each candidate has its own button

    explicit TurnPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;  // for the field that receives the focus

private:
    void build();
    void makeFew();
    void makeMany();
    void begin(Axis axis, const TurnQuestion& question);
    void showQuestion(const TurnQuestion& question);
    void showAnswer();
    void readField();
    void answer();

    StationStatus m_status;
    std::optional<Axis> m_axis;  // the axis of the question; empty while there is none
    TurnChoice m_choice;
    QTimer m_fresh{this};  // runs while the question is too new to be answered
    QLabel* m_title;
    TurnBar* m_bar;
    QPlainTextEdit* m_evidence;
    QWidget* m_few;
    QWidget* m_many;
    std::array<PlaceButton*, kFew> m_places{};
    QButtonGroup* m_group;
    QLineEdit* m_field;
    ValueLabel* m_selected;
    ValueLabel* m_moved;
    ValueLabel* m_notice;
    CommandButton* m_answer;
    UnwindButtons* m_unwind;
};

}  // namespace boresight::ui
