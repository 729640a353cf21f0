// The page of `meet collide --report`.
import { Plane, Sphere, Vector3 } from 'three';
import { Bodies } from './bodies.js';
import { contactsOf, directionTo, outlineOf } from './highlight.js';
import { List } from './list.js';
import { pressBody, writeLegend, writeText } from './panel.js';
import { Report } from './report.js';
import { Stage } from './stage.js';
import { runTest } from './test.js';
import { Views } from './views.js';

const $ = (id) => document.getElementById(id);
const faults = [];
addEventListener('error', (e) => faults.push(e.message));
addEventListener('unhandledrejection', (e) => faults.push(String(e.reason)));
const shout = console.error;
console.error = (...all) => (faults.push(all.join(' ')), shout(...all));

class Page {
  constructor(report) {
    this.report = report;
    this.stage = new Stage($('canvas'));
    this.bodies = new Bodies(report);
    this.stage.scene.add(this.bodies.group, contactsOf(report));
    this.stage.around = this.bodies.around();
    writeText(report.header);
    writeLegend(report, this.bodies, () => this.stage.request());
    this.list = new List($('rows'), { label: (i) => this.label(i), choose: (i) => this.choose(i) });
    this.views = new Views($('saved'), report.header.title, { now: () => this.now(), show: (v) => this.show(v) });
    this.many = report.frames.length > 0;
    this.setTheme(matchMedia('(prefers-color-scheme: dark)').matches);
    this.wire();
    this.fill();
    this.stage.resize();
    this.stage.fit();
    const view = Views.inAddress();
    if (view) this.show(view);
    $('message').hidden = true;
  }

  // The list
  entries() {
    return this.many ? this.bodies.touching.length : this.report.a.length;
  }
  label(i) {
    const { bodies, a, b } = this.report;
    if (!this.many) return `${bodies[0].name} ${a[i]} – ${bodies.at(-1).name} ${b[i]}`;
    const [one, other, how] = this.bodies.touching[i];
    return `${bodies[one].name} – ${bodies[other].name}, ${how}`;
  }
  fill() {
    const n = this.entries(), all = this.many ? n : this.report.header.all_pairs, text = n.toLocaleString('en');
    const what = (n === 1 ? 'pair' : 'pairs') + (this.many ? ' of bodies' : '');
    $('count').textContent = n < all ? `The first ${text} of ${all.toLocaleString('en')} pairs` : `${text} ${what}`;
    const wanted = $('find').value.trim(), rows = [];
    for (let i = 0; i < n; ++i) if (!wanted || this.matches(i, wanted)) rows.push(i);
    this.list.set(rows);
  }
  matches(i, wanted) {
    const { a, b } = this.report;
    return this.many ? this.label(i).includes(wanted) : String(a[i]) === wanted || String(b[i]) === wanted;
  }
  choose(i) {
    const { report, stage } = this, from = stage.camera.position.clone().sub(stage.controls.target);
    let place = null, size = 0, sides = [from];
    if (this.many) {
      place = this.bodies.boxOfTouch(i);
      size = 0.4 * place.getSize(new Vector3()).length();
    } else {
      ({ place, size } = report.boxOfPair(i));
      const outside = directionTo(report, i, from);
      const axes = [0, 1, 2].map((k) => new Vector3().setComponent(k, 1));
      sides = [outside, outside.clone().negate(), from, ...axes, ...axes.map((a) => a.clone().negate())];
      this.outline(i);
    }
    const centre = place.getCenter(new Vector3());
    const ball = new Sphere(centre, Math.max(1.6 * size, 1e-6 * stage.around.radius));
    const views = sides.map((side) => stage.fitting(ball, side));
    stage.fly(views.find((v) => this.bodies.open(new Vector3().fromArray(v), centre, 0.2 * size)) ?? views[0]);
    const where = report.toWorld(centre).map((x) => Number(x.toPrecision(7)));
    $('selected').textContent = `Pair ${i + 1}: ${this.label(i)}, near ${where.join(', ')}`;
    this.list.mark(i);
  }
  outline(i) {
    if (this.outlined) this.stage.scene.remove(this.outlined);
    this.outlined = i < 0 ? null : outlineOf(this.report, i, this.dark ? 0xffffff : 0x000000);
    if (this.outlined) this.stage.scene.add(this.outlined);
  }

  // Views: six numbers of the camera, the frame and the chosen pair
  now() {
    const round = (x) => Number(x.toPrecision(7));
    return [...this.stage.view().map(round), this.bodies.at, this.list.chosen].join(',');
  }
  show(text) {
    const numbers = text.split(',').map(Number);
    if (numbers.length !== 8 || !numbers.every(Number.isFinite)) return;
    const [frame, pair] = numbers.slice(6);
    if (this.many && this.report.frames[frame]) this.setFrame(frame);
    if (pair >= 0 && pair < this.entries()) this.choose(pair);
    this.stage.fly(numbers.slice(0, 6));
  }

  // The tools
  setTheme(dark) {
    this.dark = dark;
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    this.stage.background(getComputedStyle(document.documentElement).getPropertyValue('--back').trim());
    if (this.outlined) this.outline(this.list.chosen);
  }
  setWire(on) {
    $('wire').ariaPressed = on;
    for (const d of this.bodies.drawn) d.wireframe(on);
    this.stage.request();
  }
  setClip() {
    const axis = $('clip-axis').value, { around, camera, controls } = this.stage;
    let normal = new Vector3(axis === 'x', axis === 'y', axis === 'z').multiplyScalar(-1);
    if (axis === 'view') normal = controls.target.clone().sub(camera.position).normalize();
    if ($('clip-flip').checked) normal.negate();
    const offset = around.radius * (1 - (2 * $('clip-at').value) / 1000) * (axis === 'view' ? -1 : 1);
    const point = around.center.clone().addScaledVector(normal, $('clip-flip').checked ? -offset : offset);
    this.stage.plane = $('clip-on').checked ? new Plane().setFromNormalAndCoplanarPoint(normal, point) : null;
    this.stage.request();
  }
  setFrame(at) {
    this.bodies.frame(at);
    this.stage.around = this.bodies.around();
    $('frame').value = at;
    $('frame-name').textContent = this.report.frames[at].name ? `Frame ${this.report.frames[at].name}` : 'Frame';
    this.fill();
    this.stage.request();
  }

  wire() {
    $('fit').onclick = () => this.stage.fit();
    $('wire').onclick = () => this.setWire($('wire').ariaPressed !== 'true');
    $('theme').onclick = () => this.setTheme(!this.dark);
    $('help-open').onclick = () => $('help').showModal();
    $('save').onclick = () => this.views.save();
    $('find').oninput = () => this.fill();
    for (const id of ['clip-on', 'clip-axis', 'clip-at', 'clip-flip']) $(id).oninput = () => this.setClip();
    if (this.report.frames.length > 1) {
      $('frames').hidden = false;
      $('frame').max = this.report.frames.length - 1;
      $('frame').oninput = () => this.setFrame(Number($('frame').value));
      this.setFrame(0);
    }
    const press = (id) => () => $(id).click();
    const frame = (by) => () => {
      const at = this.bodies.at + by;
      if (this.report.frames[at]) this.setFrame(at);
    };
    const keys = {
      f: press('fit'), w: press('wire'), d: press('theme'), s: press('save'), c: press('clip-on'), '?': press('help-open'),
      j: () => this.list.step(1), k: () => this.list.step(-1), '[': frame(-1), ']': frame(1),
      p: () => ($('panel').classList.toggle('hidden'), this.stage.resize()),
    };
    addEventListener('keydown', (e) => {
      if (e.ctrlKey || e.metaKey || e.altKey || /INPUT|SELECT/.test(e.target.tagName)) return;
      if (e.key >= '1' && e.key <= '9') pressBody(Number(e.key) - 1);
      else keys[e.key]?.();
    });
    addEventListener('hashchange', () => {
      const view = Views.inAddress();
      if (view) this.show(view);
    });
  }
}

async function start() {
  try {
    const page = new Page(await Report.read());
    if (/^#test\b/.test(location.hash)) runTest(page, faults);
  } catch (e) {
    $('message').textContent = `This page cannot be shown: ${e.message}`;
    throw e;
  }
}
start();
