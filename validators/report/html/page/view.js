// Which part of the map is on the screen: its centre (metres, y up) and scale (CSS pixels a metre).
class View {
  constructor(x = 0, y = 0, scale = 1, width = 1, height = 1) {
    Object.assign(this, { x, y, scale, width, height });
  }

  copy() {
    return new View(this.x, this.y, this.scale, this.width, this.height);
  }

  screenX(x) {
    return this.width / 2 + (x - this.x) * this.scale;
  }

  screenY(y) {
    return this.height / 2 - (y - this.y) * this.scale;
  }

  mapX(x) {
    return this.x + (x - this.width / 2) / this.scale;
  }

  mapY(y) {
    return this.y - (y - this.height / 2) / this.scale;
  }

  /** The box on the screen, metres, wider by a share of its sides. */
  box(wider = 0) {
    const halfWidth = (this.width / 2 / this.scale) * (1 + wider);
    const halfHeight = (this.height / 2 / this.scale) * (1 + wider);
    return [this.x - halfWidth, this.y - halfHeight, this.x + halfWidth, this.y + halfHeight];
  }

  /** Shows a box, with room around it. */
  fit([x1, y1, x2, y2], room = 1.06) {
    this.x = (x1 + x2) / 2;
    this.y = (y1 + y2) / 2;
    const scale = Math.min(this.width / (x2 - x1), this.height / (y2 - y1)) / room;
    this.scale = View.clampedScale(Number.isFinite(scale) && scale > 0 ? scale : 20);
  }

  /** Zooms with a place of the screen staying where it is. */
  zoomAt(screenX, screenY, factor) {
    const x = this.mapX(screenX);
    const y = this.mapY(screenY);
    this.scale = View.clampedScale(this.scale * factor);
    this.x = x - (screenX - this.width / 2) / this.scale;
    this.y = y + (screenY - this.height / 2) / this.scale;
  }

  panBy(dx, dy) {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** Part of the way to another view; t in [0, 1]. Scales move evenly to the eye. */
  towards(goal, t) {
    const scale = this.scale * Math.pow(goal.scale / this.scale, t);
    // Moving by the share of 1/scale that has passed keeps the goal's centre in sight.
    const from = 1 / this.scale;
    const to = 1 / goal.scale;
    const share = Math.abs(to - from) < 1e-9 * from ? t : (1 / scale - from) / (to - from);
    return new View(this.x + (goal.x - this.x) * share, this.y + (goal.y - this.y) * share, scale,
      this.width, this.height);
  }

  sees(x, y) {
    const [sx, sy] = [this.screenX(x), this.screenY(y)];
    return sx >= 0 && sy >= 0 && sx <= this.width && sy <= this.height;
  }

  static clampedScale(scale) {
    return Math.max(1e-4, Math.min(20000, scale));
  }
}
