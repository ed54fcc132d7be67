// Pointer, wheel and keys on the map.
const kClickSlack = 4;  // pixels a pointer may move and still be a click

function listenToPointers(map, top, onPick) {
  const pointers = new Map();
  let moved = 0;

  top.addEventListener('pointerdown', (event) => {
    top.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    if (pointers.size === 1) moved = 0;
    top.classList.add('dragging');
  });

  top.addEventListener('pointermove', (event) => {
    map.events.onPlace(map.view.mapX(event.offsetX), map.view.mapY(event.offsetY));
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const now = { x: event.offsetX, y: event.offsetY };
    if (pointers.size === 1) drag(last, now);
    else pinch(event.pointerId, last, now);
    pointers.set(event.pointerId, now);
  });

  function drag(last, now) {
    moved += Math.hypot(now.x - last.x, now.y - last.y);
    if (moved > kClickSlack) map.pan(now.x - last.x, now.y - last.y);
  }

  function pinch(id, last, now) {
    moved = Infinity;
    const other = [...pointers].find(([key]) => key !== id)[1];
    const before = Math.hypot(last.x - other.x, last.y - other.y);
    const after = Math.hypot(now.x - other.x, now.y - other.y);
    map.flight = null;
    if (before > 0) map.view.zoomAt((now.x + other.x) / 2, (now.y + other.y) / 2, after / before);
    map.pan((now.x - last.x) / 2, (now.y - last.y) / 2);
  }

  const release = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (pointers.size > 0) return;
    top.classList.remove('dragging');
    if (event.type === 'pointerup' && moved <= kClickSlack) onPick(event.offsetX, event.offsetY);
  };
  top.addEventListener('pointerup', release);
  top.addEventListener('pointercancel', release);
}

function listenToWheel(map, top) {
  top.addEventListener('wheel', (event) => {
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    map.zoom(Math.exp(-Math.max(-400, Math.min(400, event.deltaY * lines)) * 0.0022), event.offsetX, event.offsetY);
  }, { passive: false });
  top.addEventListener('dblclick', (event) => map.zoom(2, event.offsetX, event.offsetY));
}

function listenToKeys(map, top, commands) {
  const step = 80;
  const keys = {
    ArrowLeft: () => map.pan(step, 0),
    ArrowRight: () => map.pan(-step, 0),
    ArrowUp: () => map.pan(0, step),
    ArrowDown: () => map.pan(0, -step),
    '+': () => map.zoom(1.5),
    '=': () => map.zoom(1.5),
    '-': () => map.zoom(1 / 1.5),
    0: () => map.fitAll(),
    n: () => commands.next(1),
    p: () => commands.next(-1),
    Enter: () => commands.pick(map.view.width / 2, map.view.height / 2),
    Escape: () => commands.clear(),
  };
  top.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
}
