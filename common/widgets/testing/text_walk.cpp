#include "widgets/testing/text_walk.h"

#include "document/settings/action_catalogue.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

namespace ductus {

namespace {

const QChar openingMark(0x27e6), closingMark(0x27e7);

// What of \a text was said by the program itself: with what the marks hold taken away.
QString outsideMarks(const QString &text)
{
    QString outside;
    int depth = 0;
    for (const QChar c : text) {
        if (c == openingMark)
            ++depth;
        else if (c == closingMark)
            --depth;
        else if (depth == 0)
            outside += c;
    }
    return outside;
}

bool hasWords(const QString &text)
{
    static const QRegularExpression word(QStringLiteral("\\p{L}{3,}"));
    return word.match(text).hasMatch();
}

QString spoken(const QString &text)
{
    if (!Qt::mightBeRichText(text))
        return text;
    QTextDocument document;
    document.setHtml(text);
    return document.toPlainText();
}

struct Said
{
    QString where, text;
};

QList<Said> textsOf(const QWidget &widget)
{
    const QString name =
        QString::fromLatin1(widget.metaObject()->className()) + QLatin1Char(' ') + widget.objectName();
    QList<Said> said{{name + QStringLiteral(" tooltip"), widget.toolTip()},
                     {name + QStringLiteral(" accessible name"), widget.accessibleName()},
                     {name + QStringLiteral(" accessible description"), widget.accessibleDescription()}};
    if (const auto *label = qobject_cast<const QLabel *>(&widget))
        said << Said{name, label->text()};
    else if (const auto *button = qobject_cast<const QAbstractButton *>(&widget))
        said << Said{name, button->text()};
    else if (const auto *group = qobject_cast<const QGroupBox *>(&widget))
        said << Said{name, group->title()};
    else if (const auto *line = qobject_cast<const QLineEdit *>(&widget))
        said << Said{name + QStringLiteral(" placeholder"), line->placeholderText()};
    else if (const auto *box = qobject_cast<const QComboBox *>(&widget))
        for (int i = 0; box->objectName() != QLatin1String("language") && i < box->count(); ++i)
            said << Said{name, box->itemText(i)}; // languages are named in themselves
    else if (const auto *tabs = qobject_cast<const QTabBar *>(&widget))
        for (int i = 0; i < tabs->count(); ++i)
            said << Said{name, tabs->tabText(i)};
    return said;
}

QString cut(const QWidget &widget, const QString &text, int needed, int room, const char *direction)
{
    return QStringLiteral("%1 %2 \"%3\": %4 of %5 pixels %6")
        .arg(QString::fromLatin1(widget.metaObject()->className()), widget.objectName(), text)
        .arg(needed)
        .arg(room)
        .arg(QLatin1String(direction));
}

constexpr int slack = 1; // of rounding

QStringList cutLabel(const QLabel &label)
{
    const QString text = spoken(label.text());
    if (text.isEmpty() ||
        (label.sizePolicy().horizontalPolicy() == QSizePolicy::Ignored && !label.wordWrap()))
        return {};
    const QRect room =
        label.contentsRect().adjusted(label.margin(), label.margin(), -label.margin(), -label.margin());
    if (label.wordWrap()) {
        const int needed = label.heightForWidth(label.width());
        // A longest word that does not fit is cut as well.
        int widest = 0;
        for (const QString &word : text.split(QRegularExpression(QStringLiteral("\\s"))))
            if (word.size() < 24) // longer ones are paths, or languages without spaces
                widest = std::max(widest, label.fontMetrics().horizontalAdvance(plainText(word)));
        QStringList problems;
        if (needed > label.height() + slack)
            problems << cut(label, text, needed, label.height(), "high");
        if (widest > room.width() + slack && text.at(0).unicode() < 0x3000)
            problems << cut(label, text, widest, room.width(), "wide");
        return problems;
    }
    const int needed = label.sizeHint().width();
    if (needed > label.width() + slack)
        return {cut(label, text, needed, label.width(), "wide")};
    return {};
}

QStringList cutButton(const QAbstractButton &button)
{
    if (button.text().isEmpty())
        return {};
    if (const auto *tool = qobject_cast<const QToolButton *>(&button))
        if (tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull())
            return {};
    const int needed = std::max(button.minimumSizeHint().width(),
                                qobject_cast<const QPushButton *>(&button) ? button.sizeHint().width() : 0);
    if (needed > button.width() + slack)
        return {cut(button, button.text(), needed, button.width(), "wide")};
    return {};
}

QStringList cutBox(const QComboBox &box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const int room =
        box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
    const int needed = box.fontMetrics().horizontalAdvance(box.currentText()) +
                       (box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4);
    if (needed > room + slack)
        return {cut(box, box.currentText(), needed, room, "wide")};
    return {};
}

} // namespace

QString MarkingTranslator::translate(const char *, const char *source, const char *, int) const
{
    const QString text = QString::fromUtf8(source);
    // File filters are read by dialogs; a mark inside would break them.
    return text.contains(QLatin1String("(*")) ? QString() : openingMark + text + closingMark;
}

QStringList unmarkedTexts(QWidget &window, const QStringList &named)
{
    QStringList found;
    const auto check = [&](const Said &said) {
        QString rest = outsideMarks(spoken(said.text));
        for (const QString &name : named)
            rest.remove(name);
        rest.remove(QRegularExpression(QStringLiteral("#[0-9a-f]{6}"))); // colours name themselves
        if (hasWords(rest))
            found << said.where + QStringLiteral(": ") + said.text;
    };
    QList<QWidget *> widgets = window.findChildren<QWidget *>();
    widgets.prepend(&window);
    for (QWidget *widget : widgets)
        if (widget->isVisibleTo(&window))
            for (const Said &said : textsOf(*widget))
                check(said);
    for (const QMenu *menu : window.findChildren<QMenu *>())
        for (const QAction *action : menu->actions()) {
            check({QStringLiteral("menu ") + menu->title(), action->text()});
            check({QStringLiteral("tooltip in menu ") + menu->title(),
                   action->toolTip().section(QLatin1Char('('), 0, 0)});
        }
    return found;
}

QStringList cutTexts(QWidget &window)
{
    QStringList found;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisible() || widget->width() < 4)
            continue;
        if (const auto *label = qobject_cast<const QLabel *>(widget))
            found << cutLabel(*label);
        else if (const auto *button = qobject_cast<const QAbstractButton *>(widget))
            found << cutButton(*button);
        else if (const auto *box = qobject_cast<const QComboBox *>(widget))
            found << cutBox(*box);
        else if (const auto *tabs = qobject_cast<const QTabBar *>(widget))
            for (int i = 0; i < tabs->count(); ++i)
                if (const int needed = tabs->fontMetrics().horizontalAdvance(plainText(tabs->tabText(i)));
                    tabs->isTabVisible(i) && needed > tabs->tabRect(i).width())
                    found << cut(*tabs, tabs->tabText(i), needed, tabs->tabRect(i).width(), "wide");
    }
    return found;
}

QStringList clashingKeys(QWidget &window)
{
    QStringList found;
    for (const QMenu *menu : window.findChildren<QMenu *>()) {
        QMap<QString, QStringList> taken;
        for (const QAction *action : menu->actions()) {
            const QKeySequence key = QKeySequence::mnemonic(action->text());
            if (!key.isEmpty() && action->isVisible())
                taken[key.toString()] << plainText(action->text());
        }
        for (auto entry = taken.cbegin(); entry != taken.cend(); ++entry)
            if (entry.value().size() > 1)
                found << QStringLiteral("%1: %2 (%3)")
                             .arg(plainText(menu->title()), entry.key(),
                                  entry.value().join(QStringLiteral(", ")));
    }
    return found;
}

} // namespace ductus
