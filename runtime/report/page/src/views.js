// Views that are kept: in the browser's storage, where it has one for a file, and in the address.
export class Views {
  constructor(root, key, { now, show }) {
    Object.assign(this, { root, key: `meet ${key}`, now, show, kept: [] });
    try {
      this.kept = JSON.parse(localStorage.getItem(this.key)) ?? [];
    } catch {
      // no storage: views last as long as the page
    }
    this.draw();
  }
  save() {
    this.kept.push(this.now());
    this.write();
    try {
      history.replaceState(null, '', `#view=${this.now()}`);
    } catch {
      // a page in a frame of another one has no address
    }
  }
  write() {
    try {
      localStorage.setItem(this.key, JSON.stringify(this.kept));
    } catch {
      // as above
    }
    this.draw();
  }
  draw() {
    this.root.replaceChildren(
      ...this.kept.map((view, i) => {
        const button = document.createElement('button');
        button.textContent = i + 1;
        button.title = 'show this view; with Shift forget it';
        button.onclick = (e) => {
          if (!e.shiftKey) return this.show(view);
          this.kept.splice(i, 1);
          this.write();
        };
        return button;
      }),
    );
  }
  // That of the address; null where it has none.
  static inAddress() {
    const text = /#.*view=([^&]*)/.exec(location.hash)?.[1];
    return text ? decodeURIComponent(text) : null;
  }
}
