// Contacts, and the outline of the pair that was chosen.
import * as three from 'three';
import { colourOf, lines, triangles } from './drawn.js';

export function contactsOf(report) {
  const { points, pieces, triangles: flat, single } = report.contacts, group = new three.Group();
  const colour = colourOf(report.header.curve);
  const at = (list) => Array.from(list).flatMap((i) => [points[3 * i], points[3 * i + 1], points[3 * i + 2]]);
  if (pieces.length) {
    const ends = at(pieces);
    group.add(lines(ends, colour, 2.5));
    const behind = lines(ends, colour, 1.5, { transparent: true, opacity: 0.35, depthTest: false });
    behind.renderOrder = 3;
    group.add(behind);
  }
  if (flat.length) {
    const material = new three.MeshBasicMaterial({ color: colour, side: three.DoubleSide, transparent: true, opacity: 0.6 });
    group.add(triangles(points, flat, material));
  }
  if (single.length) {
    const geometry = new three.BufferGeometry();
    geometry.setAttribute('position', new three.Float32BufferAttribute(at(single), 3));
    group.add(new three.Points(geometry, new three.PointsMaterial({ color: colour, size: 6, sizeAttenuation: false })));
  }
  return group;
}

// The sides of the elements of both items.
export function outlineOf(report, pair, colour) {
  const numbers = [];
  for (const [shape, item] of [[report.shapes[0], report.a[pair]], [report.shapes.at(-1), report.b[pair]]])
    for (const e of shape.elementsOf(item)) {
      const corners = shape.corners(e);
      if (corners.length > 1)
        corners.forEach((p, k) => numbers.push(...p.toArray(), ...corners[(k + 1) % corners.length].toArray()));
    }
  const out = lines(numbers, colour, 2, { depthTest: false, transparent: true });
  out.renderOrder = 4;
  out.visible = numbers.length > 0;
  return out;
}

// Whence a pair is well seen: the side on which both surfaces are outside.
export function directionTo(report, pair, otherwise) {
  const sum = new three.Vector3();
  for (const [shape, item] of [[report.shapes[0], report.a[pair]], [report.shapes.at(-1), report.b[pair]]]) {
    const of = new three.Vector3();
    for (const e of shape.elementsOf(item)) {
      const [p, q, r] = shape.corners(e);
      if (r) of.add(q.clone().sub(p).cross(r.clone().sub(p)));
    }
    sum.add(of.normalize());
  }
  return sum.length() > 0.1 ? sum : otherwise;
}
