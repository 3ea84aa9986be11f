#include "widgets/theme/style_sheet.h"

namespace ductus {

namespace {

// @names are colours; sizes are on the 8-px grid.
const char *const sheet = R"(
QToolTip { background: @raised; color: @text; border: 1px solid @line; padding: 6px 8px; }

QPushButton { background: @raised; color: @text; border: 1px solid @line; border-radius: 6px;
    min-height: 26px; padding: 0 12px; }
QPushButton:hover { background: @hover; }
QPushButton:pressed { background: @pressed; }
QPushButton:disabled { color: @disabled; }
QPushButton:focus { border-color: @accent; }
QPushButton[primary="true"] { background: @button; color: @onAccent; border-color: @button; font-weight: 600;
    min-height: 34px; }
QPushButton[primary="true"]:hover { background: @buttonHover; border-color: @buttonHover; }
QPushButton[primary="true"]:pressed { background: @buttonPressed; }
QPushButton[primary="true"]:focus { border: 2px solid @text; }
QPushButton[primary="true"]:disabled { background: @raised; color: @disabled; border-color: @line; }
QPushButton[large="true"] { min-height: 34px; }
QPushButton[flat="true"] { background: transparent; border-color: transparent; text-align: left; }
QPushButton[flat="true"]:hover { background: @hover; }
QPushButton[flat="true"]:focus { border-color: @accent; }

QToolButton { background: transparent; color: @text; border: 1px solid transparent; border-radius: 6px; padding: 0; }
QToolButton[framed="true"] { background: @raised; border-color: @line; min-height: 26px; padding: 0 8px; }
QToolButton:hover { background: @hover; }
QToolButton:pressed { background: @pressed; }
QToolButton:checked { background: @selected; border-color: @accent; }
QToolButton:focus { border-color: @accent; }
QToolButton:disabled { color: @disabled; }
QToolButton::menu-indicator { image: none; }

QLineEdit, QAbstractSpinBox, QComboBox { background: @field; color: @text; border: 1px solid @line;
    border-radius: 6px; min-height: 26px; selection-background-color: @selected; selection-color: @text; }
QLineEdit { padding: 0 8px; }
QAbstractSpinBox { padding: 0 2px 0 6px; }
QLineEdit:focus, QAbstractSpinBox:focus, QComboBox:focus { border-color: @accent; }
QLineEdit:disabled, QAbstractSpinBox:disabled, QComboBox:disabled { color: @disabled; }
QSpinBox QLineEdit, QDoubleSpinBox QLineEdit { border: none; min-height: 0; padding: 0;
    background: transparent; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { subcontrol-origin: border; width: 18px;
    background: transparent; border: none; }
QAbstractSpinBox::up-button { subcontrol-position: top right; margin: 1px 1px 0 0; border-top-right-radius: 5px; }
QAbstractSpinBox::down-button { subcontrol-position: bottom right; margin: 0 1px 1px 0;
    border-bottom-right-radius: 5px; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: @hover; }
QAbstractSpinBox::up-button:pressed, QAbstractSpinBox::down-button:pressed { background: @pressed; }
QAbstractSpinBox::up-arrow { image: url(:/ductus/shapes/@uparrow); width: 10px; height: 10px; }
QAbstractSpinBox::down-arrow { image: url(:/ductus/shapes/@arrow); width: 10px; height: 10px; }
QComboBox { padding: 0 8px; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/ductus/shapes/@arrow); width: 12px; height: 12px; }
QComboBox QAbstractItemView { background: @raised; border: 1px solid @line; selection-background-color: @selected;
    selection-color: @text; outline: 0; }

QMenuBar { background: transparent; spacing: 0; }
QMenuBar::item { padding: 6px 8px; border-radius: 6px; background: transparent; color: @text; }
QMenuBar::item:selected { background: @hover; }
QMenu { background: @raised; border: 1px solid @line; padding: 4px; }
QMenu::item { padding: 5px 24px 5px 8px; border-radius: 4px; color: @text; }
QMenu::item:selected { background: @selected; }
QMenu::item:disabled { color: @disabled; }
QMenu::icon { padding-left: 6px; }
QMenu::separator { height: 1px; background: @line; margin: 4px 8px; }

QScrollArea, QScrollArea > QWidget > QWidget#scrolled { background: transparent; border: none; }
QScrollBar:vertical { width: 10px; background: transparent; margin: 0; }
QScrollBar:horizontal { height: 10px; background: transparent; margin: 0; }
QScrollBar::handle { background: @handle; border-radius: 3px; margin: 2px; }
QScrollBar::handle:hover { background: @dim; }
QScrollBar::handle:vertical { min-height: 32px; }
QScrollBar::handle:horizontal { min-width: 32px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }

QAbstractItemView { background: @field; border: 1px solid @line; border-radius: 6px; outline: 0;
    selection-background-color: @selected; selection-color: @text; }
QHeaderView::section { background: @panel; color: @dim; border: none; border-bottom: 1px solid @line; padding: 6px 8px; }
QDockWidget::title { background: @panel; padding: 8px; }
QDockWidget > QWidget { background: @panel; }
QMainWindow::separator { background: @line; width: 1px; height: 1px; }
#historyView { border: none; border-radius: 0; background: @panel; padding: 0 8px; }
#historyView::item { padding: 4px 0; border-radius: 4px; }
#historyView::item:selected { background: @selected; color: @text; }
QSplitter::handle { background: @line; }
QStatusBar { background: @panel; border-top: 1px solid @line; }
QStatusBar::item { border: none; }
QDialog { background: @window; }

QLabel[dim="true"] { color: @dim; }
QLabel[heading="true"] { font-weight: 600; }
QLabel[caption="true"] { color: @dim; font-weight: 600; }

QCheckBox, QRadioButton { spacing: 8px; min-height: 24px; }
QCheckBox::indicator, QRadioButton::indicator { width: 16px; height: 16px; border: 1px solid @dim; background: @field; }
QCheckBox::indicator { border-radius: 4px; }
QRadioButton::indicator { border-radius: 9px; }
QCheckBox::indicator:hover, QRadioButton::indicator:hover, QCheckBox:focus, QRadioButton:focus { border-color: @accent; }
QCheckBox::indicator:focus, QRadioButton::indicator:focus { border: 2px solid @accent; width: 14px; height: 14px; }
QCheckBox::indicator:checked, QRadioButton::indicator:checked { background: @button; border-color: @button; }
QCheckBox::indicator:checked { image: url(:/ductus/shapes/@check); }
QRadioButton::indicator:checked { image: url(:/ductus/shapes/@spot); }
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled { border-color: @line; }
QListWidget::item { border-radius: 4px; padding-left: 4px; }
QListWidget::item:selected { background: @selected; color: @text; }
QListWidget::item:hover:!selected { background: @hover; }
#searchField { text-align: left; background: @field; color: @dim; padding: 0 8px; }
#searchField:hover { background: @hover; color: @text; }

#topRow { background: @panel; border-bottom: 1px solid @line; }
#toolRail { background: @panel; border-right: 1px solid @line; }
#inspector { background: @panel; border-left: 1px solid @line; }
#appStrip { background: @panel; border-top: 1px solid @line; }
#foldingHeading { text-align: left; font-weight: 600; border-radius: 4px; padding: 0 4px 0 1px; }
#sectionLine { background: @line; }
#messageBar { border: none; border-bottom: 1px solid @line; }
#messageBar[kind="info"] { background: @infoGround; }
#messageBar[kind="success"] { background: @successGround; }
#messageBar[kind="warning"] { background: @warningGround; }
#messageBar[kind="error"] { background: @errorGround; }
#recoveryNotice { background: @warningGround; border: 1px solid @line; border-radius: 8px; }
#jobPopup, #searchPopup { background: @raised; border: 1px solid @line; border-radius: 8px; }
#searchPopup QAbstractItemView { background: transparent; border: none; }
)";

} // namespace

QString styleSheet(const ThemeColours &c)
{
    const QColor field = c.isDark ? mixed(c.window, Qt::black, 0.15) : c.panel;
    // Longer names first, so that @onAccent is not taken for @on.
    const std::pair<const char *, QString> values[] = {
        {"@buttonPressed", mixed(c.button, Qt::black, 0.18).name()},
        {"@buttonHover", mixed(c.button, c.isDark ? Qt::white : Qt::black, 0.12).name()},
        {"@successGround", c.successGround.name()},
        {"@warningGround", c.warningGround.name()},
        {"@errorGround", c.errorGround.name()},
        {"@infoGround", c.infoGround.name()},
        {"@selected", mixed(c.panel, c.accent, c.isDark ? 0.32 : 0.22).name()},
        {"@disabled", c.disabled.name()},
        {"@onAccent", c.onAccent.name()},
        {"@pressed", c.pressed.name()},
        {"@accent", c.accent.name()},
        {"@button", c.button.name()},
        {"@window", c.window.name()},
        {"@raised", c.raised.name()},
        {"@handle", mixed(c.line, c.dim, 0.25).name()},
        {"@check", c.onAccent.lightness() < 128 ? "check-dark.svg" : "check-light.svg"},
        {"@spot", c.onAccent.lightness() < 128 ? "dot-dark.svg" : "dot-light.svg"},
        {"@uparrow", c.isDark ? "arrow-up-dark.svg" : "arrow-up-light.svg"},
        {"@arrow", c.isDark ? "arrow-down-dark.svg" : "arrow-down-light.svg"},
        {"@panel", c.panel.name()},
        {"@hover", c.hover.name()},
        {"@field", field.name()},
        {"@line", c.line.name()},
        {"@text", c.text.name()},
        {"@dim", c.dim.name()},
    };
    QString text = QString::fromLatin1(sheet);
    for (const auto &[name, value] : values)
        text.replace(QLatin1String(name), value);
    return text;
}

} // namespace ductus
