// All bodies of a report in their places, frame by frame.
import { Box3, Group, Raycaster, Sphere } from 'three';
import { Drawn, colourOf } from './drawn.js';
import { boxOf } from './report.js';

export class Bodies {
  constructor(report) {
    this.report = report;
    this.group = new Group();
    this.poses = report.bodies.map((b) => b.pose);
    this.drawn = report.bodies.map((b, i) => {
      const two = report.frames.length === 0 && report.bodies.length > 1;
      const drawn = new Drawn(report.shapes[b.shape], two && i > 0 ? 'ghost' : 'solid', b.base);
      this.group.add(drawn.group);
      return drawn;
    });
    this.place();
    this.at = 0;
    if (report.frames.length) this.frame(0);
  }

  place() {
    this.drawn.forEach((d, i) => {
      d.group.matrix.copy(this.report.matrix(i, this.poses[i]));
      d.group.matrixWorldNeedsUpdate = true;
    });
  }
  boxOf(body) {
    return boxOf(this.report, body, this.drawn[body].group.matrix);
  }
  around() {
    const all = new Box3();
    this.drawn.forEach((_, i) => all.union(this.boxOf(i)));
    const sphere = all.getBoundingSphere(new Sphere());
    if (!(sphere.radius > 0)) sphere.radius = 1;
    return sphere;
  }

  // Whether no solid body stands between two points.
  open(from, to, margin) {
    const way = to.clone().sub(from), ray = new Raycaster(from, way.clone().normalize());
    ray.far = way.length() - margin;
    this.group.updateMatrixWorld();
    return ray.far <= 0 || ray.intersectObjects(this.drawn.flatMap((d) => d.solids()), false).length === 0;
  }

  get touching() {
    return this.report.frames[this.at].touching;
  }
  // A body that a frame does not name stays where it was.
  frame(at) {
    this.at = at;
    this.poses = this.report.bodies.map((b) => b.pose);
    for (const f of this.report.frames.slice(0, at + 1)) for (const [body, pose] of f.moved) this.poses[body] = pose;
    this.place();
    const hit = new Set(this.touching.flatMap(([a, b]) => [a, b]));
    this.drawn.forEach((d, i) => d.tint(hit.has(i) ? colourOf(this.report.shapeOf(i).header.hit) : null));
  }
  // Where two bodies are that touch.
  boxOfTouch(i) {
    const [a, b] = this.touching[i];
    const both = this.boxOf(a).intersect(this.boxOf(b));
    return both.isEmpty() ? this.boxOf(a).union(this.boxOf(b)) : both;
  }
}
