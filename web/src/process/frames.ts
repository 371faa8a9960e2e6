// Frames of a stage: the pose between two of them, so that motion is smooth where frames are far apart.

import type { SceneFrame } from "../api/types";

type Quaternion = [number, number, number, number];

/** The frame at a place of the coordinate: poses are blended between neighbours, contacts are those of the nearer one. */
export function frameAt(frames: SceneFrame[], at: number): SceneFrame | undefined {
  const last = frames.at(-1);
  if (!last) return undefined;
  const next = frames.findIndex((frame) => frame.at >= at);
  if (next < 0) return last;
  const [a, b] = [frames[Math.max(0, next - 1)]!, frames[next]!];
  if (next === 0 || b.at === a.at) return b;
  const share = (at - a.at) / (b.at - a.at);
  const poses: SceneFrame["poses"] = {};
  for (const id of new Set([...Object.keys(a.poses), ...Object.keys(b.poses)])) {
    const [from, to] = [a.poses[id], b.poses[id]];
    poses[id] = from && to ? blend(from, to, share) : (from ?? to)!;
  }
  const nearer = share < 0.5 ? a : b;
  return nearer.trace ? { at, poses, contact: nearer.contact, trace: nearer.trace } : { at, poses, contact: nearer.contact };
}

/** A pose between two: translation along the line, rotation along the shortest arc. */
export function blend(a: number[], b: number[], share: number): number[] {
  const q = slerp(quaternionOf(a), quaternionOf(b), share);
  const translation = [9, 10, 11].map((at) => a[at]! + (b[at]! - a[at]!) * share);
  return [...rotationOf(q), ...translation];
}

function quaternionOf(m: number[]): Quaternion {
  const [a, b, c, d, e, f, g, h, i] = m as [number, number, number, number, number, number, number, number, number];
  const trace = a + e + i;
  if (trace > 0) {
    const s = 2 * Math.sqrt(trace + 1);
    return [(h - f) / s, (c - g) / s, (d - b) / s, s / 4];
  }
  if (a > e && a > i) {
    const s = 2 * Math.sqrt(1 + a - e - i);
    return [s / 4, (b + d) / s, (c + g) / s, (h - f) / s];
  }
  if (e > i) {
    const s = 2 * Math.sqrt(1 + e - a - i);
    return [(b + d) / s, s / 4, (f + h) / s, (c - g) / s];
  }
  const s = 2 * Math.sqrt(1 + i - a - e);
  return [(c + g) / s, (f + h) / s, s / 4, (d - b) / s];
}

function slerp(a: Quaternion, b: Quaternion, share: number): Quaternion {
  const dot = a.reduce((sum, value, at) => sum + value * b[at]!, 0);
  const sign = dot < 0 ? -1 : 1;
  const angle = Math.acos(Math.min(1, Math.abs(dot)));
  const sine = Math.sin(angle);
  const [wa, wb] = sine < 1e-9 ? [1 - share, share] : [Math.sin((1 - share) * angle) / sine, Math.sin(share * angle) / sine];
  return a.map((value, at) => wa * value + sign * wb * b[at]!) as Quaternion;
}

function rotationOf([x, y, z, w]: Quaternion): number[] {
  return [
    1 - 2 * (y * y + z * z),
    2 * (x * y - z * w),
    2 * (x * z + y * w),
    2 * (x * y + z * w),
    1 - 2 * (x * x + z * z),
    2 * (y * z - x * w),
    2 * (x * z - y * w),
    2 * (y * z + x * w),
    1 - 2 * (x * x + y * y),
  ];
}
