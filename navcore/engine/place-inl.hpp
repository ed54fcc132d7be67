// Private to this folder: where poses are in their cells.
// Compiled once for each instruction set (Highway).

#if defined(MAPWRIGHT_ENGINE_PLACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MAPWRIGHT_ENGINE_PLACE_INL
#undef MAPWRIGHT_ENGINE_PLACE_INL
#else
#define MAPWRIGHT_ENGINE_PLACE_INL
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "navcore/engine/piece_poses.hpp"

HWY_BEFORE_NAMESPACE();
namespace mapwright::navcore::engine::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, kBlock / 2>;
using DoubleVector = hn::Vec<Doubles>;

// A coordinate's cell, as a whole number, and the coordinate from the cell's middle on.
struct Placed {
  HWY_INLINE Placed(DoubleVector at, const CellGrid& grid) {
    const Doubles d;
    cell = hn::Floor(hn::Mul(at, hn::Set(d, grid.cells_per_metre)));
    const DoubleVector middle =
        hn::Mul(hn::Add(cell, hn::Set(d, 0.5)), hn::Set(d, grid.cell_size_m));
    from_middle = hn::Sub(at, middle);
  }

  DoubleVector cell, from_middle;
};

void place_poses(const CellGrid& grid, std::size_t count, PiecePoses& poses) {
  const Doubles d;
  const hn::Rebind<float, Doubles> df;
  const hn::Rebind<std::int32_t, Doubles> di;
  const std::size_t whole = (count + hn::Lanes(d) - 1) / hn::Lanes(d) * hn::Lanes(d);
  for (auto* array : {&poses.x, &poses.y, &poses.heading}) {
    std::fill(array->data() + count, array->data() + whole, 0.0);
  }
  const DoubleVector most = hn::Set(d, grid.most_m);
  const DoubleVector nowhere = hn::Set(d, static_cast<double>(kNowhere));
  for (std::size_t i = 0; i < whole; i += hn::Lanes(d)) {
    const DoubleVector x = hn::Load(d, poses.x.data() + i), y = hn::Load(d, poses.y.data() + i);
    const auto somewhere = hn::And(hn::Lt(hn::Abs(x), most), hn::Lt(hn::Abs(y), most));
    const Placed column(hn::IfThenElseZero(somewhere, x), grid);
    const Placed row(hn::IfThenElseZero(somewhere, y), grid);
    const DoubleVector number = hn::IfThenElse(somewhere, column.cell, nowhere);
    hn::Store(hn::DemoteTo(di, number), di, poses.column.data() + i);
    hn::Store(hn::DemoteTo(di, row.cell), di, poses.row.data() + i);
    hn::Store(hn::DemoteTo(df, column.from_middle), df, poses.dx.data() + i);
    hn::Store(hn::DemoteTo(df, row.from_middle), df, poses.dy.data() + i);
    const DoubleVector heading = hn::Load(d, poses.heading.data() + i);
    hn::Store(hn::DemoteTo(df, hn::Cos(d, heading)), df, poses.cosine.data() + i);
    hn::Store(hn::DemoteTo(df, hn::Sin(d, heading)), df, poses.sine.data() + i);
  }
}

}  // namespace mapwright::navcore::engine::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
