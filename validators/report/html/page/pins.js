// Pins of the rows of the table: a shape a level, so that colour is not all that tells them apart.
const kPinSize = 18;
const kPinCell = 8;  // of pins within as many pixels one is drawn

const kPinShapes = {
  error: (path, r) => {  // a square on its corner
    path.moveTo(0, -r);
    path.lineTo(r, 0);
    path.lineTo(0, r);
    path.lineTo(-r, 0);
    path.closePath();
  },
  warning: (path, r) => {
    path.moveTo(0, -r);
    path.lineTo(r, r * 0.8);
    path.lineTo(-r, r * 0.8);
    path.closePath();
  },
  other: (path, r) => path.arc(0, 0, r * 0.75, 0, 2 * Math.PI),
};

function pinPicture(level, pixelRatio, palette) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = Math.ceil(kPinSize * pixelRatio);
  const context = canvas.getContext('2d');
  context.scale(pixelRatio, pixelRatio);
  context.translate(kPinSize / 2, kPinSize / 2);
  const path = new Path2D();
  (kPinShapes[level.name] ?? kPinShapes.other)(path, kPinSize / 2 - 2);
  context.fillStyle = palette.colour(level.colour);
  context.fill(path);
  context.strokeStyle = palette.colour('map-ground');
  context.lineWidth = 1.5;
  context.stroke(path);
  return canvas;
}

class Pins {
  constructor(rows, levels) {
    this.rows = rows.filter((row) => row.x !== null && row.y !== null);
    this.levels = levels;
    this.pictures = null;
  }

  invalidate() {
    this.pictures = null;
  }

  draw(context, view, pixelRatio, palette, isShown) {
    this.pictures ??= new Map(this.levels.map((level) => [level.name, pinPicture(level, pixelRatio, palette)]));
    const columns = Math.ceil(view.width / kPinCell) + 2;
    for (const level of [...this.levels].reverse()) {
      const taken = new Set();
      const picture = this.pictures.get(level.name);
      for (const row of this.rows) {
        if (row.severity !== level.name || !isShown(row) || !view.sees(row.x, row.y)) continue;
        const [x, y] = [view.screenX(row.x), view.screenY(row.y)];
        const cell = Math.floor(y / kPinCell) * columns + Math.floor(x / kPinCell);
        if (taken.has(cell)) continue;
        taken.add(cell);
        context.drawImage(picture, x - kPinSize / 2, y - kPinSize / 2, kPinSize, kPinSize);
      }
    }
  }

  /** The row whose pin is nearest to a place of the screen; null where none is near. */
  at(screenX, screenY, view, isShown) {
    let nearest = kPinSize * 0.7;
    let found = null;
    for (const row of this.rows) {
      const d = Math.hypot(view.screenX(row.x) - screenX, view.screenY(row.y) - screenY);
      if (d < nearest && isShown(row)) [nearest, found] = [d, row];
    }
    return found;
  }
}
