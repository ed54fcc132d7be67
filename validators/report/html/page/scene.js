// A map made ready for drawing and for asking what lies where.
//
// The data has one row an obstacle (validators/report/html/scene.hpp); coordinates are unpacked
// into one typed array, as thousands of small arrays would make every frame slow.
const kRow = { layer: 0, id: 1, type: 2, text: 3, paths: 4, area: 5, heights: 6, inOut: 7, texts: 8, facts: 9 };

class Scene {
  constructor(data) {
    this.rows = data.obstacles;
    this.texts = data.texts;
    this.layers = data.layers;
    this.marks = data.marks;
    this.border = data.border;
    this.unpack();
    this.collectHoles(data.holes);
    this.order = this.layers.map(() => []);
    this.rows.forEach((row, i) => this.order[row[kRow.layer]].push(i));
    this.segmentCount = this.rows.reduce((sum, row, i) => sum + this.segments(i), 0);
  }

  unpack() {
    const count = this.rows.length;
    let paths = 0;
    let numbers = 0;
    for (const row of this.rows) {
      paths += row[kRow.paths].length;
      for (const path of row[kRow.paths]) numbers += path.length;
    }
    this.xy = new Float64Array(numbers);
    this.pathStart = new Uint32Array(paths + 1);
    this.firstPath = new Uint32Array(count + 1);
    this.boxes = new Float64Array(4 * count);
    let path = 0;
    let at = 0;
    this.rows.forEach((row, i) => {
      this.firstPath[i] = path;
      for (const points of row[kRow.paths]) {
        this.pathStart[path++] = at;
        this.xy.set(points, at);
        at += points.length;
      }
      this.firstPath[i + 1] = path;
      this.pathStart[path] = at;
      this.setBox(i);
    });
  }

  setBox(i) {
    let [x1, y1, x2, y2] = [Infinity, Infinity, -Infinity, -Infinity];
    const end = this.pathStart[this.firstPath[i + 1]];
    for (let k = this.pathStart[this.firstPath[i]]; k < end; k += 2) {
      x1 = Math.min(x1, this.xy[k]);
      x2 = Math.max(x2, this.xy[k]);
      y1 = Math.min(y1, this.xy[k + 1]);
      y2 = Math.max(y2, this.xy[k + 1]);
    }
    this.boxes.set([x1, y1, x2, y2], 4 * i);
  }

  /** Rings within an outline are cut out of its fill. */
  collectHoles(pairs) {
    this.holes = new Map();
    for (const [inner, outer] of pairs) {
      if (!this.holes.has(outer)) this.holes.set(outer, []);
      this.holes.get(outer).push(inner);
    }
  }

  box(i) {
    return this.boxes.subarray(4 * i, 4 * i + 4);
  }

  segments(i) {
    let count = 0;
    for (let p = this.firstPath[i]; p < this.firstPath[i + 1]; ++p) {
      count += (this.pathStart[p + 1] - this.pathStart[p]) / 2 - 1;
    }
    return count;
  }

  /** Calls visit(ax, ay, bx, by, number) for each segment, number from 1. */
  eachSegment(i, visit) {
    let number = 0;
    for (let p = this.firstPath[i]; p < this.firstPath[i + 1]; ++p) {
      for (let k = this.pathStart[p]; k + 3 < this.pathStart[p + 1]; k += 2) {
        visit(this.xy[k], this.xy[k + 1], this.xy[k + 2], this.xy[k + 3], ++number);
      }
    }
  }

  /** What a segment has: a value for all segments, or one each. */
  valueOf(i, column, number) {
    const value = this.rows[i][column];
    return Array.isArray(value) ? value[number - 1] : value;
  }

  /** All that is worth seeing: the border and, unless something lies absurdly far off, all obstacles. */
  extent() {
    const [left, top, right, bottom] = this.border;
    const inBorder = [left, bottom, right, top];
    const usable = left < right && bottom < top;
    const all = usable ? [...inBorder] : [Infinity, Infinity, -Infinity, -Infinity];
    for (let k = 0; k < this.boxes.length; k += 4) {
      all[0] = Math.min(all[0], this.boxes[k]);
      all[1] = Math.min(all[1], this.boxes[k + 1]);
      all[2] = Math.max(all[2], this.boxes[k + 2]);
      all[3] = Math.max(all[3], this.boxes[k + 3]);
    }
    if (!(all[0] <= all[2])) return [0, 0, 1, 1];
    const wide = usable && (all[2] - all[0] > 3 * (right - left) || all[3] - all[1] > 3 * (top - bottom));
    return wide ? inBorder : all;
  }

  /** The obstacle at a place: the nearest line within reach, else the smallest area that holds it. */
  obstacleAt(x, y, reach, isShown) {
    let best = null;
    let nearest = reach;
    let smallest = Infinity;
    for (let i = 0; i < this.rows.length; ++i) {
      if (!isShown(this.rows[i][kRow.layer])) continue;
      const [x1, y1, x2, y2] = this.box(i);
      if (x < x1 - reach || x > x2 + reach || y < y1 - reach || y > y2 + reach) continue;
      this.eachSegment(i, (ax, ay, bx, by, number) => {
        const d = distanceToSegment(x, y, ax, ay, bx, by);
        if (d < nearest) [nearest, best] = [d, { obstacle: i, segment: number }];
      });
      const area = (x2 - x1) * (y2 - y1);
      if (nearest === reach && area < smallest && this.holds(i, x, y)) {
        [smallest, best] = [area, { obstacle: i, segment: null }];
      }
    }
    return best;
  }

  holds(i, x, y) {
    const ring = this.areaOf(i);
    let inside = false;
    for (let k = 0, j = ring.length - 2; k < ring.length; j = k, k += 2) {
      const crosses = ring[k + 1] > y !== ring[j + 1] > y;
      if (crosses && x < ((ring[j] - ring[k]) * (y - ring[k + 1])) / (ring[j + 1] - ring[k + 1]) + ring[k]) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** The ring to fill: what the data names, or the outline; empty for a wall. */
  areaOf(i) {
    const area = this.rows[i][kRow.area];
    if (Array.isArray(area)) return area;
    if (area === 0) return [];
    const p = this.firstPath[i];
    return p < this.firstPath[i + 1] ? this.xy.subarray(this.pathStart[p], this.pathStart[p + 1]) : [];
  }
}

function distanceToSegment(x, y, ax, ay, bx, by) {
  const [dx, dy] = [bx - ax, by - ay];
  const squared = dx * dx + dy * dy;
  const t = squared > 0 ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / squared)) : 0;
  return Math.hypot(x - ax - t * dx, y - ay - t * dy);
}

function distanceToBox(x, y, [x1, y1, x2, y2]) {
  return Math.hypot(Math.max(x1 - x, 0, x - x2), Math.max(y1 - y, 0, y - y2));
}
