// A body as three.js draws it: calm elements and those that are hit, solid or as a ghost.
import * as three from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

export const colourOf = ([r, g, b]) => new three.Color().setRGB(r / 255, g / 255, b / 255, three.SRGBColorSpace);

export function lines(numbers, colour, width, options = {}) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(numbers);
  const material = new LineMaterial({ color: colour, linewidth: width, ...options });
  const out = new LineSegments2(geometry, material);
  out.frustumCulled = false;
  return out;
}

export function triangles(points, index, material) {
  const geometry = new three.BufferGeometry();
  geometry.setAttribute('position', new three.BufferAttribute(points, 3));
  geometry.setIndex(new three.BufferAttribute(index, 1));
  geometry.computeBoundingSphere();
  return new three.Mesh(geometry, material);
}

function surfaceMaterial(colour, bright) {
  return new three.MeshLambertMaterial({
    color: colour,
    emissive: bright ? colour.clone().multiplyScalar(0.55) : 0,
    side: three.DoubleSide,
    flatShading: true,
    polygonOffset: true, // lines on a face stand before it
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}

// The elements whose flag is `hit`, each as `width` numbers of `from`.
function chosen(shape, from, width, hit) {
  const out = [];
  for (let e = 0; e < shape.hit.length; ++e)
    if (shape.hit[e] === hit) for (let k = 0; k < width; ++k) out.push(from[width * e + k]);
  return out;
}

// Faces that are hit have lines along their sides, so that they show from far away.
function ofTriangles(shape, hit, material, colour) {
  const out = [];
  const near = chosen(shape, shape.index, 3, hit);
  if (near.length) out.push(triangles(shape.numbers, new Uint32Array(near), material));
  if (near.length && hit) {
    const sides = [];
    for (let i = 0; i < near.length; ++i) {
      const p = 3 * near[i], q = 3 * near[i % 3 === 2 ? i - 2 : i + 1];
      for (const end of [p, q]) for (let k = 0; k < 3; ++k) sides.push(shape.numbers[end + k]);
    }
    out.push(lines(sides, colour, 1.5));
  }
  const far = hit ? shape.faces.subarray(3 * shape.calm) : shape.faces.subarray(0, 3 * shape.calm);
  if (far.length) out.push(triangles(shape.points, far, material));
  return out;
}

function ofSpheres(shape, hit, material, colour) {
  const rows = chosen(shape, shape.numbers, 4, hit), balls = [], points = [];
  for (let i = 0; i < rows.length; i += 4) (rows[i + 3] > 0 ? balls : points).push(...rows.slice(i, i + 4));
  const out = [];
  if (balls.length) {
    const round = material.clone();
    round.flatShading = false;
    const ball = new three.InstancedMesh(new three.IcosahedronGeometry(1, 3), round, balls.length / 4);
    for (let i = 0; i < ball.count; ++i) {
      const [x, y, z, r] = balls.slice(4 * i, 4 * i + 4);
      ball.setMatrixAt(i, new three.Matrix4().makeScale(r, r, r).setPosition(x, y, z));
    }
    out.push(ball);
  }
  if (points.length) {
    const geometry = new three.BufferGeometry();
    const xyz = points.filter((_, i) => i % 4 < 3);
    geometry.setAttribute('position', new three.Float32BufferAttribute(xyz, 3));
    out.push(new three.Points(geometry, new three.PointsMaterial({ color: colour, size: 5, sizeAttenuation: false })));
  }
  return out;
}

function ofSegments(shape, hit, colour) {
  const rows = chosen(shape, shape.numbers, 6, hit);
  return rows.length ? [lines(rows, colour, hit ? 2.5 : 1)] : [];
}

const isSurface = (part) => part.isMesh && !part.isLineSegments2;

export const modes = ['solid', 'ghost', 'hidden'];

export class Drawn {
  constructor(shape, mode, base) {
    this.group = new three.Group();
    this.group.matrixAutoUpdate = false;
    const colours = [colourOf(base), colourOf(shape.header.hit)];
    this.base = colours[0];
    this.parts = [0, 1].map((hit) => {
      const material = surfaceMaterial(colours[hit], hit);
      if (shape.form === 'triangles') return ofTriangles(shape, hit, material, colours[hit]);
      return shape.form === 'spheres' ? ofSpheres(shape, hit, material, colours[hit]) : ofSegments(shape, hit, colours[hit]);
    });
    for (const part of this.parts.flat()) part.lit = part.material;
    for (const part of this.parts.flat().filter(isSurface))
      part.wires = new three.MeshBasicMaterial({ color: part.material.color, wireframe: true });
    this.before = []; // what a ghost writes to the depth alone
    for (const mesh of this.parts[0])
      if (isSurface(mesh)) {
        const depth = mesh.clone();
        depth.material = mesh.material.clone();
        depth.material.colorWrite = false;
        this.before.push(depth);
      }
    this.group.add(...this.before, ...this.parts[0], ...this.parts[1]);
    this.wire = false;
    this.set(mode);
  }

  set(mode) {
    this.mode = mode;
    this.group.visible = mode !== 'hidden';
    const ghost = mode === 'ghost';
    for (const part of this.parts[0]) {
      for (const material of [part.lit, part.wires ?? part.lit]) {
        material.transparent = ghost;
        material.opacity = ghost ? 0.32 : 1;
        material.depthWrite = !ghost;
        material.needsUpdate = true;
      }
      part.renderOrder = ghost ? 2 : 0;
    }
    for (const part of this.before) {
      part.visible = ghost && !this.wire;
      part.renderOrder = 1; // behind all that is opaque
    }
  }
  wireframe(on) {
    this.wire = on;
    for (const part of this.parts.flat()) part.material = on && part.wires ? part.wires : part.lit;
    this.set(this.mode);
  }
  solids() {
    return this.mode === 'solid' ? this.parts.flat().filter(isSurface) : [];
  }
  tint(colour) {
    for (const part of this.parts[0])
      for (const material of [part.lit, part.wires ?? part.lit]) material.color.copy(colour ?? this.base);
  }
}
