// The colours of the map, from the style sheet.
class Palette {
  constructor() {
    this.style = getComputedStyle(document.documentElement);
    this.known = new Map();
  }

  colour(name) {
    if (!this.known.has(name)) this.known.set(name, this.style.getPropertyValue(`--${name}`).trim());
    return this.known.get(name);
  }

  /** Empty: the kind has lines only. */
  fill(kind) {
    return this.colour(`kind-${kind}-fill`);
  }

  line(kind) {
    return this.colour(`kind-${kind}-line`) || this.colour('ink');
  }
}
