// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

// A picture of the bus: the adapter and the boards on one cable, terminated at both ends. It shows both boards
// connected, or one of them disconnected.
namespace boresight::ui {

class BusPicture : public QWidget
{
    Q_OBJECT

public:
    enum class Boards
    {
        Both,
        BothWithOneId,
        One
    };

    explicit BusPicture(QWidget* parent = nullptr);

    void showBoards(Boards boards);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    Boards m_boards = Boards::Both;
};

}  // namespace boresight::ui
