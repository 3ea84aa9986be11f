// Reads a window as somebody would who speaks another language: texts that were never given to a translator,
// texts that are cut off because they grew, and access keys that are taken twice.
#pragma once

#include <QString>
#include <QStringList>
#include <QTranslator>
#include <QWidget>

namespace ductus {

/// A language in which every text is marked: what is seen without the marks was never translated.
class MarkingTranslator : public QTranslator
{
public:
    using QTranslator::QTranslator;
    QString translate(const char *context, const char *source, const char *disambiguation,
                      int number) const override;
    bool isEmpty() const override { return false; }
};

/// Texts of visible controls below \a window, and of the actions in its menus, that have letters and no marks
/// of MarkingTranslator; \a named are those that are the same in every language.
QStringList unmarkedTexts(QWidget &window, const QStringList &named);

/// Visible labels, buttons, tabs and boxes of choices of \a window whose text is wider or higher than their
/// room: "QLabel "Blend mode": 81 of 60 pixels".
QStringList cutTexts(QWidget &window);

/// Access keys taken twice in one menu of \a window: "File: S (Save, Start page)".
QStringList clashingKeys(QWidget &window);

} // namespace ductus
