// A room in which things are drawn by three.js only when something has changed: camera, light, turning by hand, fitting.

import {
  AmbientLight,
  Box3,
  type BufferGeometry,
  DirectionalLight,
  type Material,
  Mesh,
  type Object3D,
  OrthographicCamera,
  Scene,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

/** Room around what is fitted to the view. */
const MARGIN = 1.22;

export class Stage {
  readonly scene = new Scene();
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -10, 10);
  readonly controls: OrbitControls;
  /** Called after every drawing. */
  ondrawn: (() => void) | undefined;
  #renderer: WebGLRenderer;
  #content: Object3D | undefined;
  #frame = 0;
  #resize: ResizeObserver;
  #extent = { width: 1, height: 1 };
  #halfHeight = 1;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    const light = new DirectionalLight(0xffffff, 2.1);
    light.position.set(1, 2, 3);
    this.camera.add(light);
    this.scene.add(this.camera, new AmbientLight(0xffffff, 1.1));
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.invalidate());
    this.#resize = new ResizeObserver(() => this.#measure());
    this.#resize.observe(canvas.parentElement ?? canvas);
    addEventListener("beforeprint", this.#draw);
  }

  up(direction: Vector3): void {
    this.camera.up.copy(direction);
  }

  /** Puts something in the place of what was there, whose memory is given back. */
  replace(content: Object3D): void {
    if (this.#content) {
      this.scene.remove(this.#content);
      release(this.#content);
    }
    this.#content = content;
    this.scene.add(content);
  }

  /** Looks at everything visible, from a direction if one is given. */
  fit(from?: Vector3, only?: Object3D): void {
    const target = only ?? this.#content;
    if (!target) return;
    target.updateMatrixWorld(true);
    const box = new Box3();
    target.traverseVisible((part) => void (part instanceof Mesh && box.expandByObject(part)));
    if (box.isEmpty()) box.setFromObject(target);
    const centre = box.getCenter(new Vector3());
    const radius = Math.max(1e-6, box.getSize(new Vector3()).length() / 2);
    const direction = from?.clone() ?? this.camera.position.clone().sub(this.controls.target);
    direction.normalize().multiplyScalar(radius * 4);
    this.controls.target.copy(centre);
    this.camera.position.copy(centre).add(direction);
    this.camera.near = -radius * 12;
    this.camera.far = radius * 24;
    this.camera.zoom = 1;
    this.controls.update();
    this.camera.updateMatrixWorld(true);
    this.#extent = seenExtent(box, this.camera);
    this.#measure();
  }

  /** Turns the view by angles in radians, or zooms, as keys do. */
  turn(aside: number, upwards: number, zoom = 1): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const up = this.camera.up.clone().normalize();
    offset.applyAxisAngle(up, aside);
    const sideways = new Vector3().crossVectors(up, offset).normalize();
    offset.applyAxisAngle(sideways, upwards);
    this.camera.position.copy(this.controls.target).add(offset);
    this.camera.zoom *= zoom;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.invalidate();
  }

  /** Moves the view by shares of its height, as keys do. */
  pan(aside: number, upwards: number): void {
    const height = (2 * this.#halfHeight) / this.camera.zoom;
    const right = new Vector3().setFromMatrixColumn(this.camera.matrix, 0).multiplyScalar(aside * height);
    const shift = right.add(new Vector3().setFromMatrixColumn(this.camera.matrix, 1).multiplyScalar(upwards * height));
    this.camera.position.add(shift);
    this.controls.target.add(shift);
    this.controls.update();
    this.invalidate();
  }

  /** Turns, moves or zooms by a key; tells whether it was one of these keys. */
  press(event: KeyboardEvent): boolean {
    const arrows: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    };
    const arrow = arrows[event.key];
    if (arrow && event.shiftKey) this.pan(arrow[0] * 0.05, arrow[1] * 0.05);
    else if (arrow) this.turn(arrow[0] * 0.1, -arrow[1] * 0.1);
    else if (event.key === "+") this.turn(0, 0, 1.15);
    else if (event.key === "-") this.turn(0, 0, 1 / 1.15);
    else if (event.key.toLowerCase() === "f") this.fit();
    else return false;
    return true;
  }

  /** Where a place of the room stands on the canvas, in CSS pixels. */
  project(at: Vector3): { x: number; y: number } {
    const seen = at.clone().project(this.camera);
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((seen.x + 1) / 2) * clientWidth, y: ((1 - seen.y) / 2) * clientHeight };
  }

  /** How many pixels of the screen a length of 1 mm takes. */
  pixelsPerMillimetre(): number {
    return (this.canvas.clientHeight * this.camera.zoom) / (2 * this.#halfHeight);
  }

  invalidate(): void {
    if (this.#frame) return;
    this.#frame = requestAnimationFrame(this.#draw);
  }

  /** Also just before printing, for a browser keeps no drawing after it has been shown. */
  #draw = (): void => {
    this.#frame = 0;
    this.#renderer.render(this.scene, this.camera);
    this.ondrawn?.();
  };

  #measure(): void {
    const room = this.canvas.parentElement ?? this.canvas;
    const [width, height] = [Math.max(1, room.clientWidth), Math.max(1, room.clientHeight)];
    this.#renderer.setSize(width, height, true);
    this.#halfHeight = Math.max(this.#extent.height, (this.#extent.width * height) / width) * MARGIN;
    this.camera.top = this.#halfHeight;
    this.camera.bottom = -this.#halfHeight;
    this.camera.right = (this.#halfHeight * width) / height;
    this.camera.left = -this.camera.right;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  destroy(): void {
    cancelAnimationFrame(this.#frame);
    this.#resize.disconnect();
    removeEventListener("beforeprint", this.#draw);
    this.controls.dispose();
    if (this.#content) release(this.#content);
    this.#renderer.dispose();
  }
}

/** Half of what a box takes to the side and upwards, as the camera sees it. */
function seenExtent(box: Box3, camera: OrthographicCamera): { width: number; height: number } {
  const extent = { width: 1e-6, height: 1e-6 };
  const centre = box.getCenter(new Vector3()).applyMatrix4(camera.matrixWorldInverse);
  for (const x of [box.min.x, box.max.x]) {
    for (const y of [box.min.y, box.max.y]) {
      for (const z of [box.min.z, box.max.z]) {
        const corner = new Vector3(x, y, z).applyMatrix4(camera.matrixWorldInverse).sub(centre);
        extent.width = Math.max(extent.width, Math.abs(corner.x));
        extent.height = Math.max(extent.height, Math.abs(corner.y));
      }
    }
  }
  return extent;
}

function release(root: Object3D): void {
  root.traverse((part) => {
    const some = part as Partial<{ geometry: BufferGeometry; material: Material }>;
    some.geometry?.dispose();
    some.material?.dispose();
  });
}
