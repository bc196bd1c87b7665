// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/event_loop.h"
#include "ui/kit/value_label.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

// Finds what an operator finds: a widget by its name for a screen reader, visible words, and the open file dialog.
namespace boresight::ui {

// Returns a hidden widget only if none is visible, because several panels may have one with this name.
template <class T>
T* findNamed(const QWidget& in, const char* name)
{
    T* found = nullptr;
    for (T* const widget : in.findChildren<T*>()) {
        if (widget->accessibleName() == QString::fromUtf8(name) && (found == nullptr || widget->isVisible())) {
            found = widget;
        }
    }
    EXPECT_NE(found, nullptr) << "no widget named " << name;
    return found;
}

// For a test that cannot continue without it.
template <class T>
T& findSeen(const QWidget& in, const char* name)
{
    T* const found = findNamed<T>(in, name);
    if (found == nullptr || !found->isVisible()) {
        throw std::runtime_error(std::string("nothing that is seen is called ") + name);
    }
    return *found;
}

// Waits until the words are shown.
inline bool says(const QWidget& in, const char* words)
{
    return comesTrue([&] {
        for (const ValueLabel* const label : in.findChildren<ValueLabel*>()) {
            if (label->isVisible() && label->text().contains(QString::fromUtf8(words))) {
                return true;
            }
        }
        return false;
    });
}

// The field for the file name.
inline QLineEdit* fileNameField(const QWidget& in)
{
    const auto* const dialog = in.findChild<QFileDialog*>();
    return dialog ? dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit")) : nullptr;
}

inline void chooseFile(const QWidget& in, const QString& path)
{
    QLineEdit* const field = fileNameField(in);
    ASSERT_NE(field, nullptr) << "no file is asked for";
    EXPECT_FALSE(field->window()->isModal()) << "STOP stays in reach";
    field->setText(path);
    QTest::keyClick(field, Qt::Key_Return);
}

}  // namespace boresight::ui
