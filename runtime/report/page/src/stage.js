// The canvas: a camera, a light at its side, and a frame only where something has changed.
import * as three from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

export class Stage {
  constructor(canvas) {
    this.canvas = canvas;
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true });
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.scene = new three.Scene();
    this.camera = new three.PerspectiveCamera(35, 1, 0.01, 100);
    this.scene.add(this.camera, new three.HemisphereLight(0xffffff, 0x8890a0, 1.5));
    const sun = new three.DirectionalLight(0xffffff, 1.9);
    sun.position.set(-0.45, 0.62, 0.65);
    this.camera.add(sun);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.request());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.frames = 0; // drawn so far
    this.plane = null;
    this.around = new three.Sphere(new three.Vector3(), 1);
  }

  request() {
    this.wanted ??= requestAnimationFrame(() => this.draw());
  }
  draw() {
    if (this.wanted !== undefined) cancelAnimationFrame(this.wanted);
    this.wanted = undefined;
    const { camera, around } = this;
    // The planes follow the scene: otherwise a small or large one is empty.
    const distance = camera.position.distanceTo(around.center), near = camera.position.distanceTo(this.controls.target);
    camera.near = Math.max(distance - 1.01 * around.radius, 0.02 * near, 1e-7 * around.radius);
    camera.far = Math.max(distance + 1.01 * around.radius, 2 * camera.near);
    camera.updateProjectionMatrix();
    this.renderer.clippingPlanes = this.plane ? [this.plane] : [];
    this.renderer.render(this.scene, camera);
    ++this.frames;
    this.drawn?.();
  }
  resize() {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement;
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / Math.max(h, 1);
    this.request();
  }
  background(css) {
    this.scene.background = new three.Color(css);
    this.request();
  }

  // The camera's place and target, six numbers.
  view() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }
  show(view) {
    this.camera.position.fromArray(view);
    this.controls.target.fromArray(view, 3);
    this.controls.update();
    this.request();
  }
  fitting(sphere, direction) {
    const angle = (Math.min(1, this.camera.aspect) * this.camera.fov * Math.PI) / 360;
    const distance = sphere.radius / Math.sin(angle);
    const from = direction.clone().normalize().multiplyScalar(distance).add(sphere.center);
    return [...from.toArray(), ...sphere.center.toArray()];
  }
  fit() {
    this.fly(this.fitting(this.around, new three.Vector3(0.45, 0.29, 0.85)));
  }
  fly(to) {
    cancelAnimationFrame(this.flying);
    const still = matchMedia('(prefers-reduced-motion: reduce)').matches || this.jumps || this.frames === 0;
    if (still) return this.show(to);
    const from = this.view(), begin = performance.now();
    const step = (now) => {
      const t = Math.min(1, Math.max(0, (now - begin) / 400)), s = t * t * (3 - 2 * t);
      this.show(from.map((x, i) => x + s * (to[i] - x)));
      if (t < 1) this.flying = requestAnimationFrame(step);
    };
    this.flying = requestAnimationFrame(step);
  }
}
