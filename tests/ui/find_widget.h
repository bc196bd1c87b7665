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

// Finds what an operator finds: a widget by the name that a screen reader says, words that are seen, and the file
// dialog that is open.
namespace boresight::ui {

// A hidden one only where none is seen: panels may each have one of this name.
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

// For a test that cannot go on without it.
template <class T>
T& findSeen(const QWidget& in, const char* name)
{
    T* const found = findNamed<T>(in, name);
    if (found == nullptr || !found->isVisible()) {
        throw std::runtime_error(std::string("nothing that is seen is called ") + name);
    }
    return *found;
}

// In time.
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

// Where its name is typed.
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
