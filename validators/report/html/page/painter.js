// Draws a scene into a picture somewhat larger than the screen, a few milliseconds at a time.
//
// Panning and zooming show the last finished picture, moved and scaled, until the next is there:
// a frame costs the same however large the map is. What is smaller than a pixel is not traced.
const kMargin = 0.25;       // of the screen, on each side of the picture
const kSlice_ms = 5;        // of painting within one frame
const kBatchPoints = 600;   // points to trace before looking at the clock
const kTickScale = 6;       // pixels a metre from which on free sides are drawn

class Painter {
  constructor(scene, isShown) {
    this.scene = scene;
    this.isShown = isShown;
    this.front = document.createElement('canvas');
    this.back = document.createElement('canvas');
    this.shown = null;
    this.job = null;
    this.stale = true;
  }

  /** Colours or layers are not what they were. */
  invalidate() {
    this.stale = true;
    this.job = null;
  }

  /** Paints for a while; true when the picture is that of the view. */
  work(view, pixelRatio, palette) {
    if (!this.job && (this.stale || !this.matches(view, pixelRatio))) {
      this.stale = false;
      this.goal = { view: view.copy(), pixelRatio };
      this.job = this.paint(this.goal, palette);
    }
    const end = performance.now() + kSlice_ms;
    while (this.job && performance.now() < end) {
      if (this.job.next().done) this.finish();
    }
    return !this.job && this.matches(view, pixelRatio);
  }

  finish() {
    [this.front, this.back] = [this.back, this.front];
    this.shown = this.goal;
    this.job = null;
  }

  matches(view, pixelRatio) {
    const shown = this.shown;
    if (!shown || shown.pixelRatio !== pixelRatio) return false;
    const same = ['x', 'y', 'scale', 'width', 'height'].every((key) => shown.view[key] === view[key]);
    return same;
  }

  /** The last picture, where the view wants it. */
  show(context, view, pixelRatio) {
    if (!this.shown) return;
    const old = this.shown.view;
    const factor = (view.scale / old.scale) * (pixelRatio / this.shown.pixelRatio);
    const x = view.screenX(old.mapX(-kMargin * old.width)) * pixelRatio;
    const y = view.screenY(old.mapY(-kMargin * old.height)) * pixelRatio;
    context.imageSmoothingEnabled = factor !== 1;
    if (factor === 1) context.drawImage(this.front, Math.round(x), Math.round(y));
    else context.drawImage(this.front, x, y, this.front.width * factor, this.front.height * factor);
  }

  *paint({ view, pixelRatio }, palette) {
    const canvas = this.back;
    const width = Math.ceil(view.width * (1 + 2 * kMargin) * pixelRatio);
    const height = Math.ceil(view.height * (1 + 2 * kMargin) * pixelRatio);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    const context = canvas.getContext('2d', { alpha: false });
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = palette.colour('map-outside');
    context.fillRect(0, 0, width, height);
    context.setTransform(pixelRatio, 0, 0, pixelRatio, kMargin * view.width * pixelRatio, kMargin * view.height * pixelRatio);
    paintGround(context, view, this.scene.border, palette);
    yield;
    for (let layer = 0; layer < this.scene.layers.length; ++layer) {
      if (this.isShown(layer)) yield* this.paintLayer(context, view, layer, palette);
    }
    if (view.scale >= kTickScale && this.isShown('free side')) yield* this.paintTicks(context, view, palette);
    yield* paintMarks(context, view, this.scene, this.isShown, palette);
  }

  *paintLayer(context, view, layer, palette) {
    const style = this.scene.layers[layer].style;
    const fill = palette.fill(style);
    const line = palette.line(style);
    const window = view.box(2 * kMargin);
    const thin = Math.min(1, Math.max(0.5, view.scale / 4));
    context.lineJoin = 'round';
    const trace = new Trace(view);
    const flush = () => {
      if (fill) {
        context.fillStyle = fill;
        context.fill(trace.areas);
      }
      context.strokeStyle = line;
      context.lineWidth = thin * (style.includes('wall') ? 1.8 : 1.2);
      context.stroke(trace.lines);
      context.fillStyle = line;
      context.fill(trace.specks);
      trace.clear();
    };
    for (const i of this.scene.order[layer]) {
      const box = this.scene.box(i);
      if (box[0] > window[2] || box[2] < window[0] || box[1] > window[3] || box[3] < window[1]) continue;
      this.trace(trace, i, fill !== '');
      if (trace.points < kBatchPoints) continue;
      flush();
      yield;
    }
    flush();
    yield;
  }

  trace(trace, i, filled) {
    const { scene } = this;
    const box = scene.box(i);
    if (trace.speck(box)) return;
    if (filled) {
      trace.ring(scene.areaOf(i), true);
      for (const hole of scene.holes.get(i) ?? []) trace.ring(scene.areaOf(hole), false);
    }
    for (let p = scene.firstPath[i]; p < scene.firstPath[i + 1]; ++p) {
      trace.line(scene.xy, scene.pathStart[p], scene.pathStart[p + 1]);
    }
  }

  /** Short strokes on the right of a→b, where free space lies. */
  *paintTicks(context, view, palette) {
    const window = view.box(2 * kMargin);
    const length = 5;
    context.strokeStyle = palette.colour('map-tick');
    context.lineWidth = 0.8;
    let path = new Path2D();
    let count = 0;
    for (let i = 0; i < this.scene.rows.length; ++i) {
      const box = this.scene.box(i);
      if (!this.isShown(this.scene.rows[i][kRow.layer])) continue;
      if (box[0] > window[2] || box[2] < window[0] || box[1] > window[3] || box[3] < window[1]) continue;
      this.scene.eachSegment(i, (ax, ay, bx, by) => {
        const [dx, dy] = [(bx - ax) * view.scale, (by - ay) * view.scale];
        const size = Math.hypot(dx, dy);
        if (size < 3 * length) return;
        const [x, y] = [view.screenX((ax + bx) / 2), view.screenY((ay + by) / 2)];
        path.moveTo(x, y);
        path.lineTo(x + (dy / size) * length, y + (dx / size) * length);
        ++count;
      });
      if (count < kBatchPoints) continue;
      context.stroke(path);
      path = new Path2D();
      count = 0;
      yield;
    }
    context.stroke(path);
    yield;
  }
}

/** Paths of many obstacles, on the screen, without points that nobody could tell apart. */
class Trace {
  constructor(view) {
    this.view = view;
    this.clear();
  }

  clear() {
    this.areas = new Path2D();
    this.lines = new Path2D();
    this.specks = new Path2D();
    this.points = 0;
  }

  /** True for what is no larger than a pixel: it is a dot. */
  speck(box) {
    const width = (box[2] - box[0]) * this.view.scale;
    const height = (box[3] - box[1]) * this.view.scale;
    if (width > 1.2 || height > 1.2) return false;
    this.specks.rect(this.view.screenX(box[0]), this.view.screenY(box[3]), 0.9, 0.9);
    this.points += 2;
    return true;
  }

  /** A ring to fill, or to cut out: they run opposite ways round, however they were drawn. */
  ring(xy, filled) {
    if (xy.length < 6) return;
    this.follow(this.areas, signedArea(xy) > 0 === filled ? xy : reversed(xy), 0, xy.length);
    this.areas.closePath();
  }

  line(xy, start, end) {
    this.follow(this.lines, xy, start, end);
  }

  follow(path, xy, start, end) {
    const { view } = this;
    let lastX = view.screenX(xy[start]);
    let lastY = view.screenY(xy[start + 1]);
    path.moveTo(lastX, lastY);
    for (let k = start + 2; k < end; k += 2) {
      const x = view.screenX(xy[k]);
      const y = view.screenY(xy[k + 1]);
      const apart = Math.abs(x - lastX) + Math.abs(y - lastY);
      if (apart < 0.7 && k + 2 < end) continue;
      path.lineTo(x, y);
      this.points += 1;
      lastX = x;
      lastY = y;
    }
  }
}

function signedArea(xy) {
  let twice = 0;
  for (let k = 0, j = xy.length - 2; k < xy.length; j = k, k += 2) {
    twice += (xy[j] - xy[0]) * (xy[k + 1] - xy[1]) - (xy[k] - xy[0]) * (xy[j + 1] - xy[1]);
  }
  return twice / 2;
}

function reversed(xy) {
  const back = new Float64Array(xy.length);
  for (let k = 0; k < xy.length; k += 2) {
    back[k] = xy[xy.length - 2 - k];
    back[k + 1] = xy[xy.length - 1 - k];
  }
  return back;
}
