#include "widgets/theme/palette.h"

#include <cmath>

namespace ductus {

namespace {

constexpr double readable = 4.6; // a little above the 4.5 that is promised, for rounding

double linear(double channel)
{
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor &colour)
{
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

// The nearest shade of \a colour towards \a end that can be read on \a ground.
QColor readableOn(const QColor &colour, const QColor &ground, const QColor &end)
{
    for (double share = 0.0; share < 1.0; share += 0.02) {
        const QColor shade = mixed(colour, end, share);
        if (contrast(shade, ground) >= readable)
            return shade;
    }
    return end;
}

QColor accentOf(AppKind app)
{
    switch (app) {
    case AppKind::SketchSurfacer:
        return QColor("#4c8dff");
    case AppKind::LayerPainter:
        return QColor("#a071ff");
    case AppKind::DoodleStudio:
        return QColor("#ff7d5c");
    }
    return {};
}

} // namespace

double contrast(const QColor &a, const QColor &b)
{
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

QColor mixed(const QColor &a, const QColor &b, double share)
{
    const auto channel = [&](int x, int y) { return int(std::lround(x + (y - x) * share)); };
    return QColor(channel(a.red(), b.red()), channel(a.green(), b.green()), channel(a.blue(), b.blue()));
}

ThemeColours themeColours(bool dark, AppKind app)
{
    ThemeColours c;
    c.isDark = dark;
    c.window = QColor(dark ? "#1e2125" : "#f3f4f6");
    c.panel = QColor(dark ? "#26292e" : "#ffffff");
    c.raised = QColor(dark ? "#30343a" : "#ffffff");
    c.line = QColor(dark ? "#3b4047" : "#d9dce1");
    c.text = QColor(dark ? "#e8eaed" : "#1d2126");
    c.dim = QColor(dark ? "#a2a9b3" : "#5d6570");
    c.accent = accentOf(app);
    c.success = QColor("#3fb37f");
    c.warning = QColor("#e0a33e");
    c.error = QColor("#e5584f");

    c.disabled = mixed(c.dim, c.panel, 0.45);
    c.hover = dark ? mixed(c.raised, c.text, 0.045) : mixed(c.panel, c.text, 0.05);
    c.pressed = dark ? mixed(c.raised, c.text, 0.16) : mixed(c.panel, c.text, 0.11);
    // In the dark the accent shines and carries dark words; in the light it is deepened for white ones,
    // unless it is so bright a colour that it would become another one.
    const QColor deepened = readableOn(c.accent, Qt::white, Qt::black);
    const bool carriesDark = dark || contrast(c.accent, Qt::white) < 2.8;
    c.onAccent = QColor(carriesDark ? "#0f1318" : "#ffffff");
    c.button = carriesDark ? c.accent : deepened;

    // The ground hardest to read on: of all that words stand on, the one nearest to them.
    const QColor hardest = dark ? c.hover : mixed(c.window, c.text, 0.06);
    const QColor end = dark ? Qt::white : Qt::black;
    c.dim = readableOn(c.dim, hardest, end);
    c.accentText = readableOn(c.accent, hardest, end);
    c.successText = readableOn(c.success, hardest, end);
    c.warningText = readableOn(c.warning, hardest, end);
    c.errorText = readableOn(c.error, hardest, end);
    const double tint = dark ? 0.16 : 0.12;
    c.infoGround = mixed(c.panel, c.accent, tint);
    c.successGround = mixed(c.panel, c.success, tint);
    c.warningGround = mixed(c.panel, c.warning, tint);
    c.errorGround = mixed(c.panel, c.error, tint);
    return c;
}

QPalette qtPalette(const ThemeColours &c)
{
    QPalette palette;
    const auto all = [&](QPalette::ColorRole role, const QColor &colour) { palette.setColor(role, colour); };
    all(QPalette::Window, c.window);
    all(QPalette::WindowText, c.text);
    all(QPalette::Base, c.isDark ? mixed(c.window, Qt::black, 0.15) : c.panel);
    all(QPalette::AlternateBase, c.panel);
    all(QPalette::ToolTipBase, c.raised);
    all(QPalette::ToolTipText, c.text);
    all(QPalette::PlaceholderText, c.dim);
    all(QPalette::Text, c.text);
    all(QPalette::Button, c.raised);
    all(QPalette::ButtonText, c.text);
    all(QPalette::BrightText, c.errorText);
    all(QPalette::Light, mixed(c.raised, Qt::white, c.isDark ? 0.08 : 0.5));
    all(QPalette::Midlight, c.line);
    all(QPalette::Mid, c.line);
    all(QPalette::Dark, mixed(c.line, Qt::black, c.isDark ? 0.3 : 0.2));
    all(QPalette::Shadow, QColor(0, 0, 0));
    all(QPalette::Highlight, mixed(c.panel, c.accent, c.isDark ? 0.32 : 0.22));
    all(QPalette::HighlightedText, c.text);
    all(QPalette::Link, c.accentText);
    all(QPalette::LinkVisited, c.accent);
    for (QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                                     QPalette::HighlightedText, QPalette::PlaceholderText})
        palette.setColor(QPalette::Disabled, role, c.disabled);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, c.line);
    return palette;
}

} // namespace ductus
