// The card that tells of one finding or one obstacle.
const kShapeTypes = ['', 'closed polygon', 'open polygon', 'closed curve', 'open curve', 'stairs', 'ramp'];

class Inspector {
  constructor(root, onClose) {
    this.root = root;
    this.close = element('button', { class: 'close', type: 'button', text: '✕', 'aria-label': 'Close', onclick: onClose });
  }

  hide() {
    this.root.hidden = true;
  }

  show(children) {
    this.root.replaceChildren(this.close, ...children);
    this.root.hidden = false;
    this.root.scrollTop = 0;
  }

  showRow(row, explained) {
    const about = explained?.[row.code];
    const where = [
      row.line === null ? null : `line ${row.line}, column ${row.column}`,
      row.x === null ? null : `at ${placeText(row.x, row.y)}`,
    ].filter(Boolean).join(', ');
    this.show([
      element('h3', { class: `level-${row.severity}`, text: row.code === row.severity ? row.code : `${row.severity}: ${row.code}${about ? ` ${about.name}` : ''}` }),
      element('p', { text: row.message }),
      where ? element('p', { class: 'quiet', text: where }) : null,
      row.excerpt ? element('pre', { text: row.excerpt }) : null,
      ...(row.fix ?? []).map((edit) => element('p', { text: `Repair: ${repairText(edit)}` })),
      ...(row.features ?? []).map(({ source, layer, fid }) =>
        element('p', { class: 'quiet', text: `made of feature ${fid} of layer ${layer} in ${source}` })),
      about?.page ? element('details', {}, [
        element('summary', { text: 'What it means and how to fix it' }),
        element('pre', { class: 'page', text: about.page }),
      ]) : null,
    ].filter(Boolean));
  }

  showObstacle(scene, i, segment) {
    const row = scene.rows[i];
    const facts = [
      ['shape', `${row[kRow.type]} ${kShapeTypes[row[kRow.type]] ?? ''}`],
      ['semantic', scene.texts[row[kRow.text]]],
      ['segments', scene.segments(i)],
      ['height', heightText(scene.rows[i][kRow.heights])],
      ...segmentFacts(scene, i, segment),
      ...(row[kRow.facts] ?? []),
    ];
    this.show([
      element('h3', { text: `Obstacle ${row[kRow.id]} (${scene.layers[row[kRow.layer]].name})` }),
      element('dl', {}, facts.flatMap(([name, value]) =>
        [element('dt', { text: name }), element('dd', { text: value === '' ? 'none' : String(value) })])),
    ]);
  }
}

function repairText({ line, column, end_line, end_column, replacement }) {
  const place = `line ${line}, column ${column}`;
  if (line === end_line && column === end_column) return `insert "${replacement}" at ${place}`;
  const until = line === end_line ? `column ${end_column}` : `line ${end_line}, column ${end_column}`;
  return replacement ? `write "${replacement}" from ${place} up to ${until}` : `remove from ${place} up to ${until}`;
}

function heightText(heights) {
  const all = [heights].flat();
  const [low, high] = [Math.min(...all), Math.max(...all)];
  return low === high ? `${metres(low)} m` : `${metres(low)} to ${metres(high)} m`;
}

function segmentFacts(scene, i, segment) {
  if (!segment) return [];
  let ends = '';
  scene.eachSegment(i, (ax, ay, bx, by, number) => {
    if (number === segment) ends = `${placeText(ax, ay)} to ${placeText(bx, by)}, ${metres(Math.hypot(bx - ax, by - ay))} m`;
  });
  const inOut = scene.valueOf(i, kRow.inOut, segment) === 0 ? 'indoor' : 'outdoor';
  return [
    [`segment ${segment}`, ends],
    ['its height', `${metres(scene.valueOf(i, kRow.heights, segment))} m, ${inOut}`],
    ['its semantic', scene.texts[scene.valueOf(i, kRow.texts, segment)]],
  ];
}
