// The card of layers: a box to tick for each kind of obstacle, each level, and what else is drawn.
class LayerCard {
  constructor(root, map, levels, onLevels) {
    Object.assign(this, { root, map, levels, onLevels });
    theme.onChange(() => this.recolour());
  }

  open(scene, rows, hiddenLevels) {
    const perLayer = scene.layers.map(() => 0);
    scene.rows.forEach((row) => ++perLayer[row[kRow.layer]]);
    scene.marks.forEach((mark) => ++perLayer[mark.layer]);
    const layers = scene.layers.map((layer, i) =>
      perLayer[i] > 0 ? this.box(layer.name, layer.style, perLayer[i], this.map.isShown(i), (on) => this.map.setLayer(i, on)) : null);
    const levels = this.levels.map((level) => {
      const count = rows.filter((row) => row.severity === level.name).length;
      return count === 0 ? null : this.box(level.name, level.colour, count, !hiddenLevels.has(level.name), (on) => this.onLevels(level.name, on));
    });
    const wasOpen = this.root.open;
    this.root.replaceChildren(element('summary', { text: 'Layers' }),
      ...this.group('Map', [...layers, this.box('free side', '', null, this.map.isShown('free side'), (on) => this.map.setLayer('free side', on))]),
      ...this.group('Pins', levels));
    this.root.open = wasOpen;
    this.recolour();
  }

  group(title, boxes) {
    const there = boxes.filter(Boolean);
    return there.length ? [element('h3', { text: title }), ...there] : [];
  }

  box(name, style, count, shown, onChange) {
    const input = element('input', { type: 'checkbox', onchange: (event) => onChange(event.target.checked) });
    input.checked = shown;
    return element('label', {}, [
      input,
      style ? element('span', { class: 'swatch', 'data-style': style }) : null,
      element('span', { text: name }),
      count === null ? null : element('span', { class: 'number', text: count.toLocaleString('en') }),
    ]);
  }

  recolour() {
    const palette = new Palette();
    for (const swatch of this.root.querySelectorAll('.swatch')) {
      const level = palette.colour(swatch.dataset.style);
      swatch.style.borderColor = level || palette.line(swatch.dataset.style);
      swatch.style.backgroundColor = level || palette.fill(swatch.dataset.style) || 'transparent';
    }
  }
}
