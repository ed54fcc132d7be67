// What lies below the obstacles (ground, grid, border) and over them (lines, boxes, arrows).
const kGridPixels = 90;  // lines of the grid are about as far apart

/** 1, 2 or 5 times a power of ten, at least `value`. */
function roundStep(value) {
  const power = Math.pow(10, Math.floor(Math.log10(value)));
  return [1, 2, 5, 10].map((n) => n * power).find((step) => step >= value * (1 - 1e-9));
}

function paintGround(context, view, [left, top, right, bottom], palette) {
  const usable = left < right && bottom < top;
  const x = view.screenX(left);
  const y = view.screenY(top);
  const width = (right - left) * view.scale;
  const height = (top - bottom) * view.scale;
  if (usable) {
    context.fillStyle = palette.colour('map-ground');
    context.fillRect(x, y, width, height);
  }
  paintGrid(context, view, palette);
  if (!usable) return;
  context.strokeStyle = palette.colour('map-border');
  context.lineWidth = 1;
  context.setLineDash([6, 4]);
  context.strokeRect(x, y, width, height);
  context.setLineDash([]);
}

function paintGrid(context, view, palette) {
  const step = roundStep(kGridPixels / view.scale);
  const [x1, y1, x2, y2] = view.box(2 * kMargin);
  context.beginPath();
  for (let i = Math.ceil(x1 / step); i * step <= x2; ++i) {
    const x = Math.round(view.screenX(i * step)) + 0.5;
    context.moveTo(x, view.screenY(y1));
    context.lineTo(x, view.screenY(y2));
  }
  for (let i = Math.ceil(y1 / step); i * step <= y2; ++i) {
    const y = Math.round(view.screenY(i * step)) + 0.5;
    context.moveTo(view.screenX(x1), y);
    context.lineTo(view.screenX(x2), y);
  }
  context.strokeStyle = palette.colour('map-grid');
  context.lineWidth = 1;
  context.stroke();
}

/** Marks are {layer, line: [x, y, …], arrow}, {layer, box: [x1, y1, x2, y2]} or {layer, dot: [x, y]}. */
function* paintMarks(context, view, scene, isShown, palette) {
  const paths = new Map();
  let count = 0;
  const flush = () => {
    for (const [style, path] of paths) strokeMarks(context, path, style, palette);
    paths.clear();
    count = 0;
  };
  for (const mark of scene.marks) {
    if (!isShown(mark.layer)) continue;
    const { style } = scene.layers[mark.layer];
    if (!paths.has(style)) paths.set(style, { areas: new Path2D(), lines: new Path2D(), heads: new Path2D() });
    traceMark(paths.get(style), view, mark);
    if (++count < kBatchPoints) continue;
    flush();
    yield;
  }
  flush();
  yield;
}

function strokeMarks(context, path, style, palette) {
  context.strokeStyle = palette.line(style);
  context.lineWidth = 2;
  context.fillStyle = palette.fill(style) || 'transparent';
  context.fill(path.areas);
  context.stroke(path.areas);
  context.stroke(path.lines);
  context.fillStyle = palette.line(style);
  context.fill(path.heads);
}

function traceMark(path, view, mark) {
  if (mark.box) {
    const [x1, y1, x2, y2] = mark.box;
    path.areas.rect(view.screenX(x1), view.screenY(y2), (x2 - x1) * view.scale, (y2 - y1) * view.scale);
  } else if (mark.dot) {
    const [x, y] = [view.screenX(mark.dot[0]), view.screenY(mark.dot[1])];
    path.heads.moveTo(x + 4, y);
    path.heads.arc(x, y, 4, 0, 2 * Math.PI);
  } else {
    traceLine(path, view, mark);
  }
}

function traceLine(path, view, { line, arrow }) {
  for (let k = 0; k < line.length; k += 2) {
    const [x, y] = [view.screenX(line[k]), view.screenY(line[k + 1])];
    if (k === 0) path.lines.moveTo(x, y);
    else path.lines.lineTo(x, y);
  }
  if (!arrow) return;
  const end = line.length;
  const [x, y] = [view.screenX(line[end - 2]), view.screenY(line[end - 1])];
  const [dx, dy] = [x - view.screenX(line[end - 4]), y - view.screenY(line[end - 3])];
  const size = Math.hypot(dx, dy);
  if (size < 3) return;
  const head = Math.min(9, size);
  const [ux, uy] = [(dx / size) * head, (dy / size) * head];
  path.heads.moveTo(x, y);
  path.heads.lineTo(x - ux - uy * 0.4, y - uy + ux * 0.4);
  path.heads.lineTo(x - ux + uy * 0.4, y - uy - ux * 0.4);
  path.heads.closePath();
}
