// The text and the legend at the side.
import { modes } from './drawn.js';

const $ = (id) => document.getElementById(id);

function add(to, tag, text, name) {
  const e = document.createElement(tag);
  if (text !== undefined) e.textContent = text;
  if (name) e.className = name;
  to.append(e);
  return e;
}

function swatch(to, [r, g, b], title) {
  const e = add(to, 'span', undefined, 'swatch');
  e.style.background = `rgb(${r} ${g} ${b})`;
  e.title = title;
}

export function writeText(header) {
  document.title = $('title').textContent = header.title;
  for (const [name, value] of header.facts) {
    add($('facts'), 'dt', name);
    add($('facts'), 'dd', value);
  }
  for (const note of header.notes) add($('notes'), 'li', note);
}

// A line for each body with its colours and a button for how it is drawn.
export function writeLegend(report, bodies, change) {
  report.bodies.forEach((body, i) => {
    const line = add($('legend'), 'div'), shape = report.shapeOf(i).header;
    swatch(line, body.base, 'touches nothing');
    swatch(line, shape.hit, 'touches');
    add(line, 'span', `${body.name}, ${shape.counted}`, 'name').title = body.name;
    const button = add(line, 'button', bodies.drawn[i].mode);
    button.title = i < 9 ? `${i + 1}` : '';
    button.onclick = () => {
      const drawn = bodies.drawn[i];
      drawn.set(modes[(modes.indexOf(drawn.mode) + 1) % modes.length]);
      button.textContent = drawn.mode;
      change();
    };
  });
  const { pieces, triangles, single } = report.contacts;
  if (pieces.length + triangles.length + single.length) {
    const line = add($('legend'), 'div');
    swatch(line, report.header.curve, 'contact');
    add(line, 'span', 'where they meet', 'name');
  }
}

export function pressBody(i) {
  $('legend').querySelectorAll('button')[i]?.click();
}
