// The data with which the page was filled.
import { Box3, Matrix4, Vector3 } from 'three';
import { Arrays } from './bytes.js';
import { Shape } from './shape.js';

export class Report {
  static async read() {
    const text = (id) => document.getElementById(id).textContent;
    return new Report(JSON.parse(text('meet-json')), await Arrays.of(text('meet-bytes')));
  }

  constructor(header, arrays) {
    Object.assign(this, { header, unit: header.unit, bodies: header.bodies, frames: header.frames });
    this.shapes = header.shapes.map((s) => new Shape(s, header.unit, arrays));
    this.a = arrays.differences(header.pairs.a);
    this.b = arrays.differences(header.pairs.b);
    const c = header.contacts;
    this.contacts = {
      points: arrays.floats(c.points),
      pieces: arrays.differences(c.pieces),
      triangles: arrays.differences(c.triangles),
      single: arrays.differences(c.single),
    };
  }

  shapeOf(body) {
    return this.shapes[this.bodies[body].shape];
  }
  // A body's shape in the page's coordinates: those of the world, relative to the scene's centre.
  matrix(body, pose = this.bodies[body].pose) {
    const c = this.shapeOf(body).header.centre, at = this.header.centre, t = [];
    for (let r = 0; r < 3; ++r) {
      const row = pose.slice(4 * r, 4 * r + 4);
      t.push(row[0], row[1], row[2], (row[0] * c[0] + row[1] * c[1] + row[2] * c[2] + row[3] - at[r]) / this.unit);
    }
    return new Matrix4().set(...t, 0, 0, 0, 1);
  }
  // Where both items of a pair are: their boxes have a place in common.
  boxOfPair(i) {
    const a = this.shapes[0].boxOf(this.a[i]), b = this.shapes.at(-1).boxOf(this.b[i]);
    const both = a.clone().intersect(b);
    return { place: both.isEmpty() ? a.clone().union(b) : both, size: a.union(b).getSize(new Vector3()).length() };
  }
  // The file's own coordinates.
  toWorld(p) {
    return p.toArray().map((x, i) => this.header.centre[i] + this.unit * x);
  }
}

export function boxOf(report, body, matrix) {
  return new Box3().copy(report.shapeOf(body).extent).applyMatrix4(matrix);
}
