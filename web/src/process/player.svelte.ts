// Plays a stage: the place on its coordinate moves with the clock, from the first to the last frame and again.

import type { SceneStage } from "../api/types";

/** A stage takes this long at speed 1. */
const SECONDS = 12;

export class Player {
  #chosen = $state(0);
  share = $state(0);
  speed = $state(1);
  isPlaying = $state(false);
  #frame = 0;
  #last = 0;

  constructor(readonly stages: SceneStage[]) {}

  get stage(): SceneStage {
    return this.stages[this.#chosen]!;
  }

  get from(): number {
    return this.stage.frames[0]?.at ?? 0;
  }

  get to(): number {
    return this.stage.frames.at(-1)?.at ?? 1;
  }

  /** The place on the coordinate of the stage. */
  get at(): number {
    return this.from + (this.to - this.from) * this.share;
  }

  choose(id: string): void {
    this.#chosen = Math.max(
      0,
      this.stages.findIndex((stage) => stage.id === id),
    );
    this.share = 0;
  }

  turn(): void {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  play(): void {
    if (this.share >= 1) this.share = 0;
    this.isPlaying = true;
    this.#last = performance.now();
    this.#frame = requestAnimationFrame((now) => this.#advance(now));
  }

  pause(): void {
    this.isPlaying = false;
    cancelAnimationFrame(this.#frame);
  }

  /** Goes to the next or previous frame. */
  step(by: number): void {
    this.pause();
    const frames = this.stage.frames;
    const slack = 1e-9 * Math.abs(this.to - this.from);
    const next =
      by > 0 ? frames.find((frame) => frame.at > this.at + slack) : frames.findLast((frame) => frame.at < this.at - slack);
    if (next && this.to !== this.from) this.share = (next.at - this.from) / (this.to - this.from);
  }

  #advance(now: number): void {
    if (!this.isPlaying) return;
    const share = this.share + ((now - this.#last) / 1000 / SECONDS) * this.speed;
    this.#last = now;
    this.share = share > 1 ? 0 : share;
    this.#frame = requestAnimationFrame((next) => this.#advance(next));
  }
}
