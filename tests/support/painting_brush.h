// A hand for the bundled paintings: strokes as a painter lays them, with a little life in them, the same on
// every machine.
#pragma once

#include "base/random.h"
#include "support/painting_scenes.h"

namespace ductus {

class PaintingBrush : public PaintingBuilder
{
public:
    explicit PaintingBrush(std::uint64_t seed) : random(seed) {}

    using Point = Eigen::Vector3f;

    /// Linear RGB of sRGB 0xrrggbb.
    static Point colour(unsigned rgb);
    /// The same a little lighter or darker, warmer or cooler, at random.
    Point varied(const Point &colour, float amount = 0.12f);

    LayerId stack(const std::string &name); // its substrate
    LayerId layer(LayerId substrate, const std::string &name, BlendMode blend = BlendMode::Normal,
                  double opacity = 1, double tolerance = 0);
    LayerId sceneLayer(const std::string &name, BlendMode blend, double opacity);
    Layer &at(LayerId id) { return *painting.findLayer(id); }

    /// Half widths run along with the points; the last one holds for the rest.
    ElementId stroke(LayerId layer, StrokeSection section, const std::vector<Point> &points,
                     const std::vector<float> &halfWidths, const Point &colour,
                     const Point &normal = Point::UnitY());
    /// From one colour to another along the stroke.
    ElementId shaded(LayerId layer, StrokeSection section, const std::vector<Point> &points, float halfWidth,
                     const Point &from, const Point &to, const Point &normal = Point::UnitY());
    /// A plump dab of about \a radius.
    ElementId dab(LayerId layer, const Point &centre, float radius, const Point &colour, float flat = 1);
    /// A board from corner to corner in planks of about \a width along x or z.
    void boards(LayerId layer, const Point &from, const Point &to, bool alongX, float width,
                const Point &colour, float amount = 0.08f, float fill = 0.985f);
    /// One bar with a square section.
    ElementId bar(LayerId layer, const Point &from, const Point &to, float halfWidth, const Point &colour);

    /// Copies moved by \a shift: how highlights and shadows are made.
    std::vector<ElementId> copies(LayerId from, LayerId to, const Vec3 &shift, double scale = 1,
                                  std::size_t first = 0);
    /// Puts one colour on all strokes of a layer, as its property.
    void tint(LayerId layer, unsigned rgb) { at(layer).properties.colour = colour(rgb); }
    void hide(LayerId layer, bool hidden = true) { at(layer).properties.visible = !hidden; }
    /// A look of what the layers are now.
    void keepLook(const std::string &name);
    /// A stroke so large that everything is inside it (thesis V.4.2).
    void everything(LayerId layer, const Point &colour);
    void camera(const Vec3 &eye, const Vec3 &target, double verticalViewDegrees);

    Random random;
};

} // namespace ductus
