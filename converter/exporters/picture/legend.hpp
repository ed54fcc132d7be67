// The legend below a map.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "converter/exporters/picture/canvas.hpp"
#include "converter/exporters/picture/shapes.hpp"

namespace mapwright::converter {

/// Entries in rows, as many a row as fit.
class Legend {
 public:
  /// Kinds that the shapes show, then what the options and the overlay add.
  Legend(const std::vector<Shape>& shapes, const PictureOptions& options,
         const std::vector<LegendEntry>& overlay);

  /// Height of the whole on a page where a row has `width_pt`.
  double height_pt(double width_pt) const;

  void draw(Canvas& canvas, Point top_left, double width_pt) const;

 private:
  struct Entry {
    std::string text;
    std::function<void(Canvas&, const Box&)> draw_symbol;
    double width_pt;
  };
  struct Placed {
    const Entry* entry;
    Point top_left;
  };

  void add(std::string text, std::function<void(Canvas&, const Box&)> draw_symbol);
  void add_kind(ObstacleKind kind);
  std::vector<Placed> placed(double width_pt) const;

  std::vector<Entry> entries_;
};

}  // namespace mapwright::converter
