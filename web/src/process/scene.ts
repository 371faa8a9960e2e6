// The bodies of a scene in the room, moved to the frames of a stage, with contact and finished lines.

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  FrontSide,
  Group,
  Line,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  Points,
  PointsMaterial,
  Vector3,
} from "three";
import type { Scene, SceneBody, SceneFrame, SceneStage } from "../api/types";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { frameAt } from "./frames";
import { Stage } from "./stage";

/** Colours by what a body is: workpieces grey, tools blue, dressers ochre, light and stylus red. */
const COLOURS: Record<string, string> = {
  gear: "#b9c0c7",
  part: "#b9c0c7",
  worm: "#5487b6",
  dresser: "#cb7e3d",
  cutter: "#5487b6",
  tool: "#5487b6",
  beam: "#d2452b",
  stylus: "#d2452b",
};
/** Faces that meet at more than this angle, in rad, show an edge. */
const SHARP_EDGE = 0.5;
const CONTACT = "#d8341c";
const TRACE = "#3f7050";

export class ProcessScene {
  readonly stage: Stage;
  #bodies = new Map<string, Mesh>();
  #root = new Group();
  #contactLine = new Line(new BufferGeometry(), new LineBasicMaterial({ color: CONTACT, depthTest: false }));
  #contactPoints = new Points(
    new BufferGeometry(),
    new PointsMaterial({ color: CONTACT, size: 7, sizeAttenuation: false, depthTest: false }),
  );
  #trace = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: TRACE, depthTest: false }));
  #hidden = new Set<string>();
  #isMoved = new Set<string>();
  /** The bodies that the frames of a stage place, by the stage. */
  #placed = new Map<string, Set<string>>();

  constructor(canvas: HTMLCanvasElement, scene: Scene) {
    this.stage = new Stage(canvas);
    this.stage.up(new Vector3(0, 0, 1));
    for (const body of scene.bodies) {
      const mesh = meshOf(body);
      this.#bodies.set(body.id, mesh);
      this.#root.add(mesh);
    }
    this.#isMoved = new Set(scene.stages.flatMap((some) => some.frames.flatMap((frame) => Object.keys(frame.poses))));
    for (const mark of [this.#contactLine, this.#contactPoints, this.#trace]) {
      mark.renderOrder = 2;
      mark.frustumCulled = false;
      this.#root.add(mark);
    }
    this.stage.replace(this.#root);
  }

  /** Shows the bodies of a stage at a place of its coordinate. Bodies that no frame of it names stand aside. */
  show(stage: SceneStage, at: number): SceneFrame | undefined {
    const frame = frameAt(stage.frames, at);
    if (!frame) return undefined;
    for (const [id, mesh] of this.#bodies) {
      const pose = frame.poses[id];
      if (pose) {
        mesh.matrix.copy(matrixOf(pose));
        mesh.matrixWorldNeedsUpdate = true;
      }
      mesh.visible = this.isPartOf(stage, id) && !this.#hidden.has(id);
    }
    const points = frame.contact.flat();
    setPositions(this.#contactLine.geometry, points);
    setPositions(this.#contactPoints.geometry, points);
    setPositions(this.#trace.geometry, segmentsOf(frame.trace ?? []));
    this.stage.invalidate();
    return frame;
  }

  /** A body belongs to a stage if its frames place it, or if no stage does: then it stands still in all of them. */
  isPartOf(stage: SceneStage, id: string): boolean {
    let placed = this.#placed.get(stage.id);
    if (!placed) {
      placed = new Set(stage.frames.flatMap((frame) => Object.keys(frame.poses)));
      this.#placed.set(stage.id, placed);
    }
    return !this.#isMoved.has(id) || placed.has(id);
  }

  hide(id: string, isHidden: boolean): void {
    if (isHidden) this.#hidden.add(id);
    else this.#hidden.delete(id);
  }

  look(direction: Vector3): void {
    this.stage.fit(direction);
  }

  /** Looks at a stage from the side where its cutter stands: the teeth of a bevel gear may lie below. */
  lookAtWork(stage: SceneStage): void {
    const work = new Box3();
    const tool = new Box3();
    for (const [id, mesh] of this.#bodies) {
      if (!mesh.visible) continue;
      const kind = mesh.userData["kind"];
      if (kind === "gear" || kind === "part") work.expandByObject(mesh);
      if (kind === "cutter") for (const frame of stage.frames) tool.expandByPoint(middleOf(mesh, frame.poses[id]));
    }
    const from = DIRECTIONS.iso.clone();
    if (!work.isEmpty() && !tool.isEmpty()) {
      const apart = tool.getCenter(new Vector3()).sub(work.getCenter(new Vector3()));
      const height = work.getSize(new Vector3()).z;
      if (apart.z < -0.1 * height) from.z = -from.z;
    }
    this.stage.fit(from);
  }

  /** Turns to the places of contact, closely. */
  zoomToContact(): void {
    const box = new Box3().setFromBufferAttribute(this.#contactPoints.geometry.getAttribute("position") as BufferAttribute);
    if (box.isEmpty()) return;
    const centre = box.getCenter(new Vector3());
    const shift = centre.clone().sub(this.stage.controls.target);
    this.stage.controls.target.copy(centre);
    this.stage.camera.position.add(shift);
    this.stage.camera.zoom = Math.max(this.stage.camera.zoom, 4);
    this.stage.camera.updateProjectionMatrix();
    this.stage.controls.update();
    this.stage.invalidate();
  }

  destroy(): void {
    this.stage.destroy();
  }
}

function meshOf(body: SceneBody): Mesh {
  const indexed = new BufferGeometry();
  indexed.setAttribute("position", new BufferAttribute(new Float32Array(body.positions), 3));
  indexed.setIndex(new BufferAttribute(new Uint32Array(body.indices), 1));
  const geometry = toCreasedNormals(indexed, SHARP_EDGE);
  indexed.dispose();
  const isLight = body.kind === "beam";
  const paint = new MeshLambertMaterial({
    color: COLOURS[body.kind] ?? "#9aa4ad",
    side: body.closed === false ? DoubleSide : FrontSide,
    transparent: isLight,
    opacity: isLight ? 0.75 : 1,
  });
  const mesh = new Mesh(geometry, paint);
  mesh.matrixAutoUpdate = false;
  mesh.userData["kind"] = body.kind;
  return mesh;
}

/** A pose: rotation row by row, then translation. */
function matrixOf(p: number[]): Matrix4 {
  const [a, b, c, d, e, f, g, h, i, x, y, z] = p as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  return new Matrix4().set(a, b, c, x, d, e, f, y, g, h, i, z, 0, 0, 0, 1);
}

/** The middle of a body where a pose has it. */
function middleOf(mesh: Mesh, pose: number[] | undefined): Vector3 {
  if (!mesh.geometry.boundingBox) mesh.geometry.computeBoundingBox();
  const middle = mesh.geometry.boundingBox!.getCenter(new Vector3());
  return pose ? middle.applyMatrix4(matrixOf(pose)) : middle;
}

function setPositions(geometry: BufferGeometry, points: number[]): void {
  // Another number of points needs another buffer; the old one is given back.
  geometry.dispose();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
}

function segmentsOf(lines: [number, number, number][][]): number[] {
  return lines.flatMap((line) => line.slice(1).flatMap((point, at) => [...line[at]!, ...point]));
}

export const DIRECTIONS = {
  iso: new Vector3(1, -1.3, 0.8),
  x: new Vector3(1, 0, 0),
  y: new Vector3(0, -1, 0),
  z: new Vector3(0, -0.001, 1),
} as const;
