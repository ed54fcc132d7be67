// Puts the page together: its data stands in blocks of JSON, two a map (what was found; the map).
const page = JSON.parse(byId('page').textContent);
const found = [...document.querySelectorAll('script.found')].map((block) => JSON.parse(block.textContent));
const sceneBlocks = [...document.querySelectorAll('script.scene')];
const scenes = new Map();

found.forEach((map) => map.findings.forEach((row, number) => Object.assign(row, {
  number,
  rank: page.levels.findIndex((level) => level.name === row.severity),
  haystack: `${row.message} ${row.obstacle ?? ''} ${row.code}`.toLowerCase(),
})));

// A scene is unpacked when its map is first looked at.
function sceneOf(index) {
  if (!scenes.has(index)) scenes.set(index, new Scene(JSON.parse(sceneBlocks[index].textContent)));
  return scenes.get(index);
}

const top_ = byId('top');
const map = new MapView(byId('base'), top_, {
  onPlace: (x, y) => { byId('place').textContent = `${x.toFixed(2)}, ${y.toFixed(2)} m`; },
});
const table = new RowTable(byId('list'), page.levels, page.columns, selectRow);
const inspector = new Inspector(byId('inspector'), clear);
const layerCard = new LayerCard(byId('layers'), map, page.levels, showLevel);
let current = -1;

function openMap(index) {
  current = index;
  const { findings } = found[index];
  table.code = '';
  fillCodes(findings);
  table.open(findings);
  map.hidden.clear();
  map.open(sceneOf(index), findings, page.levels, (row) => table.isShown(row));
  layerCard.open(map.scene, findings, table.hiddenLevels);
  inspector.hide();
  describe(found[index]);
  showCount();
  for (const button of byId('maps').querySelectorAll('button')) {
    if (Number(button.dataset.index) === index) button.setAttribute('aria-current', 'true');
    else button.removeAttribute('aria-current');
  }
  rememberPlace(null);
}

function describe(about) {
  byId('about').replaceChildren(
    element('h2', { text: about.path }),
    element('p', { class: 'quiet', text: `${counted(map.scene.rows.length, 'obstacle')}, ${counted(map.scene.segmentCount, 'segment')}` }),
    ...(about.unreadable ? [element('p', { class: 'level-error', text: about.unreadable })] : []),
    element('ul', {}, about.sections.map((section) => element('li', { text: section.line }))));
}

function fillCodes(rows) {
  const counts = new Map();
  for (const row of rows) counts.set(row.code, (counts.get(row.code) ?? 0) + 1);
  const options = [...counts].sort().map(([code, count]) => element('option', { value: code, text: `${code} (${count})` }));
  byId('code').replaceChildren(element('option', { value: '', text: 'every code' }), ...options);
}

function showCount() {
  byId('count').textContent = `${table.shown.length} of ${table.rows.length}`;
}

function refilter() {
  table.update();
  map.request();
  showCount();
}

function showLevel(name, shown) {
  if (shown) table.hiddenLevels.delete(name);
  else table.hiddenLevels.add(name);
  for (const box of byId('levels').querySelectorAll('input')) {
    if (box.value === name) box.checked = shown;
  }
  layerCard.open(map.scene, table.rows, table.hiddenLevels);
  refilter();
}

function selectRow(row) {
  table.select(row);
  const obstacle = row.scene_obstacle ?? obstacleOf(row);
  map.select({ obstacle, segment: row.segment, place: row.x === null ? null : [row.x, row.y], geometry: row.geometry });
  if (row.x !== null) map.flyToPlace(row.x, row.y);
  else if (obstacle !== null) map.flyToBox(map.scene.box(obstacle));
  inspector.showRow(row, page.codes);
  rememberPlace(row);
}

// The obstacle a row blames. Of several with its id, which is a defect too, the nearest one.
function obstacleOf(row) {
  if (row.obstacle === null || row.obstacle === undefined) return null;
  let [found, least] = [null, Infinity];
  map.scene.rows.forEach((candidate, i) => {
    if (candidate[kRow.id] !== row.obstacle) return;
    const d = row.x === null ? 0 : distanceToBox(row.x, row.y, map.scene.box(i));
    if (d < least) [found, least] = [i, d];
  });
  return found;
}

function pick(x, y) {
  const hit = map.pick(x, y);
  if (!hit) clear();
  else if (hit.row) selectRow(hit.row);
  else selectObstacle(hit);
}

function selectObstacle({ obstacle, segment }) {
  table.select(null);
  map.select({ obstacle, segment });
  inspector.showObstacle(map.scene, obstacle, segment);
}

function clear() {
  table.select(null);
  map.select(null);
  inspector.hide();
  rememberPlace(null);
}

// The address names map and finding, so that a place can be pointed out to somebody.
function rememberPlace(row) {
  const hash = `#map=${current + 1}${row ? `&finding=${row.number + 1}` : ''}`;
  try {
    history.replaceState(null, '', hash);
  } catch {
    // Some browsers do not let a page from a file do so.
  }
}

function openFromAddress() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  const index = Math.max(0, Math.min(found.length, Number(wanted.get('map')) || 1) - 1);
  const number = Number(wanted.get('finding'));
  openMap(index);
  const row = found[index].findings[number - 1];
  if (row) selectRow(row);
}

function listMaps() {
  byId('maps').hidden = found.length < 2;
  byId('maps').querySelector('ul').replaceChildren(...found.map((about, index) =>
    element('li', {}, [element('button', { type: 'button', 'data-index': index, onclick: () => openMap(index) }, [
      element('span', { class: `badge ${about.verdict}`, text: about.verdict }),
      element('span', { class: 'path', text: about.path }),
      element('span', { class: 'quiet', text: String(about.findings.length) }),
    ])])));
}

function listLevels() {
  const there = page.levels.filter((level) => found.some((about) => about.findings.some((row) => row.severity === level.name)));
  byId('levels').replaceChildren(...there.map((level) => {
    const box = element('input', { type: 'checkbox', value: level.name, onchange: (event) => showLevel(level.name, event.target.checked) });
    box.checked = true;
    return element('label', { class: `level-${level.name}` }, [box, ` ${level.name}`]);
  }));
}

byId('code').hidden = !page.columns.includes('code');

function nextRow(step) {
  const row = table.neighbour(step);
  if (row) selectRow(row);
}

for (const box of document.querySelectorAll('.theme input')) {
  box.checked = box.value === theme.choice();
  box.addEventListener('change', () => theme.choose(box.value));
}
byId('code').addEventListener('change', (event) => { table.code = event.target.value; refilter(); });
byId('words').addEventListener('input', (event) => { table.words = event.target.value.toLowerCase(); refilter(); });
byId('zoom-in').addEventListener('click', () => map.zoom(1.6));
byId('zoom-out').addEventListener('click', () => map.zoom(1 / 1.6));
byId('fit').addEventListener('click', () => map.fitAll());
listenToPointers(map, top_, pick);
listenToWheel(map, top_);
listenToKeys(map, top_, { next: nextRow, pick, clear });
byId('title').textContent = page.title;
document.title = page.title;
byId('summary').textContent = page.summary;
if (found.length > 0) {
  listMaps();
  listLevels();
  openFromAddress();
} else {
  document.body.classList.add('bare');
}
document.documentElement.dataset.ready = 'yes';
