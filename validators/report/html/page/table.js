// The table of findings (or differences): sorted by any column, filtered by level, code and text.
const kChunk = 200;  // rows made at a time

const kColumns = [
  { key: 'severity', title: 'Level', compare: (a, b) => a.rank - b.rank },
  { key: 'code', title: 'Code', compare: (a, b) => a.code.localeCompare(b.code) },
  { key: 'line', title: 'Line', number: true, compare: byNumber('line') },
  { key: 'obstacle', title: 'Obstacle', number: true, compare: byNumber('obstacle') },
  { key: 'message', title: 'What', compare: (a, b) => a.message.localeCompare(b.message) },
];

// What has no number comes last.
function byNumber(key) {
  return (a, b) => (a[key] ?? Infinity) - (b[key] ?? Infinity) || 0;
}

class RowTable {
  constructor(root, levels, columns, onSelect) {
    Object.assign(this, { root, levels, onSelect });
    this.columns = kColumns.filter((column) => columns.includes(column.key));
    this.hiddenLevels = new Set();
    this.code = '';
    this.words = '';
    this.sortKey = null;
    this.ascending = true;
    this.selected = null;
    this.build();
  }

  build() {
    this.head = element('tr', {}, this.columns.map((column) => this.heading(column)));
    this.body = element('tbody');
    this.more = element('button', { class: 'more', type: 'button', onclick: () => this.addRows() });
    this.nothing = element('p', { class: 'empty' });
    this.root.append(element('table', { 'aria-label': 'Findings' }, [element('thead', {}, [this.head]), this.body]),
      this.more, this.nothing);
    this.body.addEventListener('keydown', (event) => this.moveFocus(event));
  }

  heading(column) {
    const sort = element('button', { type: 'button', text: column.title, onclick: () => this.sortBy(column.key) });
    return element('th', { scope: 'col', 'data-key': column.key }, [sort]);
  }

  open(rows) {
    this.rows = rows;
    this.selected = null;
    this.update();
  }

  isShown(row) {
    return !this.hiddenLevels.has(row.severity) && (!this.code || row.code === this.code) &&
      (!this.words || row.haystack.includes(this.words));
  }

  sortBy(key) {
    this.ascending = this.sortKey === key ? !this.ascending : true;
    this.sortKey = key;
    this.update();
  }

  update() {
    this.shown = this.rows.filter((row) => this.isShown(row));
    const column = this.columns.find(({ key }) => key === this.sortKey);
    if (column) this.shown.sort((a, b) => (this.ascending ? 1 : -1) * column.compare(a, b) || a.number - b.number);
    for (const cell of this.head.children) {
      const sorted = cell.dataset.key === this.sortKey;
      if (sorted) cell.setAttribute('aria-sort', this.ascending ? 'ascending' : 'descending');
      else cell.removeAttribute('aria-sort');
    }
    this.body.replaceChildren();
    this.made = 0;
    this.addRows();
    this.nothing.hidden = this.shown.length > 0;
    this.nothing.textContent = this.rows.length ? 'Nothing fits the filters.' : 'Nothing found.';
  }

  addRows() {
    const end = Math.min(this.shown.length, this.made + kChunk);
    for (; this.made < end; ++this.made) this.body.append(this.rowElement(this.shown[this.made]));
    const rest = this.shown.length - this.made;
    this.more.hidden = rest === 0;
    this.more.textContent = `Show ${Math.min(rest, kChunk)} more of ${rest}`;
  }

  rowElement(row) {
    const cells = this.columns.map((column) => this.cell(column, row));
    const line = element('tr', { onclick: () => this.onSelect(row) }, cells);
    if (row === this.selected) line.setAttribute('aria-selected', 'true');
    row.element = line;
    return line;
  }

  cell(column, row) {
    if (column.key === 'message') {
      return element('td', {}, [element('button', { type: 'button', text: row.message })]);
    }
    const text = row[column.key] ?? '';
    const level = column.key === 'severity';
    return element('td', { class: level ? `level level-${row.severity}` : column.number && 'number', text });
  }

  select(row) {
    this.selected?.element?.removeAttribute('aria-selected');
    this.selected = row;
    if (!row) return;
    while (this.made < this.shown.length && this.shown.indexOf(row) >= this.made) this.addRows();
    row.element?.setAttribute('aria-selected', 'true');
    row.element?.scrollIntoView({ block: 'nearest' });
  }

  /** The row `step` behind the selected one. */
  neighbour(step) {
    if (this.shown.length === 0) return null;
    const at = this.shown.indexOf(this.selected);
    const start = at < 0 ? (step > 0 ? -1 : 0) : at;
    return this.shown[(start + step + this.shown.length) % this.shown.length];
  }

  moveFocus(event) {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    const line = event.target.closest('tr');
    const next = step > 0 ? line.nextElementSibling : line.previousElementSibling;
    next?.querySelector('button')?.focus();
    event.preventDefault();
  }
}
