// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_path.h"

#include <QWidget>

// A small sky with the way of one pass over it: a dot for each minute, where and when it rises and sets, and dotted
// where the limits of the mount hide it. Gui thread.
namespace boresight::ui {

class PassPicture : public QWidget
{
    Q_OBJECT

public:
    explicit PassPicture(QWidget* parent = nullptr);

    void show(const PassPath& path);  // empty: only the sky
    [[nodiscard]] const PassPath& path() const { return m_path; }

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    PassPath m_path;
};

}  // namespace boresight::ui
