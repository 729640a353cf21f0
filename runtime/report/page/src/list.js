// A list of any length: only the rows in sight are in the page.
const height = 24;

export class List {
  constructor(root, { label, choose }) {
    Object.assign(this, { root, label, choose, rows: [], chosen: -1 });
    this.tall = root.querySelector('#tall');
    this.shown = root.querySelector('#shown');
    root.addEventListener('scroll', () => this.draw());
    new ResizeObserver(() => this.draw()).observe(root);
    this.shown.addEventListener('click', (e) => {
      const row = e.target.closest('.row');
      if (row) this.choose(this.rows[row.dataset.at]);
    });
  }
  // The numbers of the entries to show, in this order.
  set(rows) {
    this.rows = rows;
    this.tall.style.height = `${rows.length * height}px`;
    this.root.scrollTop = 0;
    this.draw();
  }
  // The entry after the chosen one in this direction.
  step(by) {
    const at = this.rows.indexOf(this.chosen);
    const next = at < 0 ? 0 : Math.min(this.rows.length - 1, Math.max(0, at + by));
    if (this.rows.length) this.choose(this.rows[next]);
  }
  mark(entry) {
    this.chosen = entry;
    const top = this.rows.indexOf(entry) * height, { scrollTop, clientHeight } = this.root;
    if (top >= 0 && (top < scrollTop || top + height > scrollTop + clientHeight))
      this.root.scrollTop = top - clientHeight / 2;
    this.draw();
  }
  draw() {
    const first = Math.floor(this.root.scrollTop / height);
    const count = Math.ceil(this.root.clientHeight / height) + 1;
    this.shown.style.transform = `translateY(${first * height}px)`;
    this.shown.replaceChildren(
      ...this.rows.slice(first, first + count).map((entry, i) => {
        const row = document.createElement('div');
        row.className = entry === this.chosen ? 'row chosen' : 'row';
        row.role = 'option';
        row.ariaSelected = entry === this.chosen;
        row.dataset.at = first + i;
        const number = document.createElement('span');
        number.className = 'number';
        number.textContent = entry + 1;
        row.append(number, this.label(entry));
        return row;
      }),
    );
  }
}
