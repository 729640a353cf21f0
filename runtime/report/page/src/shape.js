// One shape of a report in the page's own coordinates, relative to its centre and divided by the unit.
import { Box3, Vector3 } from 'three';

export class Shape {
  constructor(header, unit, arrays) {
    const d = header.detail;
    this.header = header;
    this.form = header.form;
    this.numbers = arrays.floats(d.numbers);
    this.items = arrays.differences(d.items);
    this.hit = arrays.bytes(d.hit);
    this.index = d.index ? arrays.corners(d.index) : null;
    if (header.surface) this.read(header.surface, unit, arrays);
    this.extent = new Box3();
    for (let e = 0; e < d.count; ++e) this.grow(this.extent, e);
    if (this.points) this.extent.union(new Box3().setFromArray(this.points));
  }

  read(s, unit, arrays) {
    const numbers = arrays.points(s.points, s.count), centre = this.header.centre;
    this.points = new Float32Array(numbers.length);
    for (let i = 0; i < numbers.length; ++i) {
      const axis = i % 3;
      this.points[i] = (s.lo[axis] - centre[axis] + s.step[axis] * numbers[i]) / unit;
    }
    this.faces = arrays.corners(s.index);
    this.calm = s.faces - s.hits; // faces that are hit come last
  }

  // The corners of an element that is shown in detail.
  corners(e) {
    const at = (i) => new Vector3().fromArray(this.numbers, i);
    if (this.form === 'triangles') return [0, 1, 2].map((k) => at(3 * this.index[3 * e + k]));
    return this.form === 'segments' ? [at(6 * e), at(6 * e + 3)] : [at(4 * e)];
  }
  grow(box, e) {
    const radius = this.form === 'spheres' ? this.numbers[4 * e + 3] : 0;
    for (const p of this.corners(e)) {
      box.expandByPoint(p.clone().addScalar(-radius));
      box.expandByPoint(p.addScalar(radius));
    }
  }
  // The elements of one of the file's items, which follow each other.
  elementsOf(item) {
    let low = 0, high = this.items.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.items[middle] < item) low = middle + 1;
      else high = middle;
    }
    const out = [];
    for (; this.items[low] === item; ++low) out.push(low);
    return out;
  }
  boxOf(item) {
    const box = new Box3();
    for (const e of this.elementsOf(item)) this.grow(box, e);
    return box;
  }
}
