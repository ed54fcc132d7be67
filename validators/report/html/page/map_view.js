// The map on the screen: two canvases (obstacles below; pins, selection and scale above) and a loop
// that runs while something moves or is still being painted.
const kFlight_ms = 450;

class MapView {
  constructor(base, top, events) {
    this.base = base;
    this.top = top;
    this.events = events;
    this.view = new View();
    this.palette = new Palette();
    this.hidden = new Set();
    this.isShown = (layer) => !this.hidden.has(layer);
    this.stillness = matchMedia('(prefers-reduced-motion: reduce)');
    this.pending = false;
    new ResizeObserver(() => this.resize()).observe(top);
    theme.onChange(() => this.recolour());
  }

  /** Shows a scene; `rows` have pins where they have a place. */
  open(scene, rows, levels, rowIsShown) {
    this.scene = scene;
    this.painter = new Painter(scene, this.isShown);
    this.pins = new Pins(rows, levels);
    this.rowIsShown = rowIsShown;
    this.selected = null;
    this.flight = null;
    this.resize();
    this.view.fit(scene.extent());
    this.request();
  }

  setLayer(layer, shown) {
    if (shown) this.hidden.delete(layer);
    else this.hidden.add(layer);
    this.repaint();
  }

  repaint() {
    this.painter?.invalidate();
    this.request();
  }

  recolour() {
    this.palette = new Palette();
    this.pins?.invalidate();
    this.repaint();
  }

  resize() {
    this.pixelRatio = Math.min(devicePixelRatio || 1, 2);
    const { clientWidth: width, clientHeight: height } = this.top;
    if (width === 0 || height === 0) return;
    for (const canvas of [this.base, this.top]) {
      canvas.width = Math.round(width * this.pixelRatio);
      canvas.height = Math.round(height * this.pixelRatio);
    }
    Object.assign(this.view, { width, height });
    this.pins?.invalidate();
    this.request();
  }

  request() {
    if (this.pending || !this.scene) return;
    this.pending = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.pending = false;
    this.advanceFlight(now);
    const done = this.painter.work(this.view, this.pixelRatio, this.palette);
    const context = this.base.getContext('2d', { alpha: false });
    context.fillStyle = this.palette.colour('map-outside');
    context.fillRect(0, 0, this.base.width, this.base.height);
    this.painter.show(context, this.view, this.pixelRatio);
    this.drawTop();
    this.top.dataset.painted = done ? 'yes' : 'no';
    if (this.flight || !done) this.request();
  }

  advanceFlight(now) {
    if (!this.flight) return;
    this.flight.begin ??= now;
    const t = Math.min(1, (now - this.flight.begin) / this.flight.duration);
    const eased = t * t * (3 - 2 * t);
    const { width, height } = this.view;
    Object.assign(this.view, this.flight.from.towards(this.flight.to, eased), { width, height });
    if (t === 1) this.flight = null;
  }

  flyTo(goal, duration = kFlight_ms) {
    this.flight = { from: this.view.copy(), to: goal, duration: this.stillness.matches ? 1 : duration, begin: null };
    this.request();
  }

  flyToPlace(x, y) {
    const goal = this.view.copy();
    Object.assign(goal, { x, y, scale: Math.max(goal.scale, 14) });
    this.flyTo(goal);
  }

  flyToBox(box, room = 2.5) {
    const goal = this.view.copy();
    goal.fit(box, room);
    goal.scale = Math.min(goal.scale, 60);
    this.flyTo(goal);
  }

  fitAll() {
    const goal = this.view.copy();
    goal.fit(this.scene.extent());
    this.flyTo(goal);
  }

  zoom(factor, x = this.view.width / 2, y = this.view.height / 2) {
    const goal = (this.flight?.to ?? this.view).copy();
    goal.zoomAt(x, y, factor);
    this.flyTo(goal, 160);
  }

  pan(dx, dy) {
    this.flight = null;
    this.view.panBy(dx, dy);
    this.request();
  }

  /** {obstacle, segment, place, geometry}, any of them missing; null for nothing. */
  select(what) {
    this.selected = what;
    this.request();
  }

  drawTop() {
    const context = this.top.getContext('2d');
    context.setTransform(this.pixelRatio, 0, 0, this.pixelRatio, 0, 0);
    context.clearRect(0, 0, this.view.width, this.view.height);
    if (this.selected) this.drawSelected(context, this.selected);
    if (this.selected?.geometry) this.drawGeometry(context, this.selected.geometry);
    this.pins.draw(context, this.view, this.pixelRatio, this.palette, this.rowIsShown);
    if (this.selected?.place) this.drawRing(context, ...this.selected.place);
    drawScaleBar(context, this.view, this.palette);
  }

  drawSelected(context, { obstacle, segment }) {
    if (obstacle === undefined || obstacle === null) return;
    const path = new Path2D();
    const strong = new Path2D();
    this.scene.eachSegment(obstacle, (ax, ay, bx, by, number) => {
      const target = number === segment ? strong : path;
      target.moveTo(this.view.screenX(ax), this.view.screenY(ay));
      target.lineTo(this.view.screenX(bx), this.view.screenY(by));
    });
    context.strokeStyle = this.palette.colour('map-selected');
    context.lineCap = 'round';
    context.lineWidth = 2;
    context.stroke(path);
    context.lineWidth = 5;
    context.stroke(strong);
  }

  /** The defect itself: points, lines and areas, each a list of [x, y]. */
  drawGeometry(context, { points = [], lines = [], areas = [] }) {
    const path = new Path2D();
    for (const line of [...lines, ...areas]) {
      line.forEach(([x, y], k) => path[k ? 'lineTo' : 'moveTo'](this.view.screenX(x), this.view.screenY(y)));
      if (areas.includes(line)) path.closePath();
    }
    for (const [x, y] of points) {
      path.moveTo(this.view.screenX(x) + 5, this.view.screenY(y));
      path.arc(this.view.screenX(x), this.view.screenY(y), 5, 0, 2 * Math.PI);
    }
    context.strokeStyle = this.palette.colour('map-selected');
    context.lineWidth = 4;
    context.stroke(path);
  }

  drawRing(context, x, y) {
    context.beginPath();
    context.arc(this.view.screenX(x), this.view.screenY(y), 13, 0, 2 * Math.PI);
    context.strokeStyle = this.palette.colour('map-selected');
    context.lineWidth = 2.5;
    context.stroke();
  }

  /** What stands at a place of the screen: a row's pin before an obstacle. */
  pick(x, y) {
    const row = this.pins.at(x, y, this.view, this.rowIsShown);
    if (row) return { row };
    const reach = 6 / this.view.scale;
    return this.scene.obstacleAt(this.view.mapX(x), this.view.mapY(y), reach, this.isShown);
  }
}

function drawScaleBar(context, view, palette) {
  const length = roundStep(70 / view.scale);
  const pixels = length * view.scale;
  const [x, y] = [14, view.height - 14];
  context.strokeStyle = palette.colour('ink');
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y - 5);
  context.lineTo(x, y);
  context.lineTo(x + pixels, y);
  context.lineTo(x + pixels, y - 5);
  context.stroke();
  context.fillStyle = palette.colour('ink');
  context.font = '12px system-ui, sans-serif';
  context.fillText(length >= 1000 ? `${metres(length / 1000)} km` : `${metres(length)} m`, x + 5, y - 5);
}
