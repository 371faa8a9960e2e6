// The topography of both flanks as nets in space: length of roll and face position as they are, heights magnified.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Vector3,
} from "three";
import { signedRgb } from "../lib/colour";
import { Stage } from "../process/stage";

/** Lines of the net: the colours of the surface are light in every appearance of the page. */
const NET_INK = "#1c1f23";

export interface NetPanel {
  title: string;
  profile: number[];
  helix: number[];
  grid: number[][];
}

export interface NetLabel {
  at: Vector3;
  text: string;
  kind: "title" | "axis" | "value";
}

export interface NetOptions {
  /** Height in mm drawn for 1 mm of deviation. */
  magnification: number;
  most: number;
  ink: string;
  labels: { profile: string; helix: string; value: (um: number) => string };
}

export class NetStage {
  readonly stage: Stage;
  labels: NetLabel[] = [];
  #shape = "";

  constructor(canvas: HTMLCanvasElement) {
    this.stage = new Stage(canvas);
    this.stage.up(new Vector3(0, 0, 1));
  }

  /** Draws the panels; the view stays where it is as long as their shape does. */
  draw(panels: NetPanel[], options: NetOptions): void {
    const group = new Group();
    this.labels = [];
    const widest = Math.max(...panels.map((panel) => span(panel.helix)));
    const pitch = widest * 1.32;
    panels.forEach((panel, at) => {
      const x = (at - (panels.length - 1) / 2) * pitch;
      this.#panel(group, panel, x, options);
    });
    this.stage.replace(group);
    const shape = panels.map((panel) => `${span(panel.helix)}x${span(panel.profile)}`).join();
    if (shape !== this.#shape) this.stage.fit(new Vector3(0.16, -1.25, 0.85));
    this.#shape = shape;
    this.stage.invalidate();
  }

  #panel(group: Group, panel: NetPanel, x: number, options: NetOptions): void {
    // The profile is short beside the face width: it is drawn longer, at least half as long.
    const stretch = Math.max(1, (0.55 * span(panel.helix)) / span(panel.profile));
    const [z0, w0] = [middle(panel.helix), middle(panel.profile)];
    const place = (row: number, column: number, um: number): [number, number, number] => [
      x + panel.helix[column]! - z0,
      (panel.profile[row]! - w0) * stretch,
      (um / 1000) * options.magnification,
    ];
    const [rows, columns] = [panel.profile.length, panel.helix.length];
    const positions: number[] = [];
    const colours: number[] = [];
    const colour = new Color();
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < columns; column++) {
        const um = panel.grid[row]?.[column] ?? 0;
        positions.push(...place(row, column, Number.isFinite(um) ? um : 0));
        const [r, g, b] = signedRgb(um / options.most);
        colour.setRGB(r / 255, g / 255, b / 255, "srgb");
        colours.push(colour.r, colour.g, colour.b);
      }
    }
    const faces: number[] = [];
    for (let row = 0; row + 1 < rows; row++) {
      for (let column = 0; column + 1 < columns; column++) {
        const a = row * columns + column;
        faces.push(a, a + 1, a + columns + 1, a, a + columns + 1, a + columns);
      }
    }
    const surface = new BufferGeometry();
    surface.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
    surface.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
    surface.setIndex(faces);
    const paint = new MeshBasicMaterial({
      vertexColors: true,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    group.add(new Mesh(surface, paint));
    group.add(lines(netLines(positions, rows, columns), NET_INK, 0.5));
    const corner = (row: number, column: number): [number, number, number] => place(row, column, 0);
    const [a, b, c, d] = [corner(0, 0), corner(0, columns - 1), corner(rows - 1, columns - 1), corner(rows - 1, 0)];
    group.add(lines([...a, ...b, ...b, ...c, ...c, ...d, ...d, ...a], options.ink, 0.9));
    this.#label(panel, place, options);
  }

  #label(
    panel: NetPanel,
    place: (row: number, column: number, um: number) => [number, number, number],
    options: NetOptions,
  ): void {
    const [rows, columns] = [panel.profile.length, panel.helix.length];
    const at = (row: number, column: number, um: number, dx = 0, dy = 0): Vector3 => {
      const [x, y, z] = place(row, column, um);
      return new Vector3(x + dx, y + dy, z);
    };
    const off = span(panel.helix) * 0.09;
    const low = Math.min(0, ...panel.grid.flat().filter(Number.isFinite));
    this.labels.push({ at: at(rows - 1, Math.floor(columns / 2), 0, 0, 2 * off), text: panel.title, kind: "title" });
    this.labels.push({ at: at(0, Math.floor(columns / 2), low, 0, -off), text: options.labels.helix, kind: "axis" });
    this.labels.push({ at: at(Math.floor(rows / 2), 0, low, -1.6 * off), text: options.labels.profile, kind: "axis" });
    for (const [row, column] of [
      [0, 0],
      [0, columns - 1],
      [rows - 1, 0],
      [rows - 1, columns - 1],
    ] as const) {
      const um = panel.grid[row]?.[column] ?? NaN;
      if (Number.isFinite(um)) this.labels.push({ at: at(row, column, um), text: options.labels.value(um), kind: "value" });
    }
  }
}

const span = (list: number[]): number => Math.abs((list.at(-1) ?? 1) - (list[0] ?? 0)) || 1;
const middle = (list: number[]): number => ((list.at(-1) ?? 0) + (list[0] ?? 0)) / 2;

function lines(points: number[], ink: string, opacity: number): LineSegments {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color: ink, transparent: true, opacity }));
}

/** Every line of a coarse grid, every second of one with more than 31 points. */
function netLines(positions: number[], rows: number, columns: number): number[] {
  const points: number[] = [];
  const push = (at: number): void => void points.push(positions[3 * at]!, positions[3 * at + 1]!, positions[3 * at + 2]!);
  const step = (count: number): number => Math.max(1, Math.round((count - 1) / 20));
  for (let row = 0; row < rows; row += step(rows)) {
    for (let column = 0; column + 1 < columns; column++) {
      push(row * columns + column);
      push(row * columns + column + 1);
    }
  }
  for (let column = 0; column < columns; column += step(columns)) {
    for (let row = 0; row + 1 < rows; row++) {
      push(row * columns + column);
      push((row + 1) * columns + column);
    }
  }
  return points;
}
