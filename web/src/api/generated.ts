// Made from openapi.json by `npm run types`; not edited.

import type { Json, Table } from "../lib/path";

export interface paths {
  "/api/about": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Version, processes, how busy the server is. */
    get: operations["about"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/catalogue": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Worms and dressers. */
    get: operations["catalogue"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/check": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** What is wrong with a job, and what follows from it. */
    post: operations["check"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/edit": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** A text with entries set or taken out; comments and order stay. */
    post: operations["edit"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/examples": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Examples. */
    get: operations["examples"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/examples/{id}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** An example with the files that it names. */
    get: operations["example"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/machines": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Machines that jobs may name. */
    get: operations["machines"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/measurements": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** Evaluates measurements. */
    post: operations["begin_inspection"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/openapi.json": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** This interface. */
    get: operations["document"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/parts": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Measured parts. */
    get: operations["parts"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/parts/{digest}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** A part with its document. */
    get: operations["part"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/preview": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** The plan without the referee. */
    post: operations["preview"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/programs/check": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** What a program does: axes, travel, speed, time; with a job the flank that it leaves. */
    post: operations["check_program"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Runs, the newest first. */
    get: operations["runs"];
    put?: never;
    /** Begins a run. */
    post: operations["begin_run"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** A run with its result. A finished run does not change: a request with its `ETag` gets 304. */
    get: operations["run"];
    put?: never;
    post?: never;
    /** Takes a run out that has ended. */
    delete: operations["remove"];
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/again": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** Begins a run of the same job. */
    post: operations["again"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/archive": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** All files of a result as ZIP. */
    get: operations["archive"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/cancel": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    get?: never;
    put?: never;
    /** Ends a run at its next step. */
    post: operations["cancel"];
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/charts/{name}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** A chart of the result as SVG. */
    get: operations["chart"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/events": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Server-sent events: `progress`, `state`; the stream ends with the run. */
    get: operations["events"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/files/{name}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** A file of a result. */
    get: operations["file"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/runs/{id}/scene": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Bodies and motions of a run for a view in space. */
    get: operations["scene"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/schema": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** The JSON schema of job files. */
    get: operations["schema"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/series": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Series of parts. */
    get: operations["series"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/templates/{process}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** A commented job of a process. */
    get: operations["template"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/tools": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Skiving tools with a history. */
    get: operations["tools"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/tools/{tool}": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** The measurements of a skiving tool. */
    get: operations["history"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
  "/api/trends": {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    /** Values of characteristics over the parts. */
    get: operations["trends"];
    put?: never;
    post?: never;
    delete?: never;
    options?: never;
    head?: never;
    patch?: never;
    trace?: never;
  };
}
export type webhooks = Record<string, never>;
export interface components {
  schemas: {
    /** @description The program and its queue. */
    About: {
      /** @description What can be planned. */
      processes: components["schemas"]["ProcessSummary"][];
      /** @description Runs that wait or are under way. */
      queue: components["schemas"]["Queue"];
      /** @description Version of flankwright. */
      version: string;
    };
    /** @description How far a run is. */
    Advance: {
      /**
       * Format: int64
       * @description Steps of it that are done.
       */
      done: number;
      /** @description What is done now. */
      stage: string;
      /**
       * Format: int64
       * @description Steps of it.
       */
      total: number;
    };
    /** @description Pulse position less slide. */
    AlongFeedResult: {
      /** @description Limits that `whole` never leaves; absent above the greatest speed and in mode `literal`, which have none. */
      bound?: components["schemas"]["RangeUm"] | null;
      /**
       * Format: double
       * @description The same at the flank.
       */
      direction_offset_flank_um?: number | null;
      /**
       * Format: double
       * @description Mean downwards less mean upwards: how far both senses differ at one place of the slide.
       */
      direction_offset_um?: number | null;
      /**
       * Format: double
       * @description The same downwards.
       */
      mean_down_um?: number | null;
      /**
       * Format: double
       * @description Mean error at constant speed upwards.
       */
      mean_up_um?: number | null;
      /** @description The same at constant speed. */
      steady?: components["schemas"]["RangeUm"] | null;
      /** @description Limits that `steady` never leaves; absent as `bound`. */
      steady_bound?: components["schemas"]["RangeUm"] | null;
      /** @description From the second reference pulse to the end; absent with fewer pulses. */
      whole?: components["schemas"]["RangeUm"] | null;
      /** @description Whether `whole` and `steady` keep to their limits. */
      within_bound?: boolean | null;
    };
    /** @description Additional rotation less that of the lead. */
    AngleResult: {
      /** @description Limits at the flank: those along the feed, the counting and the rounding of the ratio; absent as those along the feed. */
      bound?: components["schemas"]["RangeUm"] | null;
      /** @description The same at the flank, normal. */
      flank: components["schemas"]["RangeUm"];
      /**
       * Format: double
       * @description Greatest, rad.
       */
      greatest_rad: number;
      /**
       * Format: double
       * @description Least, rad.
       */
      least_rad: number;
      /** @description Whether `flank` keeps to them. */
      within_bound?: boolean | null;
    };
    /**
     * @description Features of a flank: of the surface of second degree through what was measured, mean of the teeth, normal to the flank. The surface between
     *     lines is reconstructed; `surface` says from what.
     */
    ArealResult: {
      /**
       * Format: double
       * @description C_alpha.
       */
      Ca_um: number;
      /**
       * Format: double
       * @description C_beta.
       */
      Cb_um: number;
      /**
       * Format: double
       * @description S; absent where the lines do not tell it.
       */
      S_um?: number | null;
      /**
       * Format: double
       * @description Share of the squares that it explains.
       */
      explained_share: number;
      /**
       * Format: double
       * @description f_Ha, material rising to the tip.
       */
      fHa_um: number;
      /**
       * Format: double
       * @description f_Hb, material rising to +z.
       */
      fHb_um: number;
      /** @description Lengths of roll and heights that the features refer to. */
      field_mm: [number, number][];
      /**
       * Format: double
       * @description What it leaves, largest minus smallest.
       */
      form_um: number;
      /** @description How far profiles and helix traces disagree where they cross: root mean square and largest. */
      mismatch_um?: [number, number];
      /** @description How far the field goes beyond the outermost lines, as a share of it, where that is far. */
      outside_traces?: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description What the surface of second degree leaves, root mean square.
       */
      rest_rms_um: number;
      /** @description What the surface was made of. */
      surface: string;
      /**
       * Format: uint
       * @description Teeth that were measured so.
       */
      teeth: number;
    };
    /** @description Several axes of the machine that may be off at once. */
    AxesTogether: {
      /** @description The axes with what each would be off by, in the order in which they were found. */
      axes: components["schemas"]["JointAxis"][];
      /**
       * Format: double
       * @description Share of the squares of the measured lines that they explain together.
       */
      explains: number;
    };
    /** @description The coordinate that a mirror reverses. */
    Axis: "z";
    /** @description The change that one axis makes. */
    AxisInfluence: {
      /** @description Name of the axis, or `all`. */
      axis: string;
      /**
       * Format: double
       * @description Largest distance from the change by the first derivatives.
       */
      beyond_first_order_um: number;
      /**
       * Format: double
       * @description Its deviation in degrees or mm; absent where all axes deviate.
       */
      deviation: number | null;
      /** @description Normal change of the modification over `w_mm` of the curve. */
      f_n_um: number[];
      /**
       * Format: double
       * @description Change in the middle.
       */
      middle_um: number;
      /**
       * Format: double
       * @description Change at the end, which grinds the root of the gear.
       */
      root_um: number;
      /**
       * Format: double
       * @description Change at the start of the worm's profile, which grinds the tip of the gear.
       */
      tip_um: number;
      /** @description Unit of `deviation`. */
      unit: string;
    };
    /** @description One axis over a program. mm or degrees, per second. */
    AxisResult: {
      /**
       * Format: double
       * @description Greatest acceleration.
       */
      acceleration: number;
      /** @description Name on the machine. */
      axis: string;
      /**
       * Format: double
       * @description Lowest position.
       */
      from: number;
      /**
       * Format: double
       * @description What the machine allows.
       */
      max_acceleration?: number | null;
      /**
       * Format: double
       * @description What the machine allows.
       */
      max_velocity?: number | null;
      /**
       * Format: double
       * @description Highest position.
       */
      to: number;
      /** @description "mm" or "deg". */
      unit: string;
      /**
       * Format: double
       * @description Greatest speed.
       */
      velocity: number;
      /**
       * Format: double
       * @description Whole way.
       */
      way: number;
      /** @description Word in the text. */
      word: string;
    };
    /** @description An axis of the machine that may be off. */
    AxisResult2: {
      /** @description Its name with the unit, as forward models have it. */
      axis: string;
      /**
       * Format: double
       * @description Share of the squares of the measured lines that it explains.
       */
      explains: number;
      /** @description Axes that leave nearly the same. */
      not_told_apart?: string[];
      /**
       * Format: double
       * @description Its standard uncertainty.
       */
      uncertainty: number;
      /**
       * Format: double
       * @description The deviation that explains the measurement best, in that unit.
       */
      value: number;
    };
    /** @description How a trace lies in its band. */
    BandResult: {
      /**
       * Format: double
       * @description Least distance from a limit; below 0 by so much beyond.
       */
      margin_um: number;
      /** @description Whether it lies in it. */
      passed: boolean;
      /**
       * Format: double
       * @description What was added to the trace to lie so.
       */
      shift_um: number;
    };
    /** @description The cheapest set-up that is accurate enough. */
    BestSetUpResult: {
      /**
       * Format: double
       * @description Acceleration, at the flank.
       */
      acceleration_um: number;
      /**
       * Format: double
       * @description Clock.
       */
      clock_hz: number;
      /**
       * Format: double
       * @description Clock: period memory and synchroniser, at the flank.
       */
      clock_um: number;
      /**
       * Format: double
       * @description What it costs.
       */
      cost: number;
      /** @description Whether it is accurate and fast enough. */
      feasible: boolean;
      /**
       * Format: double
       * @description Sum of all parts; absent as `rounding_um`.
       */
      flank_um?: number | null;
      /**
       * Format: double
       * @description Greatest speed.
       */
      greatest_speed_mm_per_min: number;
      /**
       * Format: double
       * @description Largest error along the feed at constant speed, at the flank; absent without a motion or without constant speed.
       */
      measured_steady_um?: number | null;
      /**
       * Format: double
       * @description Largest error of the angle at the flank over the whole motion, starts and stops among it.
       */
      measured_whole_um?: number | null;
      /**
       * Format: double
       * @description Errors of what is measured, at the flank; 0 without `[errors]`.
       */
      measuring_um: number;
      /**
       * Format: uint32
       * @description P.
       */
      pulses_per_interval: number;
      /**
       * Format: double
       * @description Scale of the feed slide.
       */
      pulses_per_metre: number;
      /**
       * Format: uint32
       * @description Encoder of the workpiece.
       */
      pulses_per_revolution: number;
      /**
       * Format: double
       * @description Staircase of the interpolator, at the flank.
       */
      quantisation_um: number;
      /**
       * Format: uint
       * @description Place in the ranking, from 1.
       */
      rank: number;
      /** @description Why not. */
      refused?: string | null;
      /**
       * Format: double
       * @description Half a part of a workpiece pulse, at the flank.
       */
      resolution_um: number;
      /**
       * Format: double
       * @description Counting and rounding of the rotation, at the flank; absent if the coupling cannot be made.
       */
      rounding_um?: number | null;
    };
    /** @description The whole document. */
    BevelInspectionResult: {
      /**
       * Format: double
       * @description F_r: run-out of a ball in the spaces, across the pitch cone.
       */
      Fr_um?: number | null;
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /**
       * Format: int32
       * @description The worst of them; absent where a value is worse than class 11, or nothing was judged.
       */
      class: number | null;
      /** @description Classes of ISO 17485:2006 that the values reach. */
      classes: components["schemas"]["ClassResult"][];
      /** @description The file that was read. */
      files: string[];
      /** @description Rows and columns of the grid. */
      grid: number[];
      /** @description Name of the file that was measured. */
      job: string;
      /** @description Pitches by flank, on the tolerance diameter. */
      pitch: {
        [key: string]: components["schemas"]["PitchInspectionResult"];
      };
      /** @description Where the pitch was measured; absent where not all teeth were. */
      pitch_place?: components["schemas"]["BevelPitchPlace"] | null;
      /** @description Process. */
      process: string;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /**
       * @description Comparison with the job, tests, correction, proof; one round. w is the length of roll in the middle of the face, z counts along the
       *     pitch cone from there to the heel.
       */
      rounds: components["schemas"]["RoundResult"][];
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: int32
       * @description The class of ISO 17485:2006 that was asked for.
       */
      tolerance_class?: number | null;
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um: number;
      /** @description Version of flankwright. */
      version: string;
      /** @description Doubts of reading and evaluation. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description The point of each tooth at which the pitch was measured, and what the tolerances depend on. */
    BevelPitchPlace: {
      /**
       * Format: uint
       * @description Column, from 1 at the toe.
       */
      column: number;
      /**
       * Format: double
       * @description m_mn.
       */
      mean_normal_module_mm: number;
      /**
       * Format: double
       * @description Its distance from the axis.
       */
      radius_mm: number;
      /**
       * Format: uint
       * @description Row, from 1 at the root.
       */
      row: number;
      /**
       * Format: double
       * @description d_T: the mean pitch diameter.
       */
      tolerance_diameter_mm: number;
    };
    /** @description What a blank has on its flanks in all, normal. */
    BlankStockResult: {
      /** @description Files of the measurement. */
      files: string[];
      /** @description Name of the job. */
      job: string;
      /** @description What the level comes from: "span", "balls" or "stock.allowance_um". */
      level_from: string;
      /** @description What to know. */
      remarks: components["schemas"]["Remark"][];
      /** @description Least, mean and greatest of each flank; absent for a flank that was not measured. */
      stock_um: components["schemas"]["Sides8"];
      /** @description Teeth whose traces were measured, on each flank; the others have the mean of them. */
      teeth_with_traces: components["schemas"]["Sides9"];
      /** @description Whether every tooth stands where its pitch says. */
      with_pitch: boolean;
    };
    /** @description A body as triangles. */
    Body: {
      /** @description Whether the triangles close it: every edge has one on each side. An open body is to be drawn from both sides. */
      closed: boolean;
      /** @description Its name in poses. */
      id: string;
      /** @description Three vertices of every triangle, from 0, counterclockwise seen from outside. */
      indices: number[];
      /** @description What it is. */
      kind: components["schemas"]["BodyKind"];
      /** @description x, y, z of every vertex, mm. */
      positions: number[];
    };
    /** @description How near something comes to a body of clamping or machine. */
    BodyClearance: {
      /**
       * Format: uint
       * @description Its block, from 1.
       */
      block: number;
      /** @description Its name. */
      body: string;
      /** @description The program in which that is; empty where one text alone is checked. */
      file?: string;
      /**
       * Format: double
       * @description Least distance, mm: never more than 0.02 mm above the true one.
       */
      least_mm: number;
      /** @description What comes near to it: the worm or a body that the worm's spindle carries. */
      of: string;
    };
    /** @description What a body is. */
    BodyKind: "gear" | "part" | "worm" | "dresser" | "cutter" | "tool" | "beam" | "stylus";
    /** @description The worm on which the dresser works without stretch on both flanks of an asymmetric gear. */
    BothFlanks: {
      /** @description The conical worm that stretches neither flank; absent where none is near. */
      conical: components["schemas"]["WormOfLeastStretch"] | null;
      /** @description The cylindrical worm on which the larger stretch is least; absent where none is near. */
      cylindrical: components["schemas"]["WormOfLeastStretch"] | null;
    };
    /** @description A broken edge. */
    BrokenEdge: {
      /**
       * Format: double
       * @description Depth that takes the chip away, along the rake face's normal, mm: the least by what is seen of it.
       */
      depth_mm: number;
      /** @description Flank of the workpiece that it makes. */
      flank: components["schemas"]["Flank"];
      /**
       * Format: double
       * @description Material that is missing on the worst track, normal to the flank, um; 0 where none is, as of a built-up edge.
       */
      missing_um: number;
      /**
       * Format: uint
       * @description Its tooth, from 0.
       */
      tooth: number;
    };
    /** @description The budget of `docs/mathematics/gearbox.md#error-budget`. Along the feed, unless the key says `flank`. */
    BudgetResult: {
      /**
       * Format: double
       * @description Greatest acceleration of the motion.
       */
      acceleration_mm_per_s2: number;
      /**
       * Format: double
       * @description The speed of the interval before is not that of the running one, at the greatest speed.
       */
      acceleration_um: number;
      /**
       * Format: double
       * @description P beyond which more pulses no longer help at this speed; absent at standstill.
       */
      best_pulses_per_interval?: number | null;
      /**
       * Format: double
       * @description Sum of the four, at the flank.
       */
      flank_um: number;
      /**
       * Format: double
       * @description Staircase p/P.
       */
      quantisation_um: number;
      /**
       * Format: double
       * @description Greatest speed of the motion.
       */
      speed_mm_per_min: number;
      /**
       * Format: double
       * @description Reference pulses are seen up to one tick late.
       */
      synchronisation_um: number;
      /**
       * Format: double
       * @description The period memory holds whole counts.
       */
      truncation_um: number;
    };
    /** @description The beam by a mandrel. */
    CalibrationResult: {
      /** @description Whether switches were given; otherwise they are those to be expected. */
      measured: boolean;
      /** @description The beam's point at the height of `light_barrier.point`. */
      point_mm: [number, number, number];
      /** @description Standard deviations of x and y there. */
      point_sigma_um: [number, number];
      /**
       * Format: double
       * @description r_L.
       */
      radius_mm: number;
      /**
       * Format: double
       * @description Of r_L.
       */
      radius_sigma_um: number;
      /**
       * Format: double
       * @description What is left at the switches.
       */
      residual_um: number;
      /** @description Places of the mandrel at which the beam switches. */
      switches: components["schemas"]["MandrelSwitchResult"][];
      /** @description Of delta and eps. */
      tilt_sigma_deg: [number, number];
      /**
       * Format: double
       * @description delta.
       */
      tilt_x_deg: number;
      /**
       * Format: double
       * @description eps.
       */
      tilt_y_deg: number;
    };
    /** @description One candidate of the diagonal ratio. */
    CandidateResult: {
      /**
       * Format: double
       * @description K.
       */
      diagonal_ratio: number;
      /**
       * Format: double
       * @description Travel of the feed without overrun.
       */
      feed_travel_mm: number;
      /**
       * Format: double
       * @description Largest error of the ideal worm.
       */
      ideal_error_um: number;
      /** @description Place of the profile crowning. */
      profile_crowning_by: string;
      /** @description Why it is not allowed, if so. */
      refused: string | null;
      /**
       * Format: double
       * @description Largest share of an axis limit.
       */
      score: number;
      /**
       * Format: double
       * @description Worm length used.
       */
      worm_occupation_mm: number;
    };
    /** @description Worms and dressers of the store. */
    CatalogueAnswer: {
      /** @description The disc dressers. */
      dresser: components["schemas"]["DresserEntry"][];
      /** @description The grinding worms. */
      worm: components["schemas"]["WormEntry"][];
    };
    /** @description Limits of a search as a file has them. */
    CatalogueLimits: {
      /**
       * Format: double
       * @description Distance from the opposite flank.
       */
      clearance_mm: number;
      /**
       * Format: double
       * @description |d_d|.
       */
      d_d_mm: number;
      /**
       * Format: double
       * @description |d_gamma|.
       */
      d_gamma_deg: number;
      /**
       * Format: double
       * @description |d_phi_S|.
       */
      d_phi_S_deg: number;
      /**
       * Format: double
       * @description |d_v_yA|.
       */
      d_v_yA_mm: number;
      /**
       * Format: double
       * @description Tip land of a dresser whose land the catalogue does not state.
       */
      smallest_tip_land_mm: number;
      /**
       * Format: double
       * @description |P|.
       */
      stretch: number | null;
    };
    /** @description The whole answer. */
    CatalogueOutcome: {
      /** @description Dressers of the catalogue, in its order. */
      dressers: string[];
      /** @description Name of the job. */
      job: string;
      /** @description Limits of the corrections: degrees, degrees, mm, mm. */
      limits: components["schemas"]["CatalogueLimits"];
      /** @description The life of the best pairs. */
      lives: components["schemas"]["LifeCurve"][];
      /**
       * Format: uint
       * @description Number of pairs that make the profile or, ranked by plans, the whole target.
       */
      ok: number;
      /** @description All pairs, the best first. */
      pairs: components["schemas"]["CataloguePair"][];
      /** @description Process. */
      process: string;
      /** @description How the pairs are ranked. */
      ranking: string;
      /**
       * Format: double
       * @description Tolerance of the job, the tightest of its map, normal.
       */
      tolerance_um: number;
      /** @description Version of flankwright. */
      version: string;
      /** @description The same at positions over the width; absent where pairs are ranked by their profile. */
      wanted_over_width?: {
        [key: string]: components["schemas"]["CrowningAt"][];
      };
      /** @description Profile crowning that the target asks for from form to tip diameter, per flank, transverse. */
      wanted_profile_crowning_um: {
        [key: string]: number;
      };
      /** @description Worms of the catalogue, in its order. */
      worms: string[];
    };
    /** @description One pair of the ranking. Figures are absent where the worm cannot be dressed to the profile. */
    CataloguePair: {
      /**
       * @description Profile crownings that the pair can make by its dressing within the limits of the axes, by flank; absent where pairs are ranked by
       *     their profile.
       */
      crowning_range?: {
        [key: string]: components["schemas"]["PairRange"];
      };
      /** @description Name of the dresser. */
      dresser: string;
      /** @description Figures per flank that is ground. */
      flanks: {
        [key: string]: components["schemas"]["PairFlank"];
      };
      /**
       * Format: double
       * @description max |DK_j/limit_j|.
       */
      largest_share_of_limit: number | null;
      /** @description Remaining life of the worm with this dresser. */
      life: components["schemas"]["PairLife"] | null;
      /** @description Whether the pair makes the profile within all limits. */
      ok: boolean;
      /** @description What a plan of the whole target leaves; absent where pairs are ranked by their profile, or this one was not planned. */
      plan?: components["schemas"]["PairPlan"] | null;
      /**
       * Format: uint
       * @description Place in the ranking, from 1.
       */
      rank: number;
      /** @description Why the pair does not make the profile or, ranked by plans, the target, if so. */
      refused: components["schemas"]["Refused"] | null;
      /** @description Name of the worm. */
      worm: string;
      /**
       * Format: double
       * @description Pitch diameter of the worm in its present state.
       */
      worm_pitch_diameter_mm: number | null;
    };
    /** @description A change of the job that was planned because its plan misses the target. */
    ChangeResult: {
      /** @description What the change costs. */
      cost: string;
      /**
       * Format: double
       * @description Largest deviation that is left, normal; null where no plan was found.
       */
      deviation_um: number | null;
      /** @description Keys with their new values, as a job file has them: of one job, or of one for each flank. */
      jobs: components["schemas"]["KeyChange"][][];
      /** @description Why it is not met. */
      reason?: string | null;
      /** @description Whether the target is met with it by plan and simulation; null where no plan was found. */
      status: components["schemas"]["Status"] | null;
    };
    /** @description The test of one characteristic. */
    CharacteristicResult: {
      /** @description fHa, Ca, fHb, Cb or S; slopes of material. */
      characteristic: string;
      /**
       * Format: double
       * @description What all teeth share.
       */
      common_um: number;
      /** @description correct, below-dead-band, not-systematic, first-harmonic or not-tested. */
      decision: string;
      /** @description Flank. */
      flank: string;
      /**
       * Format: double
       * @description Amplitude of the first harmonic around the gear, where it is real: the clamping, which no correction removes.
       */
      harmonic_um?: number | null;
      /**
       * Format: double
       * @description Above this it is corrected.
       */
      limit_um?: number | null;
      /**
       * Format: double
       * @description Probability of so large a mean by chance.
       */
      p?: number | null;
      /**
       * Format: uint
       * @description Readings of each tooth.
       */
      repeats: number;
      /** @description Teeth. */
      teeth: number[];
      /**
       * Format: double
       * @description Standard uncertainty of that; absent with one tooth.
       */
      uncertainty_um?: number | null;
      /** @description Mean of each tooth's readings. */
      values_um: number[];
    };
    /** @description One characteristic of a part. */
    CharacteristicValue: {
      /** @description Flank, where it is one of a flank. */
      flank?: components["schemas"]["Flank"] | null;
      /**
       * Format: double
       * @description Lower limit, in the same unit.
       */
      lower_limit?: number | null;
      /** @description Symbol, e.g. `fHa`, `Fp`; of a line beside the middle one with its mark behind a point, e.g. `fHa.o`. */
      name: string;
      /** @description What was made of single values, e.g. `single`, `mean`, `range`. */
      statistic: string;
      /**
       * Format: uint32
       * @description Tooth as the machine counts, where it is one of a tooth.
       */
      tooth?: number | null;
      /** @description Its unit, e.g. `um`. */
      unit: string;
      /**
       * Format: double
       * @description Upper limit, in the same unit.
       */
      upper_limit?: number | null;
      /**
       * Format: double
       * @description The value, finite.
       */
      value: number;
    };
    /** @description Characteristics in micrometres, transverse unless the key says `normal`; > 0 material removed. */
    CharacteristicsUm: {
      /**
       * Format: double
       * @description C_beta.
       */
      helix_crowning_um: number;
      /**
       * Format: double
       * @description C_Hbeta: > 0 removes at face II.
       */
      helix_slope_um: number;
      /**
       * Format: double
       * @description C_alpha.
       */
      profile_crowning_um: number;
      /**
       * Format: double
       * @description C_Halpha: > 0 removes at the tip.
       */
      profile_slope_um: number;
      /**
       * Format: double
       * @description The same, normal.
       */
      twist_corner_normal_um: number;
      /**
       * Format: double
       * @description Twist S from the corners.
       */
      twist_corner_um: number;
      /**
       * Format: double
       * @description The same, normal.
       */
      twist_fit_normal_um: number;
      /**
       * Format: double
       * @description Twist S from the bilinear term.
       */
      twist_fit_um: number;
    };
    /** @description A chart of a result. */
    Chart: {
      /** @description By which it is asked for. */
      name: string;
      /** @description The section of the report in which it stands. */
      section: string;
      /** @description What it shows. */
      title: string;
    };
    /** @description What is known of a job before anything is planned. */
    CheckAnswer: {
      /** @description What follows from it. */
      derived: components["schemas"]["DerivedSection"][];
      /** @description What is wrong with it. */
      findings: components["schemas"]["Finding"][];
      /** @description Its name. */
      name?: string | null;
      /** @description Findings that were not kept. */
      omitted: number;
      /** @description Its process. */
      process?: string | null;
      /** @description The job as JSON, wherever the text can be parsed. */
      tree?: Table | null;
      /** @description Whether it can be planned, as far as that is known without planning. */
      valid: boolean;
      /** @description Remarks. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description One axis of a checked program. mm or degrees, per second. */
    CheckedAxis: {
      /** @description Name on the machine. */
      axis: string;
      /**
       * Format: double
       * @description Lowest position.
       */
      from: number;
      /**
       * Format: double
       * @description Upper end of travel.
       */
      max?: number | null;
      /**
       * Format: double
       * @description What the machine allows.
       */
      max_velocity?: number | null;
      /**
       * Format: double
       * @description Lower end of travel.
       */
      min?: number | null;
      /**
       * Format: double
       * @description Highest position.
       */
      to: number;
      /** @description "mm" or "deg". */
      unit: string;
      /**
       * Format: double
       * @description Greatest speed of blocks that state a time.
       */
      velocity: number;
      /**
       * Format: double
       * @description Whole way.
       */
      way: number;
      /** @description Word in the text. */
      word: string;
    };
    /** @description One flank as a checked program leaves it. */
    CheckedFlank: {
      /**
       * Format: double
       * @description Largest difference from the flank of the job's own motions.
       */
      difference_um: number;
      /**
       * Format: double
       * @description Largest deviation from the target of the job.
       */
      max_deviation_um: number;
    };
    /** @description Recordings or scans of a checked program. */
    CheckedMeasuring: {
      /**
       * Format: double
       * @description What digits explain of both.
       */
      allowed_um: number;
      /**
       * Format: double
       * @description Greatest distance of the beam's axis from where the contacts want it.
       */
      axis_distance_um: number;
      /**
       * Format: double
       * @description Greatest way of the flank between where the ideal tool touches and its nominal place.
       */
      difference_um: number;
      /** @description What the check says nothing of. */
      not_covered: string[];
      /**
       * Format: uint
       * @description Those that are as it wants them.
       */
      sound: number;
      /** @description In words. */
      statement: string;
      /**
       * Format: uint
       * @description Recordings or edges that the job wants.
       */
      wanted: number;
    };
    /** @description What `program check` says. */
    CheckedProgram: {
      /** @description Axes that the program names. */
      axes: components["schemas"]["CheckedAxis"][];
      /**
       * Format: uint
       * @description Blocks.
       */
      blocks: number;
      /** @description How near the worm and what its spindle carries come to clamping and machine; empty without a job or such bodies. */
      bodies?: components["schemas"]["BodyClearance"][];
      /** @description Control whose language it is. */
      control: string;
      /**
       * Format: double
       * @description Time of all blocks, rapid moves under the limits of the axes, s.
       */
      duration_s: number;
      /** @description The flank that it leaves; absent without a job. */
      flanks?: {
        [key: string]: components["schemas"]["CheckedFlank"];
      } | null;
      /** @description "dressing" or "grinding", as far as the axes tell. */
      kind?: string | null;
      /** @description Name of the machine. */
      machine: string;
      /** @description What a program that measures a skiving tool does for the measurement of the job; absent for other programs. */
      measuring?: components["schemas"]["CheckedMeasuring"] | null;
      /** @description Name of the program, if its text has one. */
      name?: string | null;
      /** @description What a milling program does to the whole part; absent for other programs. */
      part?: components["schemas"]["PartProof"] | null;
      /** @description What does not fit machine or job. */
      remarks: components["schemas"]["Remark"][];
      /** @description Strokes of the tool on the bodies of the job; empty without a job. */
      strokes: components["schemas"]["CheckedStroke"][];
      /** @description Threads of the worm that a dressing program dresses; empty without a job and for other programs. */
      threads?: components["schemas"]["ThreadProof"][];
    };
    /** @description One stroke of a checked program. */
    CheckedStroke: {
      /** @description First and last block, from 1. */
      blocks: number[];
      /**
       * Format: double
       * @description Time, s.
       */
      duration_s: number;
      /** @description Feed z_V2 or worm position v_zS from where to where. */
      range_mm: [number, number];
      /** @description The stroke of the job that it finishes, if it does. */
      serves?: string | null;
    };
    /** @description A step of the choice of variables. */
    ChoiceStep: {
      /**
       * Format: uint
       * @description Variables after it.
       */
      count: number;
      /**
       * Format: double
       * @description Largest |m - f| after it.
       */
      largest_um: number;
      /** @description Taken in, or left out. */
      taken: boolean;
      /** @description The variable. */
      variable: string;
    };
    /** @description The class of a value. */
    ClassResult: {
      /**
       * Format: int32
       * @description Class; absent if worse than 11.
       */
      class: number | null;
      /** @description Flank; absent where it is a value of the gear. */
      flank?: string | null;
      /** @description Symbol. */
      quantity: string;
      /**
       * Format: double
       * @description Value; slopes with their sign.
       */
      value_um: number;
    };
    /** @description What was checked of collisions, from the texts. */
    ClearanceResult: {
      /**
       * @description How near the worm and what its spindle carries come to clamping and machine over all blocks, the nearest first; empty where the
       *     job and the machine's description name no such bodies.
       */
      bodies?: components["schemas"]["BodyClearance"][];
      /**
       * Format: double
       * @description Distance that is kept from them, mm.
       */
      bodies_kept_mm?: number | null;
      /** @description Bodies that were checked against each other, as bodies of revolution. */
      checked: string[];
      /**
       * Format: double
       * @description Distance that is kept, mm.
       */
      kept_mm: number;
      /**
       * Format: double
       * @description Least distance, mm.
       */
      least_mm: number;
      /** @description What was not. */
      not_checked: string[];
      /** @description In words. */
      statement: string;
    };
    /** @description A program that finds the clocking angle. */
    ClockingResult: {
      /** @description Name of the axis that turns. */
      axis: string;
      /** @description Control. */
      control: string;
      /** @description Path below the directory of the run. */
      file: string;
      /**
       * Format: double
       * @description Their mean.
       */
      middle_deg: number;
      /**
       * Format: double
       * @description How far what the text makes of them is off at most.
       */
      off_deg: number;
      /** @description Where it touches both flanks of a workpiece whose clocking angle is right, as the control counts. */
      touches_deg: [number, number];
      /**
       * Format: double
       * @description Errors of the clocking angle, either way, that were tried on the text by the referee's rays.
       */
      tried_deg: number;
    };
    /** @description A multiplier on the motion. */
    ComparedResult: {
      /**
       * Format: double
       * @description Largest of the motion at the flank.
       */
      flank_um: number;
      /** @description How it multiplies. */
      multiplier: string;
      /** @description The same at constant speed; absent without such a stretch. */
      steady?: components["schemas"]["RangeUm"] | null;
      /**
       * Format: double
       * @description Half the range at constant speed, at the flank: what a constant lag is not.
       */
      steady_flank_um?: number | null;
      /** @description Shown position less slide, over the motion. */
      whole: components["schemas"]["RangeUm"];
    };
    /** @description What is left of a condition of dressing over the dressed length of the worm. */
    ConditionResult: {
      /**
       * @description What it names as coefficients of q^k over the width: share of the worm's profile, stretch in per cent, height in um, correction in
       *     degrees or mm.
       */
      at: number[];
      /** @description Flank of the worm that it stands on; null for a height of the head and a correction of one motion for both flanks. */
      flank: components["schemas"]["Flank"] | null;
      /** @description Its kind: "point", "map", "stretch", "head", "phi_S", "gamma", "d" or "v_y". */
      kind: string;
      /**
       * Format: double
       * @description Largest miss without sign.
       */
      largest_miss: number;
      /**
       * Format: double
       * @description Root of the mean square of the misses over the width.
       */
      rms_miss: number;
      /** @description Unit of both: "um", "percent" of the used profile, "deg" or "mm". */
      unit: string;
      /**
       * Format: double
       * @description Its weight; null for one that is met exactly.
       */
      weight: number | null;
    };
    /** @description One flank of all teeth. */
    ControlFlankResult: {
      /**
       * Format: double
       * @description Greatest less least mean: total cumulative pitch deviation.
       */
      cumulative_pitch_um: number;
      /**
       * Format: double
       * @description Largest |simulated + control - target| over all teeth, normal.
       */
      deviation_with_control_um: number;
      /** @description Error of the angle over the stroke. */
      error: components["schemas"]["ErrorTrace"];
      /**
       * Format: double
       * @description Greatest torque.
       */
      greatest_torque_n_m: number;
      /** @description Helix traces of the same teeth. */
      helices: components["schemas"]["Trace"][];
      /**
       * Format: double
       * @description Largest |deviation| by the control alone over all teeth, normal.
       */
      largest_um: number;
      /** @description Mean error of the setpoint and of the workpiece, um at the flank; centring the tooth space removes it there. */
      means_um: [number, number];
      /**
       * Format: double
       * @description Largest difference of closed form and rays in time on a sample of places and teeth.
       */
      model_difference_um: number;
      /** @description Profile traces of some teeth. */
      profiles: components["schemas"]["Trace"][];
      /**
       * Format: double
       * @description Root mean square over all teeth.
       */
      rms_um: number;
      /**
       * Format: uint
       * @description Places of that sample.
       */
      sample: number;
      /**
       * Format: double
       * @description Largest difference of the flanks that a stroke of either sense would leave by itself; absent where one sense grinds.
       */
      senses_apart_um?: number | null;
      /**
       * Format: double
       * @description Largest difference of the means of neighbouring teeth: single pitch deviation.
       */
      single_pitch_um: number;
      /**
       * Format: double
       * @description Largest |simulated + control - target| over the tolerance at its place.
       */
      tolerance_share: number;
      /** @description Mean deviation of each tooth, normal: what a measurement of the pitch sees. */
      tooth_means_um: number[];
      /** @description Deviation on the first tooth, normal, `[profile][helix]` on the grid of the job. */
      topography_um: number[][];
      /**
       * Format: double
       * @description Share of samples with the torque at its limit.
       */
      torque_limited_share: number;
      /** @description Places of the profile traces, at mid face width. */
      trace_w_mm: number[];
      /** @description Places of the helix traces, at the middle of the roll. */
      trace_z_mm: number[];
    };
    /** @description The control and what it costs. */
    ControlResult: {
      /**
       * Format: double
       * @description Flank per torque at the frequency of the threads, um per Nm.
       */
      compliance_at_threads_um_per_n_m: number;
      /**
       * Format: double
       * @description Movement of the flank for one count of the workpiece's encoder.
       */
      encoder_step_um: number;
      /**
       * Format: double
       * @description Speed of the feed z_V2.
       */
      feed_mm_per_min: number;
      /** @description Flanks that are ground. */
      flanks: {
        [key: string]: components["schemas"]["ControlFlankResult"];
      };
      /**
       * Format: double
       * @description What the ratio of the additional rotation is off by, um at the flank per metre of feed.
       */
      ratio_error_um_per_m: number;
      /**
       * Format: double
       * @description Distance of the lines of the feed's scale.
       */
      scale_pitch_um: number;
      /**
       * Format: double
       * @description Movement of the flank for one part of the setpoint, 1/P workpiece pulse.
       */
      setpoint_step_um: number;
      /**
       * Format: double
       * @description That frequency.
       */
      thread_frequency_hz: number;
      /**
       * Format: double
       * @description Speed of the workpiece.
       */
      work_speed_rpm: number;
      /**
       * Format: double
       * @description Speed of the worm.
       */
      worm_speed_rpm: number;
    };
    /** @description A track measured the usual way. */
    ConventionalResult: {
      /** @description Flank. */
      flank: string;
      /**
       * Format: double
       * @description What it would report of an ideal tool: its own error.
       */
      ideal_um: number | null;
      /**
       * Format: double
       * @description What the measurement on contact points found, mean over the teeth.
       */
      measured_um?: number | null;
      /**
       * Format: double
       * @description What it would report of this tool, mean over the teeth.
       */
      reported_um?: number | null;
      /** @description Why it reports nothing: the code of the error. */
      rests_on?: string | null;
      /**
       * Format: double
       * @description Angle on the rounding at which its beam touches the ideal tool.
       */
      touch_deg: number | null;
      /**
       * Format: uint
       * @description Track.
       */
      track: number;
    };
    /** @description A coordinate along a stage. */
    Coordinate: {
      /** @description What it is. */
      label: string;
      /** @description Its unit. */
      unit: string;
    };
    /** @description Face of a corner. */
    CornerFace: "I" | "II" | "datum_face" | "non_datum_face";
    /** @description Profile end of a corner. */
    CornerProfile: "tip" | "root";
    /** @description A setting of a correction. */
    CorrectedSettingResult: {
      /** @description Whether a bound holds it. */
      at_bound: boolean;
      /**
       * Format: double
       * @description Change.
       */
      change: number;
      /**
       * Format: double
       * @description Standard deviation of it; absent where the lines leave it open.
       */
      deviation?: number | null;
      /** @description Whether it is too small to be turned. */
      dropped: boolean;
      /** @description Name with its unit. */
      name: string;
      /**
       * Format: double
       * @description Sum of all corrections.
       */
      total: number;
    };
    /** @description Rotation that is added. */
    CorrectionResult: {
      /** @description The axis that it depends on. */
      axis: string;
      /** @description Least and greatest over the motion, at the flank. */
      flank: components["schemas"]["RangeUm"];
      /**
       * Format: double
       * @description Greatest speed that it adds.
       */
      greatest_speed_deg_per_s: number;
      /**
       * Format: double
       * @description Half a part of a workpiece pulse, to which it is rounded, at the flank.
       */
      rounding_um: number;
      /**
       * Format: double
       * @description By how much the speed of the workpiece jumps at an end of the table, at the greatest speed of the feed.
       */
      speed_jump_deg_per_s: number;
    };
    /** @description Change of the machine's setting. */
    CorrectionResult2: {
      /** @description Settings that ended at their limits. */
      at_limit: string[];
      /**
       * Format: double
       * @description Of d; negative makes |d| of an internal gear larger.
       */
      centre_distance_um: number;
      /**
       * Format: double
       * @description Of gamma.
       */
      crossed_axes_angle_deg: number;
      /** @description Largest deviation before and after. */
      largest_um: [number, number];
      /** @description Root mean square of the profile's deviation before and after. */
      rms_um: [number, number];
      /** @description Settings that it may change. */
      settings: string[];
      /**
       * Format: double
       * @description Of phi_1 against the coupling.
       */
      tool_angle_deg: number;
      /**
       * Format: double
       * @description Of z_V1.
       */
      tool_shift_um: number;
    };
    /** @description A correction and its proof. */
    CorrectionResult3: {
      /** @description Change of the machine's settings from the job to the corrected one. */
      machine: components["schemas"]["MachineChange"];
      /** @description Settings that the lines do not tell apart. */
      not_told_apart?: [string, number][][];
      /** @description What the corrected job leaves, by flank: the measured deviation and what the referee's rays say that the corrected settings change. */
      proof: {
        [key: string]: components["schemas"]["ProofResult2"];
      };
      /** @description Independent unknowns, of how many. */
      rank: number[];
      /**
       * Format: double
       * @description Deviation of the measured lines, root mean square.
       */
      rms_before_um: number;
      /**
       * Format: double
       * @description What the first-order model predicts.
       */
      rms_predicted_um: number;
      /**
       * Format: double
       * @description What these settings cannot remove.
       */
      rms_unremovable_um: number;
      /** @description Settings that are turned; none where the flank itself is corrected, as in milling. */
      settings: components["schemas"]["CorrectedSettingResult"][];
    };
    /** @description Cost of a part. */
    CostResult: {
      /**
       * Format: double
       * @description Changing the worm.
       */
      change: number;
      /**
       * Format: double
       * @description Dresser.
       */
      dresser: number;
      /**
       * Format: double
       * @description Machine with its operator.
       */
      machine: number;
      /**
       * Format: double
       * @description All of it.
       */
      total: number;
      /**
       * Format: double
       * @description Worm.
       */
      worm: number;
    };
    /** @description The coupling of the workpiece to the slide. */
    CouplingResult: {
      /**
       * Format: double
       * @description b, workpiece pulses per reference pulse.
       */
      coefficient: number;
      /**
       * Format: double
       * @description B/2^18/b - 1; absent as `coefficient_word`.
       */
      coefficient_relative_error?: number | null;
      /**
       * Format: uint32
       * @description B = round(b 2^18), the word of a rate multiplier; absent if b is too large for one.
       */
      coefficient_word?: number | null;
      /**
       * Format: double
       * @description Movement of the flank, normal, per error along the feed, s_ax.
       */
      flank_um_per_feed_um: number;
      /**
       * Format: double
       * @description Movement of the flank, normal, per angle of the workpiece, s_rot.
       */
      flank_um_per_rad: number;
      /**
       * Format: double
       * @description Movement of the flank, normal, for one workpiece pulse.
       */
      flank_um_per_workpiece_pulse: number;
      /**
       * Format: double
       * @description Lead, > 0 right-hand; absent for a spur gear.
       */
      lead_mm?: number | null;
      /**
       * Format: double
       * @description What the rounding of the ratio in use costs over the feed, at the flank.
       */
      rotation_error_um_per_m: number;
    };
    /** @description The crowning at one position over the width. */
    CrowningAt: {
      /**
       * Format: double
       * @description Profile crowning that the plan makes there; absent where there is none.
       */
      made_um?: number | null;
      /**
       * Format: double
       * @description Profile crowning that the target wants there.
       */
      wanted_um: number;
      /**
       * Format: double
       * @description Position z of the gear.
       */
      z_mm: number;
    };
    /** @description The points of one set of bodies. */
    CrowningCurve: {
      /** @description What tells the bodies from the others; empty where nothing is compared. */
      bodies: string;
      /** @description Why there are no smaller crownings. */
      least: components["schemas"]["CurveEnd"] | null;
      /** @description Why there are no larger crownings. */
      most: components["schemas"]["CurveEnd"] | null;
      /** @description Points in ascending order of the crowning. */
      points: components["schemas"]["CrowningPoint"][];
      /** @description Why there is no curve at all. */
      refused: components["schemas"]["Refused"] | null;
      /**
       * @description Smallest and largest crowning at which a dresser with the tip land of the job clears the opposite flank; absent without a
       *     tip land, or where the study gives the crownings.
       */
      with_tip_land: components["schemas"]["CurveEnd"][] | null;
    };
    /** @description Dressing for one profile crowning. */
    CrowningPoint: {
      /**
       * Format: double
       * @description Profile crowning on the gear, transverse, positive = convex.
       */
      crowning_um: number;
      /**
       * Format: double
       * @description Correction of the centre distance.
       */
      d_d_mm: number;
      /**
       * Format: double
       * @description Correction of the crossing angle.
       */
      d_gamma_deg: number;
      /**
       * Format: double
       * @description Correction of the worm angle.
       */
      d_phi_S_deg: number;
      /**
       * Format: double
       * @description Correction of the offset.
       */
      d_v_yA_mm: number;
      /**
       * Format: double
       * @description Largest deviation of the dressed profile from the parabola, normal to the flank.
       */
      deviation_um: number;
      /**
       * Format: double
       * @description Direction of the contact line.
       */
      rho_deg: number;
      /**
       * Format: double
       * @description Relative profile stretch.
       */
      stretch: number;
      /**
       * Format: double
       * @description Axial position at which the contact line passes through the middle of the profile at worm z = 0.
       */
      v_zS_mm: number;
    };
    /** @description One end of a curve, where it ends before the study does. */
    CurveEnd: {
      /**
       * Format: double
       * @description The last crowning reached.
       */
      crowning_um: number;
      /** @description What is there: fold, contact lost, out of dresser, limit of an axis, tip land; else the code of an error. */
      reason: string;
    };
    /** @description A cutter. Lengths in mm. */
    CutterResult: {
      /**
       * Format: double
       * @description Height of the edges.
       */
      cutting_length: number;
      /**
       * Format: double
       * @description Diameter at the tip plane, of a barrel the largest.
       */
      diameter: number;
      /**
       * Format: double
       * @description Half angle of a cone.
       */
      half_angle_deg: number;
      /** @description "conical" (end mill, ball, torus, cone) or "barrel". */
      profile: string;
      /**
       * Format: double
       * @description Radius of the corner, of a barrel that of the profile.
       */
      profile_radius: number;
    };
    /** @description Roughing strokes of equal depth and one finishing stroke. */
    CycleResult: {
      /**
       * Format: double
       * @description Cost of a part if the width is used at its best; absent without `technology.cost`.
       */
      cost_per_part?: number | null;
      /**
       * Format: double
       * @description Height of the feed marks of finishing.
       */
      feed_mark_um: number;
      /** @description Feed per revolution of the workpiece of roughing, 0 without, and of finishing. */
      feed_per_revolution_mm: [number, number];
      /**
       * Format: double
       * @description Depth of the finishing stroke.
       */
      finishing_um: number;
      /**
       * Format: double
       * @description Factor on both limits of Q'_w.
       */
      limit_factor: number;
      /**
       * Format: double
       * @description Time of a part.
       */
      part_s: number;
      /**
       * Format: double
       * @description Parts between two dressings if the width is used at its best; absent where the job does not bound the worm's load.
       */
      parts_per_dressing?: number | null;
      /**
       * Format: uint
       * @description Roughing strokes.
       */
      roughing_strokes: number;
      /** @description Largest Q'_w of roughing, 0 without, and of finishing. */
      specific_rate_mm3_per_mm_s: [number, number];
    };
    /** @description Cycles within the limits, for the largest stock on both flanks. */
    CyclesResult: {
      /** @description The fastest with both limits of Q'_w multiplied by a factor. */
      by_load: components["schemas"]["CycleResult"][];
      /** @description The fastest for each number of roughing strokes from 0; absent where none keeps the limits. */
      by_roughing_strokes: (components["schemas"]["CycleResult"] | null)[];
      /** @description The cheapest; absent without `technology.cost`. */
      cheapest?: components["schemas"]["CycleResult"] | null;
      /** @description The fastest. */
      fastest: components["schemas"]["CycleResult"];
      /** @description Whether the limits of the machine's axes are in the times. */
      on_machine: boolean;
      /** @description By the rule of thumb. */
      standard: components["schemas"]["CycleResult"];
      /**
       * Format: double
       * @description The stock that they are made for.
       */
      stock_um: number;
      /** @description Whether the share of dressing is in the times. */
      with_dressing: boolean;
    };
    /** @description A quantity with its name. */
    DerivedQuantity: {
      /** @description Key in JSON, with the unit. */
      key: string;
      /** @description Name. */
      label: string;
      /** @description Unit, empty where there is none. */
      unit: string;
      /** @description Number or word. */
      value: Json;
    };
    /** @description Quantities that belong together. */
    DerivedSection: {
      /** @description Quantities in the order of reading. */
      quantities: components["schemas"]["DerivedQuantity"][];
      /** @description Heading, e.g. `worm`. */
      title: string;
    };
    /**
     * @description The worm that a dresser was made for, of the hand of the worm that it dresses. At least one of the two diameters is needed.
     *     Lengths in mm.
     */
    DesignedFor: {
      /**
       * Format: double
       * @description Normal module; default the one that meshes with the gear. Another one is refused.
       */
      normal_module?: number | null;
      /** @description Normal pressure angle in degrees; default that of the gear. */
      normal_pressure_angle_deg?:
        | number
        | {
            left: number;
            right: number;
          };
      /**
       * Format: double
       * @description Pitch diameter; default tip diameter less 2.5 normal modules.
       */
      pitch_diameter?: number | null;
      /**
       * Format: uint32
       * @description Number of threads.
       */
      threads: number;
      /**
       * Format: double
       * @description Tip diameter; default pitch diameter plus 2.5 normal modules.
       */
      tip_diameter?: number | null;
    };
    /** @description A flank ground with axes that are off; normal, um. */
    DeviatedFlank: {
      /** @description Change of the form against the flank without deviations, `[w][z]` on the grid of the result. */
      change_um: number[][];
      /** @description Characteristics of the flank. */
      characteristics: components["schemas"]["CharacteristicsUm"];
      /**
       * Format: double
       * @description Largest change of the form against the flank without deviations.
       */
      largest_change_um: number;
      /**
       * Format: double
       * @description Largest deviation of the form from the target.
       */
      max_deviation_um: number;
      /**
       * Format: double
       * @description Material left everywhere: what the thickness of the tooth changes by on this flank.
       */
      stock_um: number;
      /**
       * Format: double
       * @description The same over the tolerance at its place; above 1 the target would be missed.
       */
      tolerance_share: number;
    };
    /** @description What the planned settings leave with the axes of `[deviations]` off, by the referee. */
    DeviatedResult: {
      /** @description Flanks that are ground. */
      flanks: {
        [key: string]: components["schemas"]["DeviatedFlank"];
      };
    };
    /** @description The deviations of one set of bodies. */
    DeviationCurve: {
      /** @description The axes that deviate, and all at once. */
      axes: components["schemas"]["AxisInfluence"][];
      /** @description What tells the bodies from the others; empty where nothing is compared. */
      bodies: string;
      /** @description Distribution of the draws. */
      distribution: string;
      /** @description Quantiles in ascending order. */
      quantiles: components["schemas"]["DeviationQuantile"][];
      /** @description Why there is no curve. */
      refused: components["schemas"]["Refused"] | null;
      /**
       * Format: uint
       * @description Number of draws.
       */
      samples: number;
      /**
       * Format: uint64
       * @description Their seed.
       */
      seed: number;
      /** @description Lengths of roll on the worm. */
      w_mm: number[];
    };
    /** @description Quantiles of random deviations at one level. */
    DeviationQuantile: {
      /**
       * Format: double
       * @description Height of the mean parabola over its chord.
       */
      crowning_um: number;
      /**
       * Format: double
       * @description Largest absolute change over the profile.
       */
      largest_um: number;
      /**
       * Format: double
       * @description Share of the draws that lie below.
       */
      level: number;
      /**
       * Format: double
       * @description Slope over the profile, end minus start.
       */
      slope_um: number;
    };
    /** @description A difference of two flanks about its mean. */
    DifferenceResult: {
      /**
       * Format: double
       * @description C_alpha.
       */
      Ca_um: number;
      /**
       * Format: double
       * @description C_beta.
       */
      Cb_um: number;
      /**
       * Format: double
       * @description S.
       */
      S_um: number;
      /**
       * Format: double
       * @description f_Ha, f_Hb (of material), C_alpha, C_beta, S of the areal fit of second degree.
       */
      fHa_um: number;
      /**
       * Format: double
       * @description f_Hb.
       */
      fHb_material_um: number;
      /**
       * Format: double
       * @description Largest.
       */
      largest_um: number;
      /**
       * Format: double
       * @description Largest minus smallest.
       */
      range_um: number;
      /**
       * Format: double
       * @description Root mean square.
       */
      rms_um: number;
      /**
       * Format: double
       * @description Share of the points within the tolerance.
       */
      within_tolerance: number;
    };
    /** @description Distances of neighbours, mm; a mean is that of one line. */
    DistancesResult: {
      /**
       * Format: double
       * @description Greatest mean of a line.
       */
      max_mean_mm: number;
      /**
       * Format: double
       * @description Greatest distance.
       */
      max_mm: number;
      /**
       * Format: double
       * @description Least mean of a line.
       */
      min_mean_mm: number;
      /**
       * Format: double
       * @description Least distance.
       */
      min_mm: number;
    };
    /** @description Tooth thickness and class of the drawing. */
    DrawingResult: {
      /** @description Normal tooth thickness on the pitch cylinder; absent of a conical gear. */
      normal_tooth_thickness?: components["schemas"]["ThicknessResult"] | null;
      /** @description Size over (internal: between) balls; absent where no ball touches. */
      over_balls?: components["schemas"]["ThicknessResult"] | null;
      /** @description Size over (internal: between) rolls; absent without `gear.measured_over.roll_diameter`. */
      over_rolls?: components["schemas"]["ThicknessResult"] | null;
      /** @description Span; absent where the gear has none. */
      span?: components["schemas"]["ThicknessResult"] | null;
      /** @description Tolerances of ISO 1328-1:2013, rounded as the standard states them; absent without `gear.tolerance_class`. */
      tolerances?: components["schemas"]["ToleranceResult"] | null;
    };
    /** @description A value that drawings state, transverse; > 0 material removed. */
    DrawnValue: {
      /**
       * Format: double
       * @description Amount in the drawing, over the whole evaluated length; absent where it names none.
       */
      drawn_um?: number | null;
      /**
       * Format: double
       * @description The simulated flank.
       */
      made_um: number;
      /** @description Symbol of ISO 21771: `C_alpha`, `C_Halpha`, `C_alpha_a` (tip), `C_alpha_f` (root), `C_beta`, `C_Hbeta`, `C_beta_I`, `C_beta_II`. */
      symbol: string;
      /**
       * Format: double
       * @description The target, evaluated as the flank is.
       */
      target_um: number;
    };
    /** @description A disc dresser that is there. Lengths in mm. */
    DresserEntry: {
      /** @description The worm for which it was made. */
      designed_for: components["schemas"]["DesignedFor"];
      /** @description Diameters between which its flanks are profiled; default up to the tip, as far down as needed. */
      flank_diameters?: components["schemas"]["FlankDiameters"] | null;
      /** @description What the shop calls it; each name once. */
      name: string;
      /**
       * Format: double
       * @description Pitch diameter; with it the dressing centre distance is the sum of the pitch radii, without it the disc tip touches the
       *     worm root.
       */
      pitch_diameter?: number | null;
      /**
       * @description Profile crowning in um that it makes on the gear from form to tip diameter with the worm it was made for; transverse,
       *     positive = convex.
       * @default 0
       */
      profile_crowning_um:
        | number
        | {
            left: number;
            right: number;
          };
      /**
       * Format: double
       * @description Tip diameter.
       */
      tip_diameter: number;
      /**
       * Format: double
       * @description Width of the cylindrical land at the tip.
       */
      tip_land?: number | null;
    };
    /** @description How the worm is dressed. */
    DressingFiguresResult: {
      /**
       * Format: double
       * @description Length of the contact along the thread.
       */
      contact_length_mm: number;
      /**
       * Format: double
       * @description Taken from the flank by the last stroke, normal.
       */
      depth_um: number;
      /**
       * Format: double
       * @description Dresser.
       */
      dresser_speed_rpm: number;
      /**
       * Format: uint
       * @description 1 or 2.
       */
      flanks_at_a_time: number;
      /**
       * Format: double
       * @description Contact length over the way of the thread per revolution of the dresser.
       */
      overlap: number;
      /**
       * Format: double
       * @description Parts that a dresser lasts; absent without `technology.cost` or without a limit of V'_w.
       */
      parts_per_dresser?: number | null;
      /**
       * Format: double
       * @description Peripheral speed of the dresser over that of the worm, above 0 where both run the same way at the contact.
       */
      speed_ratio: number;
      /**
       * Format: uint
       * @description Strokes of a flank.
       */
      strokes: number;
      /**
       * Format: double
       * @description Way of the thread past the dresser per revolution of the dresser.
       */
      thread_per_dresser_revolution_mm: number;
      /**
       * Format: double
       * @description Way of the dresser along the worm's axis per revolution of the worm.
       */
      traverse_per_worm_revolution_mm: number;
      /**
       * Format: double
       * @description Worm.
       */
      worm_speed_rpm: number;
    };
    /** @description Corrections of dressing against the nominal kinematics. */
    DressingOfLife: {
      /**
       * Format: double
       * @description Centre distance.
       */
      d_d_mm: number;
      /**
       * Format: double
       * @description Crossing angle.
       */
      d_gamma_deg: number;
      /**
       * Format: double
       * @description Worm angle.
       */
      d_phi_S_deg: number;
      /**
       * Format: double
       * @description Offset.
       */
      d_v_yA_mm: number;
    };
    /** @description What a study found: the document of `explore.json`. */
    DressingStudyOutcome: {
      /** @description Flank of the worm. */
      flank: string;
      /** @description Name of the job. */
      job: string;
      /** @description What runs along the abscissa. */
      over: string;
      /** @description Process. */
      process: string;
      /** @description Version of flankwright. */
      version: string;
    } & (
      | {
          crowning: components["schemas"]["CrowningCurve"][];
        }
      | {
          profile: components["schemas"]["ProfileCurve"][];
        }
      | {
          worms: components["schemas"]["WormCurve"][];
        }
      | {
          strokes: components["schemas"]["StrokeCurve"][];
        }
      | {
          deviations: components["schemas"]["DeviationCurve"][];
        }
    );
    /** @description A change of one entry. */
    Edit: {
      /** @description Keys, and places in lists from 0; at most 64. */
      path: components["schemas"]["Step"][];
      /** @description The new value, at most 256 KiB; null takes the entry out. */
      value: Json;
    };
    /** @description The changed text. */
    EditAnswer: {
      /** @description The text, with the comments and the order that it had. */
      text: string;
      /** @description The job as JSON. */
      tree: Table;
    };
    /** @description Changes of a text. */
    EditRequest: {
      /** @description Changes, one after the other; at most 256. */
      edits: components["schemas"]["Edit"][];
      /** @description The text of a job. */
      text: string;
    };
    /** @description What the encoder of the workpiece leaves on the teeth. */
    EncoderResult: {
      /**
       * Format: double
       * @description Greatest difference of any two: cumulative pitch deviation.
       */
      cumulative_pitch_um: number;
      /**
       * Format: double
       * @description Greatest error either way.
       */
      greatest_um: number;
      /**
       * Format: double
       * @description Greatest difference of neighbours: single pitch deviation.
       */
      single_pitch_um: number;
      /** @description Least and greatest error of a tooth space, normal to the flank. */
      teeth: components["schemas"]["RangeUm"];
    };
    /** @description How the workpiece came into the gap. */
    EngagementResult: {
      /**
       * Format: double
       * @description How much of half its range it used; from 100 % on its way is not known.
       */
      counter_used_percent: number;
      /**
       * Format: uint64
       * @description How often that counter wrapped.
       */
      counter_wraps: number;
      /**
       * Format: int64
       * @description Greatest way of the counter of the worm in a cycle.
       */
      counts_a_cycle: number;
      /**
       * Format: double
       * @description Time until it is in phase.
       */
      coupled_after_s: number;
      /**
       * Format: double
       * @description Greatest acceleration of it.
       */
      greatest_acceleration_deg_per_s2: number;
      /**
       * Format: double
       * @description Greatest speed of the workpiece.
       */
      greatest_speed_deg_per_s: number;
      /**
       * Format: double
       * @description Speed of the worm up to which it is known.
       */
      greatest_worm_speed_rpm: number;
      /** @description Workpiece less gap while coupled, at the flank: counts of the worm. */
      miss: components["schemas"]["RangeUm"];
      /**
       * Format: double
       * @description Move into the gap.
       */
      phase_move_deg: number;
      /**
       * Format: double
       * @description Time until it runs along.
       */
      ramp_s: number;
      /**
       * Format: double
       * @description Way that it went meanwhile.
       */
      ramp_way_deg: number;
    };
    /** @description Engagement of the cutter that clears a space, as its layers and passes lie. */
    EngagementResult2: {
      /**
       * Format: double
       * @description Arc of the circumference that is engaged with that width.
       */
      arc_deg: number;
      /**
       * Format: double
       * @description Greatest thickness of their chips; absent where the job does not tell the number of edges.
       */
      chip_thickness_mm?: number | null;
      /**
       * Format: double
       * @description Greatest depth of a layer.
       */
      depth_mm: number;
      /**
       * Format: uint
       * @description Passes that cut with the whole diameter somewhere.
       */
      full_width_passes: number;
      /**
       * Format: double
       * @description Material removed with the whole diameter.
       */
      full_width_removal_cm3_per_min: number;
      /**
       * Format: uint
       * @description Layers.
       */
      layers: number;
      /**
       * Format: double
       * @description Material removed with that width.
       */
      removal_cm3_per_min: number;
      /**
       * Format: double
       * @description Greatest width of the others, from the pass before.
       */
      width_mm: number;
    };
    /** @description A number of the worm with which one diagonal ratio serves the directed parts of both flanks. */
    EqualRatioOffer: {
      /**
       * Format: double
       * @description The common diagonal ratio.
       */
      diagonal_ratio: number;
      /** @description Keys of the job with the values that give this worm. */
      keys: [string, number][];
      /** @description What is changed: `cone_angle`, `profile_angle` (left flank) or `crossing_angle`. */
      lever: string;
      /**
       * Format: double
       * @description Its value, degrees.
       */
      value_deg: number;
    };
    /** @description The angle's error over the stroke as it would stand on the flank, in stretches of time. */
    ErrorTrace: {
      /** @description Least and greatest error of the workpiece within it, um at the flank. */
      actual_um: number[][];
      /** @description z_V2 in the middle of each stretch, mm. */
      feed_mm: number[];
      /** @description Least and greatest setpoint error within it, um at the flank. */
      setpoint_um: number[][];
    };
    /** @description An example in the list. */
    ExampleSummary: {
      /** @description What it shows. */
      description?: string | null;
      /** @description By which it is asked for, e.g. `milling/blisk-blade`. */
      id: string;
      /** @description Name of the job. */
      name: string;
      /** @description Its process. */
      process: string;
    };
    /** @description One combination. Figures are absent where it could not be evaluated. */
    ExploreCandidate: {
      /** @description Whether the rule of planning allows it. */
      allowed: boolean;
      /**
       * Format: double
       * @description Crossed-axes angle of worm and gear; absent where the job's worm is impossible.
       */
      crossed_axes_angle_deg: number | null;
      /**
       * Format: double
       * @description |K_left - K_right| of the ratios that directed parts of the target ask for; absent unless both flanks ask.
       */
      demanded_ratio_difference: number | null;
      /**
       * Format: double
       * @description Diagonal ratio; absent where the rule of the job found none.
       */
      diagonal_ratio: number | null;
      /** @description Figures per flank that is ground. */
      flanks: {
        [key: string]: components["schemas"]["FlankFigures"];
      };
      /**
       * Format: double
       * @description Least det J / det J_0.
       */
      least_determinant_ratio: number | null;
      /** @description Place of the profile crowning. */
      profile_crowning_by: string | null;
      /**
       * Format: uint
       * @description Place in the ranking, from 1.
       */
      rank: number;
      /** @description Why it is not allowed, if so. */
      refused: components["schemas"]["Refused"] | null;
      /**
       * Format: double
       * @description Largest residual of all flanks.
       */
      residual_um: number | null;
      /**
       * Format: double
       * @description Largest share of an axis limit.
       */
      score: number | null;
      /** @description Whether residual and parts outside the class are within the tolerance. */
      within_tolerance: boolean;
      /**
       * Format: double
       * @description Cone angle of the worm.
       */
      worm_cone_angle_deg: number;
      /**
       * Format: double
       * @description Length of the worm that is used.
       */
      worm_occupation_mm: number | null;
      /**
       * Format: double
       * @description Pitch diameter of the worm.
       */
      worm_pitch_diameter_mm: number | null;
    };
    /** @description What a study found: the document of `explore.json`. */
    ExploreOutcome: {
      /**
       * Format: uint
       * @description Number of candidates that are allowed.
       */
      allowed: number;
      /** @description All combinations, the best first. */
      candidates: components["schemas"]["ExploreCandidate"][];
      /** @description Name of the job. */
      job: string;
      /** @description Worms with which one ratio serves both flanks; empty where nothing asks for one. */
      levers: components["schemas"]["EqualRatioOffer"][];
      /** @description Process. */
      process: string;
      /** @description How the candidates are ranked. */
      ranking: string;
      /**
       * Format: double
       * @description Tolerance of the job, the tightest of its map.
       */
      tolerance_um: number;
      /** @description What varies: `worm_cone_angle_deg`, `crossed_axes_angle_deg`, `diagonal_ratio`. */
      varied: string[];
      /** @description Version of flankwright. */
      version: string;
    };
    /** @description Set-ups side by side. */
    ExploreResult: {
      /**
       * Format: double
       * @description Acceleration of the feed.
       */
      acceleration_mm_per_s2: number;
      /** @description The cheapest that is accurate enough, simulated; absent if there is none. */
      best?: components["schemas"]["BestSetUpResult"] | null;
      /**
       * Format: uint
       * @description Set-ups that are accurate enough.
       */
      feasible: number;
      /** @description Rule of the ranking, in words. */
      ranking: string;
      /** @description All, ranked. */
      set_ups: components["schemas"]["SetUpResult"][];
      /**
       * Format: double
       * @description Speed of the feed.
       */
      speed_mm_per_min: number;
      /**
       * Format: double
       * @description Error that is wanted at most.
       */
      wanted_um: number;
    };
    /** @description What a combination makes of one flank. */
    ExploredFlank: {
      /**
       * Format: double
       * @description Least determinant ratio: 1 unmodified, 0 where the envelope folds.
       */
      least_determinant_ratio: number;
      /**
       * Format: double
       * @description Largest |target - planned| on the grid of the result, normal.
       */
      max_deviation_um: number;
      /**
       * Format: double
       * @description Largest modification of the worm where it touches the gear, normal.
       */
      worm_modification_um: number;
    };
    /** @description Why a request has no result. */
    Failure: {
      /** @description What was found, never empty. */
      errors: components["schemas"]["Finding"][];
      /**
       * Format: int32
       * @description The exit status that the command would have: 1 a fault of the program, 2 bad input, 4 these bodies cannot make the target.
       */
      exit: number;
      /** @description Further findings that were not kept. */
      omitted: number;
    };
    /** @description The fillet beside one flank. */
    FilletResult: {
      /**
       * Format: double
       * @description Largest diameter at which it begins: the root form diameter that is ground.
       */
      form_diameter_mm: number;
      /**
       * Format: double
       * @description Least radius of curvature in the transverse section.
       */
      least_radius_mm: number;
      /**
       * Format: double
       * @description Largest |length| of the referee's rays on it: what planning and simulation differ by.
       */
      model_difference_um: number;
      /** @description Sections from the flank to the root: z, then x and y with the tooth space on +y. */
      sections: components["schemas"]["FilletSection"][];
    };
    /** @description One transverse section. */
    FilletSection: {
      /** @description Points. */
      points_mm: [number, number][];
      /**
       * Format: double
       * @description Axial position.
       */
      z_mm: number;
    };
    /** @description One finding. */
    Finding: {
      /** @description What would be allowed. */
      allowed?: string | null;
      /** @description Stable code, e.g. `unknown-key`. */
      code: string;
      /** @description Column in characters, from 1. */
      column?: number | null;
      /** @description Where it ends. */
      end?: number | null;
      /** @description Path of the key, e.g. `target.modifications[1].amount_um`. */
      field?: string | null;
      /** @description The file, where it is not the job itself. */
      file?: string | null;
      /** @description Line, from 1. */
      line?: number | null;
      /** @description The cause in one sentence. */
      message: string;
      /** @description Where it begins in the text of the job, in units of UTF-16. */
      start?: number | null;
      /** @description The value as given. */
      value?: string | null;
      /** @description What to do about it. */
      way_out?: string | null;
    };
    /** @description Flank of a tooth space, seen from +z towards -z. The left flank lies at x > 0 for z = 0. */
    Flank: "left" | "right";
    /** @description The flanks to which a modification applies. */
    FlankChoice: "left" | "right" | "both";
    /** @description From where to where a dresser has a profile. Lengths in mm. */
    FlankDiameters: {
      /**
       * Format: double
       * @description Smallest diameter.
       */
      from: number;
      /**
       * Format: double
       * @description Largest diameter.
       */
      to: number;
    };
    /** @description What the ideal tool misses on one flank, normal to the flank. */
    FlankFigures: {
      /**
       * Format: double
       * @description Largest |target - ground| on the planning grid.
       */
      max_residual_um: number;
      /**
       * Format: double
       * @description Largest part of the target that is best-fitted only.
       */
      outside_class_um: number;
      /**
       * Format: double
       * @description Its root mean square.
       */
      rms_residual_um: number;
    };
    /** @description One flank as proven. */
    FlankProof: {
      /**
       * Format: double
       * @description Largest difference from the flank of the run's own motions.
       */
      difference_um: number;
      /**
       * Format: double
       * @description Largest deviation from the target.
       */
      max_deviation_um: number;
    };
    /** @description Q'_w on one flank. */
    FlankRateResult: {
      /** @description Diameters of the places along the profile, rising. */
      diameter_mm: number[];
      /** @description Q'_w: for each diameter its values over the feed. */
      specific_rate_mm3_per_mm_s: number[][];
    };
    /** @description One flank under a stroke: the largest over the profile. */
    FlankRemovalResult: {
      /**
       * Format: double
       * @description Equivalent chip thickness.
       */
      chip_thickness_um: number;
      /**
       * Format: double
       * @description Area of the contact.
       */
      contact_area_mm2: number;
      /**
       * Format: double
       * @description Length of the contact on the tooth.
       */
      contact_length_mm: number;
      /**
       * Format: double
       * @description Largest depth of cut, normal.
       */
      depth_um: number;
      /**
       * Format: double
       * @description What one thread takes in one passage.
       */
      passage_um: number;
      /**
       * Format: double
       * @description Q'_w.
       */
      specific_rate_mm3_per_mm_s: number;
    };
    /** @description Amplitude of the flank per amplitude of a torque, linear. */
    FlankResponseResult: {
      /**
       * Format: double
       * @description Frequency of the torque.
       */
      frequency_hz: number;
      /**
       * Format: double
       * @description Flank, normal, per torque.
       */
      um_per_n_m: number;
    };
    /** @description One flank. */
    FlankResult: {
      /**
       * Format: double
       * @description Height of the true feed marks over the envelope (sample of rays); absent without a feed per revolution.
       */
      feed_mark_um?: number | null;
      /**
       * Format: double
       * @description Least det J / det J_0.
       */
      least_determinant_ratio: number;
      /** @description How the worm flank is written line by line; absent for every other tool. */
      line_dressing?: components["schemas"]["LineDressingResult"] | null;
      /**
       * Format: double
       * @description Largest |simulated - target|.
       */
      max_deviation_um: number;
      /**
       * Format: double
       * @description Largest |planned - simulated|.
       */
      model_difference_um: number;
      /**
       * Format: double
       * @description Largest part of the target outside the producible class, normal.
       */
      outside_class_um: number;
      /**
       * Format: double
       * @description Largest |planned - target| inside the cells of the grid, where reliefs or waves stand on the tool's lines.
       */
      planned_between_um?: number | null;
      /** @description Exact contact with the worm as dressed, normal. */
      planned_um: number[][];
      /**
       * Format: double
       * @description Bound of the referee's own error.
       */
      referee_error_um: number;
      /**
       * Format: double
       * @description Root mean square of simulated - target.
       */
      rms_deviation_um: number;
      /** @description Characteristics of the simulated flank. */
      simulated_characteristics: components["schemas"]["CharacteristicsUm"];
      /** @description What the referee's rays left, normal. */
      simulated_um: number[][];
      /** @description Characteristics of the target. */
      target_characteristics: components["schemas"]["CharacteristicsUm"];
      /** @description Target, normal, `[profile][helix]`. */
      target_um: number[][];
      /**
       * Format: double
       * @description Largest |simulated - target| over the tolerance at its place; plus what the lines of a disc in point contact leave of the
       *     worm, over the tightest tolerance. The target is met up to 1.
       */
      tolerance_share: number;
      /** @description Traces where the drawing has them, evaluated as those of a measured gear; absent for tangential dressing. */
      traces?: components["schemas"]["TraceResult"][];
      /** @description Lengths of roll of the grid. */
      w_mm: number[];
      /** @description Axial positions of the grid. */
      z_mm: number[];
    };
    /** @description One flank. Arrays over rays are row-major [height][length]. */
    FlankResult2: {
      /** @description Distances between rows, along columns. */
      along_columns: components["schemas"]["DistancesResult"];
      /** @description Distances between columns, along rows. */
      along_rows: components["schemas"]["DistancesResult"];
      /**
       * Format: uint
       * @description How many of them because a cutter digs in deeper than the ray begins.
       */
      gouged: number;
      /** @description Height parameters of the rays, root to tip. */
      height: number[];
      /** @description Unit of the height parameter: "mm" (length of roll), "rad" (roll angle), "1" (fraction). */
      height_unit: string;
      /** @description Lead parameters between which the flank lies, without overrun. */
      lead_range: [number, number];
      /** @description Length parameters of the rays. */
      length: number[];
      /** @description Unit of the length parameter: "mm" (axial position, distance from the apex) or "1". */
      length_unit: string;
      /**
       * Format: double
       * @description Largest absolute deviation of the rays.
       */
      max_deviation_um: number;
      /**
       * Format: double
       * @description Largest difference of prediction and rays.
       */
      model_difference_um: number;
      /** @description The rotary motion beside that of other systems, where the job wants it. */
      orientation?: components["schemas"]["OrientationResult"] | null;
      /** @description What the other half of a double-helical gear keeps the cutter from; absent where there is nothing. */
      out_of_reach?: components["schemas"]["OutOfReachResult"] | null;
      /**
       * Format: uint
       * @description Columns of the path before the flank begins (and after it ends).
       */
      overrun_columns: number;
      /** @description Prediction for the deviation: scallop and straight blocks; null where no row lies beside. */
      planned_um: (number | null)[];
      /**
       * Format: double
       * @description Bound of the rays' own error.
       */
      referee_error_um: number;
      /**
       * Format: double
       * @description Root mean square of them.
       */
      rms_deviation_um: number;
      /** @description The root below the flank, at its middle column. */
      root?: components["schemas"]["RootResult"] | null;
      /** @description Rows, root to tip. */
      rows: components["schemas"]["RowResult"][];
      /** @description Deviation that the referee's rays found, > 0 stock; null where no cutter comes by or the flank is out of reach. */
      simulated_um: (number | null)[];
      /** @description Lowest and highest deviation of the rays. */
      stock_um: [number, number];
      /** @description Rays that no cutter meets, by reason. */
      unmilled: {
        [key: string]: number;
      };
      /** @description Wear along the edge; absent for cutters whose contact is not chosen. */
      wear?: components["schemas"]["WearResult"] | null;
    };
    /** @description Dressing of one worm flank: corrections DK(v) as Chebyshev series of the worm position v_zS, and the dresser's profile. */
    FlankSettings: {
      /**
       * @description Chebyshev coefficients of d_d, mm.
       * @default []
       */
      d_d_mm: number[];
      /**
       * @description Chebyshev coefficients of d_gamma, deg.
       * @default []
       */
      d_gamma_deg: number[];
      /**
       * @description Chebyshev coefficients of d_phi_S, deg.
       * @default []
       */
      d_phi_S_deg: number[];
      /**
       * @description Chebyshev coefficients of d_v_yA, mm.
       * @default []
       */
      d_v_yA_mm: number[];
      /** @description A further part of that profile over the length of roll w, um and um/mm^k: what a best fit found. */
      profile_pieces?: components["schemas"]["Pieces"] | null;
      /**
       * @description Profile that the dresser leaves on the gear: coefficients of (w - w_m)^k, um/mm^k, transverse, > 0 material left.
       * @default []
       */
      profile_um: number[];
      /**
       * @description Reliefs and other profile forms that the dresser carries beside it: modifications of the profile, as in the target.
       * @default []
       */
      reliefs: components["schemas"]["ModificationSpec"][];
      /**
       * Format: double
       * @description First worm position v_zS of the series, mm.
       */
      v_from_mm: number;
      /**
       * Format: double
       * @description Last worm position v_zS of the series, mm.
       */
      v_to_mm: number;
    };
    /** @description Wear of a flank over the workpieces. */
    FlankTrendResult: {
      /**
       * Format: double
       * @description Workpieces at which the limit of wear is reached.
       */
      limit_at_parts?: number | null;
      /** @description Between these with a probability of 95 %; the upper end is absent where the rate may be 0. */
      limit_interval?: (number | null)[] | null;
      /** @description Why there is no forecast. */
      no_forecast?: string | null;
      /**
       * Format: double
       * @description Its standard deviation.
       */
      rate_sigma_um_per_1000?: number | null;
      /**
       * Format: double
       * @description Wear per thousand workpieces; absent with measurements at one count only.
       */
      rate_um_per_1000?: number | null;
      /**
       * Format: double
       * @description Workpieces that are left; negative beyond the limit.
       */
      remaining_parts?: number | null;
      /**
       * Format: double
       * @description Wear now: what is missing on the deepest track in the mean.
       */
      wear_um: number;
    };
    /** @description Values of the variables of a flank. */
    FlankValues: {
      /**
       * Format: double
       * @description Ratio of the tool shift to the feed; default `grinding.shift_ratio`.
       */
      kap?: number | null;
      /** @description Splines beside the powers. */
      splines?: components["schemas"]["SplineValues"][];
      /**
       * @description Coefficients by the names of their variables, mm; of `gA` rad. `FT0` is the whole shift in the middle of the feed;
       *     default `grinding.shift_offset`.
       */
      values?: {
        [key: string]: number;
      };
    };
    /** @description All bodies at one place of a stage. */
    Frame: {
      /**
       * Format: double
       * @description Where on the coordinate of the stage.
       */
      at: number;
      /** @description Where tool and workpiece touch in this moment, in coordinates of the scene, mm: points in their order if they touch along a line. */
      contact: [number, number, number][];
      /**
       * @description Coordinates of a body into those of the scene, by its id: rotation row by row, then translation in mm. Bodies without an entry
       *     stand still, their coordinates being those of the scene.
       */
      poses: {
        [key: string]: number[];
      };
      /** @description Lines on the workpiece that this place of the stage finishes, in coordinates of the scene, mm. */
      trace?: [number, number, number][][];
    };
    /** @description The document of `explore.json` of such a study. */
    FreeOutcome: {
      /** @description What is free: `pitch-diameter` (mm), `pressure-angle` (degrees) or `threads`. */
      free: string;
      /** @description Name of the job. */
      job: string;
      /** @description Limits. */
      limits: components["schemas"]["CatalogueLimits"];
      /** @description All pairs; those with a working range first, by the least share of a limit. */
      pairs: components["schemas"]["FreePair"][];
      /** @description Process. */
      process: string;
      /** @description Values from, to. */
      range: [number, number];
      /**
       * Format: double
       * @description Tolerance of the job, normal.
       */
      tolerance_um: number;
      /** @description Version of flankwright. */
      version: string;
      /** @description Profile crowning that the target asks for, per flank, transverse. */
      wanted_profile_crowning_um: {
        [key: string]: number;
      };
    };
    /** @description A worm with its free quantity under a dresser. */
    FreePair: {
      /** @description Name of the dresser. */
      dresser: string;
      /** @description Values looked at, ascending. */
      points: components["schemas"]["FreePoint"][];
      /** @description Where the target is made. */
      ranges: components["schemas"]["FreeRange"][];
      /** @description Why nothing could be looked at, if so. */
      refused: components["schemas"]["Refused"] | null;
      /** @description Name of the worm of which all else is taken. */
      worm: string;
    };
    /** @description One value of the free quantity. */
    FreePoint: {
      /** @description Figures per flank that is ground. */
      flanks: {
        [key: string]: components["schemas"]["PairFlank"];
      };
      /**
       * Format: double
       * @description max |DK_j/limit_j|.
       */
      largest_share_of_limit: number | null;
      /** @description Why the target is not made there, if so. */
      refused: components["schemas"]["Refused"] | null;
      /**
       * Format: double
       * @description mm, degrees or number.
       */
      value: number;
    };
    /** @description Values that make the target. */
    FreeRange: {
      /** @description The one of the least share of a limit. */
      best: components["schemas"]["FreePoint"];
      /**
       * Format: double
       * @description First value.
       */
      from: number;
      /**
       * Format: double
       * @description Last value.
       */
      to: number;
    };
    /** @description The whole document. */
    GearInspectionResult: {
      /**
       * Format: double
       * @description F_r from the pitches.
       */
      Fr_um?: number | null;
      /**
       * Format: double
       * @description R_s.
       */
      Rs_um?: number | null;
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description Features of each flank as a surface, where its lines cross; against a job the rounds have them. */
      areal?: {
        [key: string]: components["schemas"]["ArealResult"];
      };
      /**
       * Format: int32
       * @description The class of the part; absent where a value is worse than class 11, or nothing was judged.
       */
      class: number | null;
      /** @description Whether something that would count for the class could not be evaluated. */
      class_is_partial: boolean;
      /** @description Classes of ISO 1328-1:2013 that the values reach. */
      classes: components["schemas"]["ClassResult"][];
      /** @description e and its direction. */
      eccentricity?: [number, number];
      /** @description Files that were read. */
      files: string[];
      /** @description Number of the part, its drawing, date and machine, as far as the files tell. */
      head: {
        [key: string]: string;
      };
      /** @description Name of the part, or of its file. */
      job: string;
      /** @description Lines that were not understood, by file. */
      not_understood: components["schemas"]["LinesResult"][];
      /** @description Pitches by flank. */
      pitch: {
        [key: string]: components["schemas"]["PitchInspectionResult"];
      };
      /** @description F_p without the eccentricity, left and right. */
      pitch_without_eccentricity_um?: [number, number];
      /** @description Those of them that have a counterpart here, beside what was evaluated here. */
      printed: components["schemas"]["PrintedResult"][];
      /**
       * Format: double
       * @description Largest difference of the two; 0 without printed values.
       */
      printed_difference_um: number;
      /**
       * Format: uint
       * @description How many values the measuring machine printed.
       */
      printed_values: number;
      /** @description Process. */
      process: string;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description Rounds against a job: comparison, tests, correction, proof. */
      rounds?: components["schemas"]["RoundResult"][];
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description Section in which the file counts deviations. */
      section: string;
      /** @description What the user stated about the measurement because the file does not tell it. */
      stated?: string[];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Mean and range over the teeth: characteristic, flank, line. */
      summary: components["schemas"]["SummaryResult"][];
      /** @description Profile shift by span and balls. */
      thickness: components["schemas"]["ThicknessResult2"];
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: int32
       * @description The class of ISO 1328-1:2013 that was asked for.
       */
      tolerance_class?: number | null;
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um?: number | null;
      /** @description Traces. */
      traces: components["schemas"]["TraceInspectionResult"][];
      /** @description Twist of tooth flanks that have two profiles or two helix traces. */
      twist?: components["schemas"]["TwistResult"][];
      /** @description Version of flankwright. */
      version: string;
      /** @description Doubts of reading and evaluation. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description The ground root in `result.json`. */
    GearRootResult: {
      /** @description Each flank that is ground. */
      flanks: components["schemas"]["Sides3"];
      /** @description Smallest and largest root diameter over the evaluated face. */
      root_diameter_mm: [number, number];
      /** @description Smallest and largest tip diameter of the worm over the length used. */
      worm_tip_diameter_mm: [number, number];
    };
    /** @description The whole document. */
    GearboxResult: {
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description Pulse position less slide; absent for a train of pulses. */
      along_feed?: components["schemas"]["AlongFeedResult"] | null;
      /** @description Additional rotation less that of the lead; absent for a train of pulses. */
      angle?: components["schemas"]["AngleResult"] | null;
      /** @description Error budget at the greatest speed of the motion; absent for a train of pulses. */
      budget?: components["schemas"]["BudgetResult"] | null;
      /** @description The interpolator and older multipliers on the same motion; empty without `[compare]`. */
      compare?: components["schemas"]["ComparedResult"][];
      /** @description Rotation that is added, in the order of the job. */
      corrections?: components["schemas"]["CorrectionResult"][];
      /** @description What the lead asks for and what the coupling makes of it. */
      coupling: components["schemas"]["CouplingResult"];
      /** @description How the workpiece comes into the gap; absent without `[engagement]`. */
      engagement?: components["schemas"]["EngagementResult"] | null;
      /** @description What is measured wrongly; absent without `[errors]`. */
      errors?: components["schemas"]["MeasuringResult"] | null;
      /** @description Set-ups to choose from; absent without `[explore]`. */
      explore?: components["schemas"]["ExploreResult"] | null;
      /** @description Name of the job. */
      job: string;
      /** @description Process. */
      process: string;
      /** @description Counters. */
      pulses: components["schemas"]["PulseFigures"];
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description The servo; absent without `[servo]`. */
      servo?: components["schemas"]["ServoResult"] | null;
      /** @description Settings, as given or by default. */
      settings: components["schemas"]["GearboxSettingsResult"];
      /** @description Whole pulses and voltage; absent without `[split]`. */
      split?: components["schemas"]["SplitResult"] | null;
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Tolerance of the job; absent where it gives none.
       */
      tolerance_um?: number | null;
      /** @description Version of flankwright. */
      version: string;
      /** @description Warnings, alarms of the interpolator among them. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description Settings of the interpolator and of what follows it. */
    GearboxSettingsResult: {
      /**
       * Format: double
       * @description Clock.
       */
      clock_hz: number;
      /**
       * Format: uint32
       * @description Content at which the period counter stops.
       */
      counter_limit: number;
      /**
       * Format: double
       * @description The same as a time.
       */
      duration_s: number;
      /**
       * Format: double
       * @description Speed from which on pulses come late, f1 p/P.
       */
      greatest_speed_mm_per_min: number;
      /**
       * Format: uint64
       * @description Tick at which the run ended.
       */
      last_tick: number;
      /** @description Rule of corrections. */
      mode: components["schemas"]["InterpolationMode"];
      /**
       * Format: double
       * @description Distance of reference pulses.
       */
      pitch_mm: number;
      /**
       * Format: uint32
       * @description P.
       */
      pulses_per_interval: number;
      /**
       * Format: double
       * @description Reference pulses per metre of feed.
       */
      pulses_per_metre: number;
      /** @description How pulses become rotation. */
      rate: components["schemas"]["RotationRate"];
      /** @description Whether the machine counts the other way. */
      reversed: boolean;
      /**
       * Format: uint32
       * @description Workpiece pulses per revolution.
       */
      workpiece_pulses_per_revolution: number;
    };
    /** @description Hand of a helix. */
    Hand: "left" | "right";
    /** @description What the document of a measurement says beside what was measured. */
    HandedIn: {
      /** @description What became of the parts in the store, where they are kept. */
      kept?: components["schemas"]["MeasurementReport"] | null;
      /** @description What was uploaded beside measurements. */
      left_out?: components["schemas"]["LeftOutFile"][];
    };
    /** @description A value of a rotary axis. */
    HeldAngle: {
      /** @description Name of the axis. */
      axis: string;
      /**
       * Format: double
       * @description Its value as the control counts.
       */
      value_deg: number;
    };
    /** @description One measurement of a tool. */
    HistoryRecord: {
      /** @description Profiles of both flanks. */
      flanks: components["schemas"]["RecordedFlanks"];
      /** @description How the tool was mounted. */
      mounting: components["schemas"]["RecordedMounting"];
      /** @description Edges that left the tolerance band. */
      out_of_band: components["schemas"]["RecordedEdge"][];
      /**
       * Format: double
       * @description Workpieces cut since the edge was last ground.
       */
      parts: number;
      /** @description Pitch. */
      pitch: components["schemas"]["RecordedPitch"];
      /**
       * Format: uint32
       * @description How often the tool has been resharpened.
       */
      resharpened: number;
      /** @description When it was measured: date and time with zone (RFC 3339), e.g. `2026-03-14T09:30:00Z`. */
      time: string;
      /** @description The tool, by any name that is its own. */
      tool: string;
      /** @description Version of the program that evaluated the measurement. */
      version: string;
    };
    /** @description Measurements of the tool since it was ground. */
    HistoryResult: {
      /** @description Wear by flank. */
      flanks: {
        [key: string]: components["schemas"]["FlankTrendResult"];
      };
      /**
       * Format: uint
       * @description Measurements since it was ground.
       */
      measurements: number;
      /**
       * Format: double
       * @description Workpieces cut until now.
       */
      parts: number;
      /**
       * Format: uint32
       * @description How often it has been ground again.
       */
      resharpened: number;
      /** @description The tool. */
      tool: string;
    };
    /** @description A figure and the shop's limit for it. */
    IndicatorResult: {
      /**
       * Format: double
       * @description The limit.
       */
      allowed: number;
      /** @description Key of the limit. */
      limit: string;
      /**
       * Format: double
       * @description Figure over limit.
       */
      share: number;
      /**
       * Format: double
       * @description The largest figure.
       */
      value: number;
    };
    /** @description What the files of a measurement do not tell, and how its sheets look. */
    InspectOptions: {
      /**
       * @description The measured gear is the blank before grinding: the stock that it has over the gear of the job, tooth by tooth, as the table `stock.csv` for
       *     the key `stock.map`.
       * @default false
       */
      blank?: boolean;
      /**
       * Format: int32
       * @description Class of ISO 1328-1 whose tolerances are the limits, 1 to 11.
       * @default null
       */
      class?: number | null;
      /**
       * @description `+z` or `-z`.
       * @default null
       */
      datum_face?: string | null;
      /**
       * @description The gear was measured from the other end.
       * @default false
       */
      from_other_end?: boolean;
      /**
       * @description `face-width` or `range`.
       * @default null
       */
      helix_slope_over?: string | null;
      /**
       * @description Puts the parts into the store.
       * @default false
       */
      keep?: boolean;
      /**
       * @description Language of report, sheets and series, `en` or `de`; without it that of the job, else English.
       * @default null
       */
      language?: string | null;
      /**
       * @description `face-width` or `range`.
       * @default null
       */
      profile_slope_over?: string | null;
      /**
       * @description Their series there.
       * @default null
       */
      series?: string | null;
      /** @default null */
      slope_signs?: null | components["schemas"]["Signs"];
      /**
       * @description Helix traces with the top of the measuring machine upwards.
       * @default false
       */
      top_up?: boolean;
    };
    /** @description The whole document. */
    InspectionSeriesResult: {
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description Parts that belong together, by name. */
      groups: components["schemas"]["SeriesGroupResult"][];
      /** @description What the folder holds beside its measurements. */
      left_out?: components["schemas"]["LeftOutFile"][];
      /** @description Process. */
      process: string;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description Files that were not evaluated, in the order of the paths. */
      refused: components["schemas"]["RefusedFile"][];
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description What the user stated about all measurements. */
      stated?: string[];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /**
       * Format: int32
       * @description Class of ISO 1328-1:2013 that gives the limits.
       */
      tolerance_class?: number | null;
      /** @description Version of flankwright. */
      version: string;
    };
    /** @description How corrections of an ended interval are counted, and in which sense they run. */
    InterpolationMode: "one-way" | "no-backlash" | "literal";
    /** @description A job as a client sends it. */
    Job: {
      /** @description Texts of the files that it names, by their names. */
      files?: {
        [key: string]: string;
      };
      /** @description Its text, TOML or JSON. */
      text: string;
    };
    /** @description The whole document. */
    JobResult: {
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description Changes of the job that were planned because its flank is missed, in order; the last one meets the target if one does. */
      changes?: components["schemas"]["ChangeResult"][];
      /** @description What gearbox and servo leave; absent unless the job describes its control. */
      control?: components["schemas"]["ControlResult"] | null;
      /** @description What the settings leave with axes that are off; absent without `[deviations]`. */
      deviated?: components["schemas"]["DeviatedResult"] | null;
      /** @description Tooth thickness and class of the drawing, which nothing here judges. */
      drawing: components["schemas"]["DrawingResult"];
      /** @description Flanks that are ground. */
      flanks: {
        [key: string]: components["schemas"]["FlankResult"];
      };
      /** @description The root of the gear; absent unless the worm's tip grinds it. */
      gear_root?: components["schemas"]["GearRootResult"] | null;
      /** @description Largest error of the ideal worm by round of precompensation, per flank. */
      ideal_error_by_round_um: components["schemas"]["Sides2"];
      /** @description Name of the job. */
      job: string;
      /** @description How near any flank could come; absent unless a plan misses its target and best fits know its bodies. */
      least_deviation?: components["schemas"]["LeastDeviationResult"] | null;
      /** @description What a measured worm says of the dressing axes; absent without `[measured_worm]`. */
      measured_worm?: components["schemas"]["MeasuredWormResult"] | null;
      /** @description Process. */
      process: string;
      /** @description NC programs with their proof; absent without a machine. */
      programs?: components["schemas"]["ProgramsResult"] | null;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description Stock, removal, load of the worm, time and cost; absent without stock. */
      removal?: components["schemas"]["RemovalResult"] | null;
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description Settings. */
      settings: components["schemas"]["SettingsResult"];
      /** @description Smaller worms that today's dressing leaves whole; absent where no single dresser works on a cylindrical worm. */
      spared_worms?: components["schemas"]["SparedWormsResult"] | null;
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um: number;
      /** @description Version of flankwright. */
      version: string;
      /** @description Warnings. */
      warnings: components["schemas"]["Remark"][];
      /** @description The worm as wanted and as dressed, per flank; absent unless the job wants a worm topography. */
      worm?: {
        [key: string]: components["schemas"]["WormFlankResult"];
      };
    };
    /** @description One of several axes that may be off at once. */
    JointAxis: {
      /** @description Its name with the unit, as forward models have it. */
      axis: string;
      /**
       * Format: double
       * @description Its standard uncertainty beside the others.
       */
      uncertainty: number;
      /**
       * Format: double
       * @description Its deviation in that unit.
       */
      value: number;
    };
    /** @description An item that was judged. */
    JudgedItem: {
      /** @description The figure that decided, or how it was judged. */
      detail: string;
      /** @description What was judged: a flank, the threads of the worm, the root, the rapids of a program. */
      item: string;
      /** @description [`Status::Met`] or [`Status::Missed`]. */
      status: components["schemas"]["Status"];
    };
    /** @description A key with its new value. */
    KeyChange: {
      /** @description The key, from the root of the job. */
      key: string;
      /** @description Its value as TOML has it. */
      value: string;
    };
    /** @description A part that was there already. */
    KnownPart: {
      /** @description The digest by which it is known. */
      digest: string;
      /** @description Its first file. */
      file: string;
    };
    /**
     * @description How near any flank of the class of best fits comes to a target that is missed, over all diagonal ratios that the worm is wide enough for;
     *     normal.
     */
    LeastDeviationResult: {
      /**
       * Format: double
       * @description How far the planned flank lies from the class: the higher order that the bound neglects.
       */
      beyond_class_um: number;
      /**
       * Format: double
       * @description The bound: the first less the second.
       */
      bound_um: number;
      /**
       * Format: double
       * @description Ratio at which least is left.
       */
      diagonal_ratio: number;
      /**
       * Format: double
       * @description What is left there at least within the limits of axes and envelope, to first order.
       */
      first_order_um: number;
      /**
       * Format: double
       * @description What the plan leaves.
       */
      planned_um: number;
      /** @description Whether the bound is above the tolerance and the plan next to the bound. */
      proven: boolean;
      /**
       * Format: double
       * @description What is left at that ratio without the limits of the axes, to first order.
       */
      without_axis_limits_um: number;
      /**
       * Format: double
       * @description What is left at that ratio without the limit of the envelope, to first order.
       */
      without_envelope_limit_um: number;
    };
    /** @description Something in a folder that was not evaluated. */
    LeftOutFile: {
      /** @description Its name. */
      file: string;
      /** @description Why. */
      reason: string;
    };
    /** @description Numbers behind H and D. */
    LengthNumbers: {
      /**
       * Format: uint32
       * @description Behind D.
       */
      d: number;
      /**
       * Format: uint32
       * @description Behind H.
       */
      h: number;
    };
    /** @description The whole life of a worm with a dresser. */
    LifeCurve: {
      /** @description Name of the dresser. */
      dresser: string;
      /** @description From the current diameter to the smallest. */
      points: components["schemas"]["LifePoint"][];
      /** @description Name of the worm. */
      worm: string;
    };
    /** @description One diameter in the life of a pair. */
    LifePoint: {
      /** @description Figures per flank that is ground. */
      flanks: {
        [key: string]: components["schemas"]["PairFlank"];
      };
      /**
       * Format: double
       * @description max |DK_j/limit_j|.
       */
      largest_share_of_limit: number | null;
      /** @description Why the target is not made at this diameter, if so. */
      refused: components["schemas"]["Refused"] | null;
      /** @description Profile crowning of the gear without corrections of crossing angle and offset, per flank. */
      uncorrected_crowning_um: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Pitch diameter of the worm.
       */
      worm_pitch_diameter_mm: number;
    };
    /** @description How much of a limit is used. */
    LimitShare: {
      /** @description Key of the limit. */
      limit: string;
      /**
       * Format: double
       * @description Figure over limit; of feed marks the feed over the one that they allow.
       */
      share: number;
    };
    /** @description Figures of line dressing in `result.json`. */
    LineDressingResult: {
      /**
       * Format: double
       * @description Least distance of the disc to the opposite flank.
       */
      clearance_mm: number;
      /**
       * Format: double
       * @description Crossing angle gamma_A that is kept.
       */
      crossing_angle_deg: number;
      /**
       * Format: double
       * @description Smallest radius of the worm that the rim reaches.
       */
      deepest_radius_mm: number;
      /**
       * Format: double
       * @description Direction rho_1 of the lines.
       */
      line_direction_deg: number;
      /**
       * Format: uint
       * @description Lines on one thread.
       */
      lines: number;
      /**
       * Format: uint
       * @description Nodes of the motion along a line.
       */
      nodes_per_line: number;
      /**
       * Format: double
       * @description Length of the contact path on one thread.
       */
      path_length_m: number;
      /**
       * Format: double
       * @description Pitch p_X of the lines.
       */
      pitch_mm: number;
      /**
       * Format: double
       * @description Height of the scallops by the relative curvature.
       */
      scallop_um: number;
      /**
       * Format: double
       * @description Greatest height over the wanted worm flank on the referee's sample of rays.
       */
      simulated_scallop_um: number;
      /**
       * Format: double
       * @description Greatest depth below the wanted worm flank on the same rays.
       */
      simulated_undercut_um: number;
      /**
       * Format: uint32
       * @description Threads that are written alike.
       */
      threads: number;
    };
    /** @description One flank of the worm whose lines were found in a text. */
    LinesProof: {
      /**
       * Format: double
       * @description Difference of a line from the plan's that blocks and digits explain.
       */
      allowed_difference_um: number;
      /**
       * Format: double
       * @description Largest distance of a line from its place across the lines.
       */
      aside_um: number;
      /**
       * Format: double
       * @description Deviation of straight blocks.
       */
      chords_um: number;
      /** @description The program. */
      file: string;
      /** @description "left" or "right". */
      flank: string;
      /**
       * Format: double
       * @description Least distance of its rounded tip from the opposite flank inside the thread space, beside the lines.
       */
      inside_mm?: number | null;
      /**
       * Format: double
       * @description Largest distance of a line from that of the plan, along the normal of the worm.
       */
      line_difference_um: number;
      /**
       * Format: uint
       * @description Lines on each thread, all of them counted.
       */
      lines: number;
      /**
       * Format: double
       * @description Least distance of the disc from the worm's tip cylinder where it is outside the thread space.
       */
      outside_mm?: number | null;
      /**
       * Format: double
       * @description Largest difference of a ray from that on the lines of the run.
       */
      ray_difference_um: number;
      /**
       * Format: uint
       * @description Rays of the referee on each thread, across the lines at several places.
       */
      rays: number;
      /**
       * Format: double
       * @description What the digits may add.
       */
      rounding_um: number;
      /**
       * Format: double
       * @description Greatest height over the wanted worm flank on these rays.
       */
      scallop_um: number;
      /**
       * Format: uint
       * @description Threads on which they were counted.
       */
      threads: number;
      /**
       * Format: double
       * @description Greatest depth below it.
       */
      undercut_um: number;
    };
    /** @description Lines of a file that were not understood. */
    LinesResult: {
      /** @description File. */
      file: string;
      /**
       * Format: uint
       * @description Line, from 1.
       */
      line: number;
      /** @description Its beginning. */
      text: string;
    };
    /** @description A run in a list. */
    ListedRun: components["schemas"]["RunSummary"] & {
      progress?: null | components["schemas"]["Advance"];
    };
    /**
     * @description What changes on the machine: coefficients over the feed and largest changes of the dressing axes; nothing where the flank itself is
     *     corrected.
     */
    MachineChange: {
      /** @description Change of Delta_d over z_V2, um/mm^k. */
      delta_d_um: number[];
      /** @description Change of Delta_phi_2 over z_V2, urad/mm^k. */
      delta_phi_2_urad: number[];
      /** @description Largest change of d_phi_S (deg), d_gamma (deg), d_d (mm), d_v_yA (mm) while the worm is dressed, by flank. */
      dressing: {
        [key: string]: number[];
      };
    };
    /** @description A machine that jobs may name. */
    MachineSummary: {
      /** @description What it is. */
      description?: string | null;
      /** @description As a job names it, e.g. `machines/eight-axis.toml`. */
      file: string;
      /** @description Its name. */
      name: string;
    };
    /** @description A switch of the mandrel. */
    MandrelSwitchResult: {
      /** @description Axis along which it moves. */
      along: string;
      /** @description X and Y of its axis, Z of its lower face. */
      place_mm: [number, number, number];
    };
    /**
     * @description A way of a mandrel on which the recorder takes down where the axes stand when the beam switches. Places: X and Y of its axis, Z of its
     *     lower face.
     */
    MandrelWayResult: {
      /** @description Axis along which it moves. */
      along: string;
      /** @description Where it begins. */
      from_mm: [number, number, number];
      /**
       * Format: double
       * @description Turn of the spindle.
       */
      spindle_deg: number;
      /** @description Where the given beam switches. */
      switches_mm: [number, number, number][];
      /** @description Where it ends. */
      to_mm: [number, number, number];
    };
    /** @description Contact on one flank of the gear, without load. */
    MateFlankResult: {
      /** @description Pattern that both ease-offs say. */
      ease_off?: components["schemas"]["PatternResult"] | null;
      /** @description Pattern of the flank as it is milled, with its scallops and chords; absent if nothing is marked or predicted. */
      milled?: components["schemas"]["PatternResult"] | null;
      /**
       * Format: double
       * @description Common area of both patterns over the area that either covers.
       */
      overlap_percent: number;
      /** @description Its separate parts, the largest first; one where the pattern hangs together. */
      parts: components["schemas"]["PatternResult"][];
      /**
       * Format: uint
       * @description Places of the milled flank of which nothing is predicted, so that they are not rolled.
       */
      places_not_predicted: number;
      /** @description Pattern that rolling leaves; absent if nothing is marked. */
      rolled?: components["schemas"]["PatternResult"] | null;
      /**
       * Format: double
       * @description Peak to peak of a mesh period, as turn of the mate.
       */
      transmission_error_arcsec: number;
      /**
       * Format: double
       * @description What both ease-offs say for it.
       */
      transmission_error_ease_off_um: number;
      /**
       * Format: double
       * @description Peak to peak of the flank as it is milled, as turn of the mate.
       */
      transmission_error_milled_arcsec?: number | null;
      /**
       * Format: double
       * @description The same at the mate's mean pitch radius.
       */
      transmission_error_milled_um?: number | null;
      /**
       * Format: double
       * @description The same at the mate's mean pitch radius.
       */
      transmission_error_um: number;
    };
    /** @description A gear rolled against its mate, both with the flanks that are wanted, and the flanks of the gear as they are milled. */
    MateResult: {
      /**
       * Format: double
       * @description Circumferential backlash of nominal cylindrical gears at the working pitch circle.
       */
      backlash_um?: number | null;
      /**
       * Format: double
       * @description Centre distance of cylindrical gears.
       */
      centre_distance_mm?: number | null;
      /** @description Flanks that are milled. */
      flanks: {
        [key: string]: components["schemas"]["MateFlankResult"];
      };
      /**
       * Format: double
       * @description Gaps up to here show contact.
       */
      marking_um: number;
      /**
       * Format: double
       * @description Radius of its pitch cone in the middle of the face, or of its working pitch circle; transmission errors in um are ways there.
       */
      mean_pitch_radius_mm: number;
      /**
       * Format: double
       * @description Pitch cone angle of a bevel gear.
       */
      pitch_cone_angle_deg?: number | null;
      /**
       * Format: double
       * @description Angle between the axes of bevel gears.
       */
      shaft_angle_deg?: number | null;
      /** @description Where the milled flank begins and where the mate needs it to. */
      start_of_flank: components["schemas"]["MateStartResult"];
      /**
       * Format: uint32
       * @description Teeth of the mate.
       */
      teeth: number;
    };
    /** @description Where a flank begins: polar angles of a bevel gear in degrees, or diameters. */
    MateStartResult: {
      /**
       * Format: double
       * @description Where the flank that is milled begins.
       */
      active_deg?: number | null;
      /**
       * Format: double
       * @description Where the flank of a cylindrical gear begins.
       */
      active_diameter_mm?: number | null;
      /** @description Whether all that the mate needs is milled. */
      covered: boolean;
      /**
       * Format: double
       * @description Where the tip of the mate engages; absent where it reaches below the base cone.
       */
      needed_deg?: number | null;
      /**
       * Format: double
       * @description Where the tip of the mate engages; absent where it reaches below the base circle.
       */
      needed_diameter_mm?: number | null;
    };
    /** @description A value of one characteristic on a part. */
    MeasuredCharacteristic: {
      /** @description When it was measured. */
      date: string | null;
      /** @description Digest of the part's file: its identity. */
      digest: string;
      /** @description Flank. */
      flank: components["schemas"]["Flank"] | null;
      /**
       * Format: double
       * @description Lower limit, in the same unit.
       */
      lower_limit: number | null;
      /** @description Symbol. */
      name: string;
      /** @description Number or name of the part. */
      part: string;
      /** @description What was made of single values. */
      statistic: string;
      /**
       * Format: uint32
       * @description Tooth.
       */
      tooth: number | null;
      /** @description Unit. */
      unit: string;
      /**
       * Format: double
       * @description Upper limit, in the same unit.
       */
      upper_limit: number | null;
      /**
       * Format: double
       * @description The value.
       */
      value: number;
    };
    /** @description A flank on the grid, row-major [profile][helix]; absent values were not measured. */
    MeasuredFlankResult: {
      /**
       * Format: double
       * @description Correlation of measured and simulated deviations.
       */
      correlation?: number | null;
      /** @description Whether the process model explains the part. */
      explained: boolean;
      /** @description Measured minus target. */
      measured: components["schemas"]["DifferenceResult"];
      /** @description Measured, mean over the teeth; its zero is that of the target. */
      measured_um: (number | null)[][];
      /** @description How far profiles and helix traces disagree where they cross: root mean square and largest. */
      mismatch_um?: [number, number];
      /** @description Measured minus simulated. */
      model: components["schemas"]["DifferenceResult"];
      /** @description How far the grid goes beyond the outermost lines, as a share of the field, where that is far. */
      outside_traces?: {
        [key: string]: number;
      };
      /** @description Planned, with compensation, by the exact contact. */
      planned_um: number[][];
      /** @description Simulated minus target. */
      produced: components["schemas"]["DifferenceResult"];
      /** @description Whether the measured lines tell anything of the twist; one profile and one helix trace do not. */
      sees_twist: boolean;
      /** @description The same by the referee's rays. */
      simulated_um: number[][];
      /**
       * @description Teeth that differ from the others beyond chance and by more than the tolerance: their largest difference from what all share and what
       *     goes around the gear once a turn, um.
       */
      standing_out?: {
        [key: string]: number;
      };
      /** @description What the surface was made of. */
      surface: string;
      /** @description Target, without compensation. */
      target_um: number[][];
      /**
       * Format: uint
       * @description Teeth that it is the mean of.
       */
      teeth: number;
      /** @description Lengths of roll. */
      w_mm: number[];
      /** @description Heights. */
      z_mm: number[];
    };
    /** @description What a measured worm says of the dressing axes. */
    MeasuredWormResult: {
      /** @description The axes with what each would be off by, under the names that `deviations.dressing` has. */
      axes: components["schemas"]["WormAxis"][];
      /**
       * Format: uint
       * @description Measured points that the planned motion dresses.
       */
      points: number;
      /**
       * Format: uint
       * @description Points beside the dressed area, which are not used.
       */
      points_left_out: number;
      /**
       * Format: double
       * @description The same less what the deviations explain.
       */
      rms_left_um: number;
      /**
       * Format: double
       * @description Root of the mean square of measured less planned, each flank about its mean unless the thickness is known.
       */
      rms_um: number;
    };
    /** @description What became of the files. */
    MeasurementReport: {
      /**
       * Format: uint
       * @description Parts among the known ones whose files were put beside their values; earlier imports had not kept them.
       */
      completed: number;
      /** @description New parts, and those that were evaluated again, in the order of the files. */
      imported: components["schemas"]["PartSummary"][];
      /** @description Parts whose files have the content of a part that is there, or of one before them. */
      known: components["schemas"]["KnownPart"][];
      /** @description What lies beside measurements in folders. */
      left_out?: components["schemas"]["LeftOutFile"][];
      /** @description What could not be imported, and why. */
      refused: components["schemas"]["RefusedFile2"][];
      /**
       * Format: uint
       * @description How many of them took the place of stored ones.
       */
      replaced: number;
    };
    /** @description The measured tool. */
    MeasurementResult: {
      /**
       * Format: double
       * @description Clocking of the tool.
       */
      clocking_deg: number;
      /** @description Correction of the setting. */
      correction: components["schemas"]["CorrectionResult2"];
      /** @description f: deviations normal to the flank, [track][tooth], > 0 = material beyond the nominal edge; null where a tooth did not switch. */
      deviation_um: {
        [key: string]: (number | null)[][];
      };
      /** @description Switches that are not there; absent where all are. */
      missing?: components["schemas"]["MissingResult"][];
      /** @description Mounting error. */
      mounting: components["schemas"]["MountingResult"];
      /** @description Pitch at the middle track. */
      pitch: components["schemas"]["PitchResult"];
      /** @description Profile, bands, wear. */
      profile: components["schemas"]["ProfileResult"];
      /**
       * Format: uint
       * @description Readings in all.
       */
      readings: number;
      /**
       * Format: uint
       * @description Of which each deviation is the mean.
       */
      readings_each: number;
      /** @description f_r: the same without clocking and mounting. */
      remaining_um: {
        [key: string]: (number | null)[][];
      };
      /** @description What grinding it again has to take off; every tooth stands in resharpening.json. */
      resharpening: components["schemas"]["ResharpeningResult"];
      /** @description f(-) - f(+) of every track, where both senses were measured: delay and hysteresis of the barrier. */
      sense_difference_um?: {
        [key: string]: number[];
      } | null;
      /** @description Standard deviation of a deviation, by flank and track, as barrier and encoder scatter. */
      sigma_um: {
        [key: string]: number[];
      };
    };
    /** @description What a request is made of; for the interface document. */
    MeasurementsRequest: {
      /** @description The files, at least one, unless a stored part is named. */
      file?: string[] | null;
      /** @description A job, as JSON. */
      job?: string | null;
      /** @description Options, as JSON. */
      options?: string | null;
      /**
       * @description A part of the store in place of files: its number, or the beginning of its digest. What was stated when it was stored holds, unless the
       *     options state something.
       */
      part?: string | null;
    };
    /** @description A part of the errors of what is measured. */
    MeasuringPart: {
      /**
       * Format: double
       * @description Along the feed, against the place where the motion begins; absent for the encoder.
       */
      along_feed_um?: number | null;
      /**
       * Format: double
       * @description At the flank.
       */
      flank_um: number;
      /** @description What it is. */
      name: string;
    };
    /** @description Errors of scale, ball screw and encoder, each as far as it can be off over the motion. */
    MeasuringResult: {
      /** @description What the encoder leaves on the teeth; absent without `errors.encoder`. */
      encoder?: components["schemas"]["EncoderResult"] | null;
      /** @description Part by part. */
      parts: components["schemas"]["MeasuringPart"][];
      /**
       * Format: double
       * @description Their sum at the flank.
       */
      sum_flank_um: number;
    };
    /** @description A method beside others. */
    MethodResult: {
      /** @description Whether it settled. */
      converged: boolean | null;
      /**
       * Format: double
       * @description Largest |m - f| on the grid of the result.
       */
      largest_um: number | null;
      /** @description Method. */
      method: string;
      /** @description Why there is none, if so. */
      refused: components["schemas"]["Remark"] | null;
      /**
       * Format: uint
       * @description Rounds of all parts.
       */
      rounds: number | null;
      /**
       * Format: uint
       * @description Parts in which the target was stepped up.
       */
      steps: number;
      /**
       * Format: double
       * @description Weighted root mean square on the grid of the fit.
       */
      weighted_rms_um: number | null;
    };
    /** @description The whole document. */
    MillingResult: {
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description Programs that find the clocking angle of a part whose teeth are cut already, proven by the referee's rays; empty without a probe. */
      clocking_programs?: components["schemas"]["ClockingResult"][];
      /** @description The cutter of the flanks. */
      cutter: components["schemas"]["CutterResult"];
      /** @description Tooth thickness and class of the drawing, which nothing here judges; absent of bevel gears and blades. */
      drawing?: components["schemas"]["DrawingResult"] | null;
      /** @description Flanks that are milled. */
      flanks: {
        [key: string]: components["schemas"]["FlankResult2"];
      };
      /** @description Name of the job. */
      job: string;
      /** @description Contact with the mate; absent without one. */
      mate?: components["schemas"]["MateResult"] | null;
      /** @description Operations in their order, for one space. */
      operations: components["schemas"]["OperationResult"][];
      /** @description Process. */
      process: string;
      /** @description NC programs, every one read back and proven; empty without a machine. */
      programs: components["schemas"]["ProgramResult2"][];
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /**
       * @description Deviations of the root from its drawn section, part by part (`left_fillet`, `right_fillet`, `bottom`); absent without a pass of the
       *     root.
       */
      root?: {
        [key: string]: components["schemas"]["RootDeviationResult"];
      };
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description Spaces of the workpiece, and how many of them are milled. */
      spaces: number[];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Stock on them before they are finished: what roughing leaves, or the allowance of a pre-cut part; absent where neither is known. */
      stock?: {
        [key: string]: components["schemas"]["StockResult2"];
      };
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um: number;
      /** @description Tools by their first use. */
      tools: components["schemas"]["ToolResult"][];
      /** @description Version of flankwright. */
      version: string;
      /** @description Warnings. */
      warnings: components["schemas"]["Remark"][];
      /** @description What the control has to hold as work offset; absent where programs count from the origins of machine and table. */
      work_offset?: components["schemas"]["WorkOffsetResult"] | null;
    };
    /** @description A switch that is not there. */
    MissingResult: {
      /** @description Flank. */
      flank: string;
      /**
       * Format: uint
       * @description Tooth.
       */
      tooth: number;
      /**
       * Format: uint
       * @description Track.
       */
      track: number;
    };
    /**
     * @description One modification as a file describes it. Amounts in um, transverse, positive = material removed unless the kind
     *     says otherwise; lengths in mm. Unknown keys are refused inside every kind.
     */
    ModificationSpec:
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_crowning";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_crowning_arc";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_crowning_radius";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_slope_radius";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "helix_crowning";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "helix_crowning_arc";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount at face II (upper z), the datum face, um; another name of `amount_datum_face_um`.
           */
          amount_II_um?: number | null;
          /**
           * Format: double
           * @description Amount at face I (lower z), the face opposite the datum face, um; another name of `amount_non_datum_face_um`.
           */
          amount_I_um?: number | null;
          /**
           * Format: double
           * @description Amount at the datum face (upper z, face II), um.
           */
          amount_datum_face_um?: number | null;
          /**
           * Format: double
           * @description Amount at the face opposite the datum face (lower z, face I), um.
           */
          amount_non_datum_face_um?: number | null;
          /**
           * Format: double
           * @description Apex, mm, inside the field.
           */
          apex_z_mm: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "helix_crowning_two_arc";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount at the tip, um.
           */
          amount_II_um: number;
          /**
           * Format: double
           * @description Amount at the root, um.
           */
          amount_I_um: number;
          /**
           * Format: double
           * @description Apex, mm length of roll, inside the field.
           */
          apex_w_mm: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_crowning_two_arc";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_slope";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "helix_slope";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "twist";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * Format: double
           * @description Amount at the border of the field, um.
           */
          amount_um: number;
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "tip_relief";
          /**
           * Format: double
           * @description Length over which it grows, mm (length of roll for tip and root).
           */
          length_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length over which a straight relief starts rounded, mm.
           * @default 0
           */
          transition_mm: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the border of the field, um.
           */
          amount_um: number;
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "root_relief";
          /**
           * Format: double
           * @description Length over which it grows, mm (length of roll for tip and root).
           */
          length_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length over which a straight relief starts rounded, mm.
           * @default 0
           */
          transition_mm: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the border of the field, um.
           */
          amount_um: number;
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "end_relief_I";
          /**
           * Format: double
           * @description Length over which it grows, mm (length of roll for tip and root).
           */
          length_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length over which a straight relief starts rounded, mm.
           * @default 0
           */
          transition_mm: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the border of the field, um.
           */
          amount_um: number;
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "end_relief_II";
          /**
           * Format: double
           * @description Length over which it grows, mm (length of roll for tip and root).
           */
          length_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length over which a straight relief starts rounded, mm.
           * @default 0
           */
          transition_mm: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the border of the field, um.
           */
          amount_um: number;
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "end_relief_datum_face";
          /**
           * Format: double
           * @description Length over which it grows, mm (length of roll for tip and root).
           */
          length_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length over which a straight relief starts rounded, mm.
           * @default 0
           */
          transition_mm: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the border of the field, um.
           */
          amount_um: number;
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "end_relief_non_datum_face";
          /**
           * Format: double
           * @description Length over which it grows, mm (length of roll for tip and root).
           */
          length_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length over which a straight relief starts rounded, mm.
           * @default 0
           */
          transition_mm: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the corner, um.
           */
          amount_um: number;
          /** @description Face of the corner. */
          corner_face: components["schemas"]["CornerFace"];
          /** @description Profile end of the corner. */
          corner_profile: components["schemas"]["CornerProfile"];
          /**
           * Format: double
           * @description Exponent of the law: 1 = straight, 2 = parabola; at least 1.
           * @default 1
           */
          exponent: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "triangular_end_relief";
          /**
           * Format: double
           * @description Extent along the length of roll, mm.
           */
          length_w_mm: number;
          /**
           * Format: double
           * @description Extent along the face width, mm.
           */
          length_z_mm: number;
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Half length of the rounded start of a straight relief, as a share of the extent.
           * @default 0
           */
          transition: number;
        }
      | {
          /**
           * Format: double
           * @description Amount at the farthest corners, um.
           */
          amount_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "directed_crowning";
          /** @description The direction in which amounts are measured. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Direction, degree: the crowning varies along w sin rho + z cos rho.
           */
          rho_deg: number;
        }
      | {
          /**
           * Format: double
           * @description Amplitude in the middle of the field, um.
           */
          amp_0_um: number;
          /**
           * Format: double
           * @description Growth of the amplitude to tip and root, um.
           * @default 0
           */
          amp_uu_um: number;
          /**
           * Format: double
           * @description Growth of the amplitude to the faces, um.
           * @default 0
           */
          amp_vv_um: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "waviness";
          /**
           * Format: double
           * @description Phase at X = 0, degree.
           * @default 0
           */
          phase_deg: number;
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
          /**
           * Format: double
           * @description Direction of the wave, degree: X = w sin rho + z cos rho.
           */
          rho_deg: number;
          /**
           * Format: double
           * @description Wavelength along X, mm.
           */
          wavelength_mm: number;
        }
      | {
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "polynomial";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
          /** @description Terms [i, j, a_ij], a_ij in um/mm^(i+j). */
          terms: [number, number, number][];
          /**
           * Format: double
           * @description Origin w_0, mm.
           * @default 0
           */
          w0_mm: number;
          /**
           * Format: double
           * @description Origin z_0, mm.
           * @default 0
           */
          z0_mm: number;
        }
      | {
          /** @description Values `[w][z]`, um. */
          f_um?: number[][];
          /** @description A file that holds the table, instead of the three lists. */
          file?: string | null;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "grid";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
          /** @description Lengths of roll, ascending, at least 4, mm. */
          w_mm?: number[];
          /** @description Face positions, ascending, at least 4, mm. */
          z_mm?: number[];
        }
      | {
          /** @description A file that holds the points, instead of the list. */
          file?: string | null;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "points";
          /**
           * @description How the space between the points is filled.
           * @default linear
           */
          method: components["schemas"]["PointMethod"];
          /** @description Points [w mm, z mm, f um], at least 3, not on one line. */
          points?: [number, number, number][];
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /** @description Values `[w][z]`, um. */
          f_um?: number[][];
          /** @description A file that holds the traces, instead of the three lists. */
          file?: string | null;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "helix_traces";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
          /** @description Lengths of roll of the traces, ascending, 2 or 3, mm. */
          w_mm?: number[];
          /** @description Face positions, ascending, at least 4, mm. */
          z_mm?: number[];
        }
      | {
          /** @description A CSV file with the columns w_mm and f_um, instead of the list. */
          file?: string | null;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "profile_trace";
          /**
           * Format: double
           * @description Standard deviation of a point, um; without it the scatter about the curve tells it.
           */
          noise_um?: number | null;
          /** @description Points [w mm, f um] that cover the evaluation range, at least 8. */
          points?: [number, number][];
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * @description f in um, of w, z (mm), u, v (from -1 to 1 over the field), w_f, w_a, z_I, z_II (its borders, mm), pi; with + - * / ^,
           *     parentheses, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, ln, log10, sqrt, abs, min, max.
           */
          f_um: string;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "formula";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /** @description The parts, at least one. */
          children: components["schemas"]["ModificationSpec"][];
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "sum";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /** @description The parts, at least one. */
          children: components["schemas"]["ModificationSpec"][];
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "product";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /** @description What is multiplied; several are added first. */
          children: components["schemas"]["ModificationSpec"][];
          /**
           * Format: double
           * @description The factor.
           */
          factor: number;
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "scale";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        }
      | {
          /**
           * @description The coordinate that changes its sign.
           * @default z
           */
          axis: components["schemas"]["Axis"];
          /** @description What is mirrored; several are added first. */
          children: components["schemas"]["ModificationSpec"][];
          /** @description The flanks to which it applies. */
          flank?: components["schemas"]["FlankChoice"];
          /** @constant */
          kind: "mirror";
          /** @description Always transverse: this kind has no `amount_*` to be divided. */
          reference?: components["schemas"]["Reference"];
        };
    /** @description How results scatter over repeated measurements. */
    MonteCarloResult: {
      /**
       * Format: uint
       * @description Repetitions.
       */
      measurements: number;
      /** @description Every result. */
      results: components["schemas"]["ScatterResult"][];
    };
    /** @description A tilt of the workpiece about its origin. */
    MountTilt: {
      /**
       * Format: double
       * @description Its angle, right-handed.
       */
      angle_deg: number;
      /** @description Its axis in coordinates of the table. */
      axis: [number, number, number];
      /**
       * Format: double
       * @description Least angle between the cutter's axis and the pole that is left.
       */
      pole_distance_deg: number;
    };
    /** @description Eccentricity and wobble, with standard deviations. */
    MountingResult: {
      /** @description Their standard deviations from how the teeth scatter; absent where the measurement does not tell. */
      eccentricity_sigma_um: [number, number];
      /** @description e_x, e_y. */
      eccentricity_um: [number, number];
      /** @description Outlier teeth: left out of clocking, means, mounting and correction. */
      left_out: number[];
      /** @description Their standard deviations; absent where the measurement does not tell. */
      wobble_sigma_urad: [number, number];
      /** @description om_x, om_y. */
      wobble_urad: [number, number];
    };
    /** @description A run that is wanted. */
    NewRunRequest: {
      /** @description The job. */
      job: components["schemas"]["Job"];
      /** @description What is done. */
      kind: components["schemas"]["Task"];
    };
    /** @description One operation in one space. */
    OperationResult: {
      /** @description How the cutter is engaged while it clears the space in layers; absent of other operations and of a single layer. */
      engagement?: components["schemas"]["EngagementResult2"] | null;
      /**
       * Format: double
       * @description Feed of the contact for each cutting edge; absent where the job does not tell their number.
       */
      feed_per_tooth_mm?: number | null;
      /** @description What it does. */
      name: string;
      /**
       * Format: uint
       * @description Paths.
       */
      paths: number;
      /**
       * Format: uint
       * @description Cutter locations.
       */
      places: number;
      /**
       * Format: double
       * @description Way of the tip in the material.
       */
      way_mm: number;
    };
    /** @description The rotary axes along one row, over the way of the contact. */
    OrientationFigures:
      | components["schemas"]["RotaryFigures"]
      | {
          /** @description Why. */
          not_reached: string;
        };
    /** @description The rotary motion of the middle row beside that of other systems (`docs/mathematics/milling.md#positions-of-five-axes`). */
    OrientationResult: {
      /** @description Its rotary axes, the one next to the workpiece first. */
      axes: string[];
      /** @description The axis in the column planes, as this plan has it. */
      column: components["schemas"]["OrientationFigures"];
      /**
       * Format: double
       * @description Height parameter of the row.
       */
      height: number;
      /** @description The axis along the flank's parameter lines. */
      iso: components["schemas"]["OrientationFigures"];
      /** @description The machine: that of the job, or a table A-C. */
      machine: string;
      /**
       * Format: double
       * @description Share of the face by which the lines of `sheared` are sheared.
       */
      shear: number;
      /** @description The axis along lines sheared to and fro. */
      sheared: components["schemas"]["OrientationFigures"];
    };
    /** @description The part of a flank towards the middle of a double-helical gear that the cutter does not reach. */
    OutOfReachResult: {
      /**
       * Format: double
       * @description Its greatest length along the axis, or along the pitch cone.
       */
      length_mm: number;
      /**
       * Format: uint
       * @description Rays in it; they are not judged.
       */
      rays: number;
      /**
       * Format: uint
       * @description The row that it is found on.
       */
      row: number;
    };
    /** @description One flank of a pair. */
    PairFlank: {
      /**
       * Format: double
       * @description Profile crowning asked of the dressing motion: the wanted one without that of the dresser.
       */
      crowning_by_motion_um: number;
      /**
       * Format: double
       * @description Correction of the centre distance.
       */
      d_d_mm: number;
      /**
       * Format: double
       * @description Correction of the crossing angle.
       */
      d_gamma_deg: number;
      /**
       * Format: double
       * @description Correction of the worm angle.
       */
      d_phi_S_deg: number;
      /**
       * Format: double
       * @description Correction of the offset.
       */
      d_v_yA_mm: number;
      /**
       * Format: double
       * @description Largest tip land that clears the opposite flank; absent where none does.
       */
      largest_tip_land_mm: number | null;
      /**
       * Format: double
       * @description Largest distance from the wanted parabola, normal.
       */
      profile_error_um: number;
      /**
       * Format: double
       * @description Relative stretch of the profile.
       */
      stretch: number;
    };
    /** @description How long a worm serves. */
    PairLife: {
      /** @description What ends it before the worm is used up. */
      ended_by: components["schemas"]["Refused"] | null;
      /**
       * Format: double
       * @description Current pitch diameter.
       */
      from_mm: number;
      /**
       * Format: double
       * @description Smallest pitch diameter at which the target is still made.
       */
      to_mm: number;
    };
    /** @description What a plan of the whole target with a pair leaves. */
    PairPlan: {
      /** @description Profile crowning over the width, wanted and made, by flank. */
      crowning: {
        [key: string]: components["schemas"]["CrowningAt"][];
      };
      /**
       * Format: double
       * @description Largest deviation from the target by the referee, normal, of the flank that has more.
       */
      deviation_um: number;
      /**
       * Format: double
       * @description Diagonal ratio.
       */
      diagonal_ratio: number;
      /**
       * Format: double
       * @description max |DK_j/limit_j| over the dressing stroke, of the flank that has more.
       */
      largest_share_of_limit: number;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /**
       * Format: double
       * @description Largest deviation over the tolerance at its place.
       */
      tolerance_share: number;
      /**
       * Format: double
       * @description Length of the worm that is used.
       */
      used_width_mm: number;
    };
    /** @description Crownings of a flank that a pair can make within the limits of the axes, whatever the target wants. */
    PairRange: {
      /**
       * Format: double
       * @description The largest one.
       */
      largest_um: number;
      /**
       * Format: double
       * @description The least one.
       */
      least_um: number;
      /** @description Whether the least and the largest crowning that the target wants over the width lie within. */
      serves_the_width: boolean;
    };
    /** @description What a text was proven for. */
    PartProof: {
      /** @description How near tool, holder and spindle come to the clamping over all moves, the nearest first; empty where the job names none. */
      clamping?: components["schemas"]["BodyClearance"][];
      /**
       * Format: double
       * @description Distance that is kept from it.
       */
      clamping_kept_mm?: number | null;
      /**
       * Format: double
       * @description How exactly the depth of a cut is known along a ray.
       */
      depth_resolution_mm: number;
      /** @description What is wrong. */
      faults: components["schemas"]["ProgramFault"][];
      /** @description What the proof says nothing of. */
      not_covered: string[];
      /**
       * Format: uint
       * @description Rapid moves that were looked at.
       */
      rapid_moves: number;
      /**
       * Format: double
       * @description Distance of the places and points of the tool that were looked at on them.
       */
      rapid_resolution_mm: number;
      /**
       * Format: double
       * @description Greatest distance of neighbouring rays on flanks, root and tips.
       */
      ray_spacing_mm: number;
      /**
       * Format: uint
       * @description Their rays.
       */
      rays: number;
      /** @description Spaces of the part, all of them under rays, and how many the job mills. */
      spaces: number[];
      /** @description In words. */
      statement: string;
      /** @description Surfaces under rays. */
      surfaces: string[];
    };
    /** @description A measured part. */
    PartRecord: {
      /** @description What a series is evaluated from, each characteristic once. */
      characteristics: components["schemas"]["CharacteristicValue"][];
      /**
       * @description When it was measured, by the clock of the measuring room: `2026-03-14` or `2026-03-14T09:30:00`;
       *     [`flankwright::exchange::inspection::sortable_date`] makes one of what machines write.
       */
      date?: string | null;
      /** @description SHA-256 of the bytes of that file ([`crate::digest_of`]): the identity of the part. */
      digest: string;
      /** @description The evaluated result. */
      document: Json;
      /** @description Number of the drawing. */
      drawing?: string | null;
      /** @description Measuring machine. */
      machine?: string | null;
      /** @description Number or name of the part. */
      part: string;
      /** @description The series whose trend it belongs to, e.g. a drawing or a family of parts. */
      series: string;
      /** @description Name of the file that it came from. */
      source: string;
    };
    /** @description A part without document and characteristics. */
    PartSummary: {
      /** @description When it was measured. */
      date: string | null;
      /** @description Digest of the file. */
      digest: string;
      /** @description Number of the drawing. */
      drawing: string | null;
      /**
       * @description Whether its files are in the store, so that more can be made of it: the stock of a blank. Parts of earlier imports have evaluated
       *     values only.
       */
      has_files: boolean;
      /** @description Measuring machine. */
      machine: string | null;
      /** @description Number or name of the part. */
      part: string;
      /** @description The series. */
      series: string;
      /** @description Name of the file. */
      source: string;
    };
    /** @description Time of a part; those of grinding and dressing are the programs' own. */
    PartTimeResult: {
      /**
       * Format: double
       * @description Loading, indexing and whatever else there is.
       */
      auxiliary_s: number;
      /**
       * Format: double
       * @description Share of dressing in a part.
       */
      dressing_per_part_s: number;
      /**
       * Format: double
       * @description All dressing programs.
       */
      dressing_s: number;
      /**
       * Format: double
       * @description The same by the law of moves from rest to rest.
       */
      grinding_by_law_s?: number | null;
      /**
       * Format: double
       * @description All grinding programs.
       */
      grinding_s: number;
      /**
       * Format: double
       * @description All of it.
       */
      part_s: number;
    };
    /** @description The partition of the tool. */
    Partition: {
      /**
       * Format: double
       * @description Length of one finishing area.
       */
      area_length_mm: number;
      /**
       * Format: double
       * @description Distance of neighbouring finishing areas.
       */
      area_pitch_mm: number;
      /**
       * Format: uint
       * @description Finishing areas laid out.
       */
      areas: number;
      /**
       * Format: uint
       * @description Finishing areas that fit beside the roughing areas; absent without a tool width.
       */
      areas_that_fit?: number | null;
      /**
       * Format: double
       * @description Length from the first area to the end of the last.
       */
      length_mm: number;
      /**
       * Format: uint
       * @description Roughing areas laid out.
       */
      roughing_areas: number;
      /** @description Added to z_V1 of the plan for each area, roughing first. */
      shifts_mm: number[];
    };
    /** @description One pass. */
    PassResult: {
      /**
       * Format: uint
       * @description Straight blocks of the stroke.
       */
      blocks: number;
      /**
       * Format: double
       * @description Share of the wanted speed that the axes allow, where they slow it down.
       */
      braked_to?: number | null;
      /**
       * Format: double
       * @description Largest deviation of the blocks on the flank.
       */
      chords_um: number;
      /** @description Feed z_V2 or worm position v_zS from where to where, run-in and run-out included. */
      driven_mm: [number, number];
      /**
       * Format: double
       * @description Time of one drive.
       */
      duration_s: number;
      /** @description Its name. */
      name: string;
      /**
       * Format: double
       * @description What the digits may add.
       */
      rounding_um: number;
      /**
       * Format: double
       * @description Speed of the feed or the worm position; of lines the least speed along one.
       */
      speed_mm_per_s: number;
    };
    /** @description A pass. */
    PassResult2: {
      /** @description Steps of the choice; empty where the job names the variables. */
      choice: components["schemas"]["ChoiceStep"][];
      /** @description Methods beside each other; empty unless the job asks. */
      compared: components["schemas"]["MethodResult"][];
      /** @description Whether the fit settled. */
      converged: boolean;
      /** @description Flanks ground together. */
      flanks: string[];
      /**
       * Format: double
       * @description Largest |m - f| on it.
       */
      largest_um: number;
      /** @description Method whose values were taken. */
      method: string;
      /**
       * Format: uint
       * @description Rounds of all parts.
       */
      rounds: number;
      /** @description Singular values of the equilibrated matrix, first and last round. */
      singular_values: number[][];
      /**
       * Format: uint
       * @description Parts in which the target was stepped up.
       */
      steps: number;
      /** @description The free variables with their values, mm (gA: rad). */
      variables: components["schemas"]["VariableValue"][];
      /** @description Record of the rounds, weighted rms before each. */
      weighted_rms_by_round_um: number[];
      /**
       * Format: double
       * @description Weighted root mean square of m - f on the grid of the fit.
       */
      weighted_rms_um: number;
    };
    /** @description A contact pattern on the active flank: 0 % at root and toe, 100 % at tip and heel. */
    PatternResult: {
      /**
       * Format: double
       * @description Covered share of the flank.
       */
      area_percent: number;
      /**
       * Format: double
       * @description Centre over the height.
       */
      centre_height_percent: number;
      /**
       * Format: double
       * @description Centre along the tooth.
       */
      centre_length_percent: number;
      /** @description From where to where over the height. */
      height_percent: [number, number];
      /** @description From where to where along the tooth. */
      length_percent: [number, number];
    };
    /** @description A law or a profile in pieces of third degree. */
    Pieces: {
      /** @description Ends of the pieces over z_V2, for a profile over w, mm, ascending: one more than pieces. Beyond both ends it goes on straight. */
      breaks_mm: number[];
      /** @description Per piece the coefficients of (z_V2 - first end)^k, or of w, k = 0..3, in the unit of the key per mm^k. */
      coefficients: number[][];
    };
    /** @description Pitches of a flank. */
    PitchInspectionResult: {
      /**
       * Format: double
       * @description F_p.
       */
      Fp_um: number;
      /**
       * Format: double
       * @description F_pk and its k.
       */
      Fpk_um: number;
      /**
       * Format: double
       * @description R_p.
       */
      Rp_um: number;
      /** @description F_p of every tooth against the last. */
      cumulative_um: number[];
      /**
       * Format: double
       * @description f_p.
       */
      fp_um: number;
      /**
       * Format: double
       * @description f_u.
       */
      fu_um: number;
      /**
       * Format: uint
       * @description k.
       */
      sector_pitches: number;
    };
    /** @description Pitch, thickness, tooth centres; null for teeth without a switch. */
    PitchResult: {
      /** @description Centre of every tooth at the middle track. */
      centre_deg: (number | null)[];
      /** @description F_p,k of every tooth. */
      cumulative_um: (number | null)[];
      /**
       * Format: double
       * @description And where it is greatest.
       */
      first_harmonic_deg: number;
      /**
       * Format: double
       * @description First harmonic of the tooth centres: amplitude.
       */
      first_harmonic_um: number;
      /**
       * Format: double
       * @description f_p,max; as F_p and the first harmonic without outlier teeth.
       */
      largest_single_um: number;
      /** @description f_p,k of every tooth. */
      single_um: (number | null)[];
      /** @description Deviation of every tooth's thickness. */
      thickness_um: (number | null)[];
      /**
       * Format: double
       * @description F_p.
       */
      total_um: number;
    };
    /** @description A plan for one diameter. */
    PlanOfLife: {
      /**
       * Format: double
       * @description Centre distance of worm and gear.
       */
      centre_distance_mm: number;
      /**
       * Format: double
       * @description Crossed-axes angle of worm and gear.
       */
      crossed_axes_angle_deg: number;
      /**
       * Format: double
       * @description Largest deviation from the target by the referee, normal, of the flank that has more.
       */
      deviation_um: number;
      /**
       * Format: double
       * @description Diagonal ratio.
       */
      diagonal_ratio: number;
      /** @description Corrections of dressing in the middle of the stroke, of each flank; null for a flank that is not dressed. */
      dressing: components["schemas"]["Sides7"];
      /**
       * Format: double
       * @description Least determinant ratio of the envelope.
       */
      least_determinant_ratio: number;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description Settings of machine and dresser, for `[settings]` of a job with this worm. */
      settings: components["schemas"]["Settings"];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /**
       * Format: double
       * @description Length of the worm that is used.
       */
      used_width_mm: number;
      /**
       * Format: double
       * @description Pitch diameter of the worm.
       */
      worm_pitch_diameter_mm: number;
      /**
       * Format: double
       * @description Speed of the worm for the cutting speed of the job.
       */
      worm_speed_rpm: number;
    };
    /** @description How the space between scattered points is filled. */
    PointMethod: "linear" | "spline";
    /** @description A plan without its referee. */
    Preview: {
      /** @description Flanks that are ground. */
      flanks: {
        [key: string]: components["schemas"]["PreviewFlank"];
      };
      /** @description Process. */
      process: string;
      /** @description Settings, as in the result of a plan. */
      settings: Json;
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um: number;
      /** @description Warnings. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description A plan without its referee. */
    PreviewAnswer: components["schemas"]["Preview"] & {
      /** @description Charts by name, SVG. */
      charts: {
        [key: string]: string;
      };
      /**
       * Format: double
       * @description How long it took.
       */
      milliseconds: number;
    };
    /** @description A flank as planned. */
    PreviewFlank: {
      /**
       * Format: double
       * @description Largest |planned - target|.
       */
      max_deviation_um: number;
      /** @description Characteristics of the planned flank. */
      planned_characteristics: components["schemas"]["CharacteristicsUm"];
      /** @description Exact contact with the tool as dressed, normal. */
      planned_um: number[][];
      /**
       * Format: double
       * @description Root mean square of planned - target.
       */
      rms_deviation_um: number;
      /** @description Characteristics of the target. */
      target_characteristics: components["schemas"]["CharacteristicsUm"];
      /** @description Target, normal, `[profile][helix]`. */
      target_um: number[][];
      /** @description Lengths of roll of the grid. */
      w_mm: number[];
      /** @description Axial positions of the grid. */
      z_mm: number[];
    };
    /** @description A plan without its referee is wanted. */
    PreviewRequest: {
      /** @description Charts: `target`, `planned`, `deviation`, `sections`, `motions`. */
      charts?: string[];
      /** @description The job. */
      job: components["schemas"]["Job"];
    };
    /** @description A printed value. */
    PrintedResult: {
      /**
       * Format: double
       * @description As evaluated.
       */
      evaluated_um: number;
      /** @description Which. */
      name: string;
      /**
       * Format: double
       * @description As printed.
       */
      printed_um: number;
    };
    /** @description The machined workpiece under a probe in the tool spindle. */
    ProbeResult: {
      /** @description Change of the setting beside the one that the tool asked for. */
      correction: components["schemas"]["CorrectionResult2"];
      /** @description Profiles, by flank. */
      flanks: {
        [key: string]: components["schemas"]["ProbedFlankResult"];
      };
      /**
       * Format: double
       * @description Greatest difference between what the change promises and what it does under the referee, without the noise of the probe.
       */
      model_difference_um?: number | null;
      /** @description Whether the measurement is simulated; else its values were read. */
      simulated: boolean;
    };
    /** @description Profiles of one flank. */
    ProbedFlankResult: {
      /**
       * Format: double
       * @description The same as the correction leaves it.
       */
      corrected_largest_um: number;
      /**
       * Format: double
       * @description The same under the referee; absent for a real workpiece.
       */
      corrected_simulated_um?: number | null;
      /** @description Of every tooth space: length of roll, deviation from the target, and what the correction leaves of it, mm and um. */
      gaps: {
        [key: string]: [number, number, number][];
      };
      /**
       * Format: double
       * @description Largest deviation from the target.
       */
      largest_um: number;
    };
    /** @description A profile of the workpiece that a probe scans. */
    ProbedProfileResult: {
      /** @description Flank. */
      flank: string;
      /**
       * Format: uint
       * @description Tooth space, from 0.
       */
      gap: number;
      /**
       * Format: uint
       * @description Places of the scan.
       */
      places: number;
    };
    /** @description A process. */
    ProcessSummary: {
      /** @description Its word in a job. */
      name: string;
      /** @description Its name for people. */
      title: string;
    };
    /** @description A dressed profile. The points belong to equidistant parameters of the dresser's profile, the same in all curves. */
    ProfileCurve: {
      /** @description Worm z of the contact, with the axial position of `point`. */
      b_mm: number[];
      /** @description Normal modification of the worm, positive = material left. */
      f_n_um: number[];
      /** @description Bodies and crowning. */
      name: string;
      /** @description Figures of the correction; absent where it cannot be made. */
      point: components["schemas"]["CrowningPoint"] | null;
      /** @description Radius of the dresser. */
      r_A_mm: number[];
      /** @description Why there is no curve. */
      refused: components["schemas"]["Refused"] | null;
      /** @description How far the point on the worm lies from the one that its dresser radius was made for. */
      shift_mm: number[];
      /** @description Length of roll on the worm. */
      w_mm: number[];
    };
    /** @description Profile of the edges. */
    ProfileResult: {
      /**
       * Format: double
       * @description D.
       */
      band_um: number;
      /** @description Compensation curve: coefficients of 1, x, x^2, ... */
      curve_um: {
        [key: string]: number[];
      };
      /** @description Teeth outside the band. */
      out_of_band: components["schemas"]["ToothOnFlank"][];
      /** @description Mean of every track over the whole teeth, by flank. */
      track_mean_um: {
        [key: string]: number[];
      };
      /**
       * Format: double
       * @description Limit of wear.
       */
      wear_limit_um: number;
      /** @description Whether a flank is worn. */
      worn: {
        [key: string]: boolean;
      };
    };
    /** @description Something wrong in a text. */
    ProgramFault: {
      /**
       * Format: double
       * @description How deep or how high.
       */
      amount_mm?: number | null;
      /**
       * Format: uint
       * @description Number of the block, from 1; where nothing is milled that of the nearest block.
       */
      block: number;
      /** @description Stable code. */
      code: string;
      /** @description Where, in coordinates of the workpiece. */
      place_mm: [number, number, number];
      /**
       * Format: uint
       * @description Number of the space, from 1.
       */
      space?: number | null;
      /** @description The surface. */
      surface?: string | null;
      /** @description What, with block and place. */
      text: string;
      /** @description What helps. */
      way_out: string;
    };
    /** @description One operation of a program, over all spaces. */
    ProgramOperation: {
      /**
       * Format: uint
       * @description Blocks that move.
       */
      blocks: number;
      /**
       * Format: double
       * @description Time in the material and towards it.
       */
      cutting_s: number;
      /** @description What determines the time of how many cuts: "feed" or the name of an axis. */
      limited_by: {
        [key: string]: number;
      };
      /** @description What it does. */
      name: string;
      /**
       * Format: double
       * @description Time of the first space alone.
       */
      one_space_s: number;
      /**
       * Format: double
       * @description Time of all other blocks.
       */
      rapid_s: number;
      /** @description Travel of both rotary axes, links included; the axis next to the workpiece first. */
      rotary_travel_deg: [number, number];
      /**
       * Format: uint32
       * @description Number of the tool.
       */
      tool: number;
      /**
       * Format: uint
       * @description Links on which an axis is turned back or changes its solution.
       */
      turned_back: number;
    };
    /** @description A program to be followed on a machine. */
    ProgramRequest: {
      job?: null | components["schemas"]["Job"];
      /** @description A machine of the program, e.g. `machines/eight-axis.toml`, or the name of a file of the job. */
      machine: string;
      /** @description Its name. */
      name: string;
      /** @description The HAL netlist of a LinuxCNC program whose gears are in one. */
      netlist?: string | null;
      /** @description Its text. */
      text: string;
    };
    /** @description One program. */
    ProgramResult: {
      /** @description Axes. */
      axes: components["schemas"]["AxisResult"][];
      /**
       * Format: uint
       * @description Blocks that move axes.
       */
      blocks: number;
      /** @description Control. */
      control: string;
      /**
       * Format: double
       * @description Time of the whole program, ramps included.
       */
      duration_s: number;
      /** @description Path below the directory of the run. */
      file: string;
      /** @description "dressing" or "grinding". */
      job: string;
      /** @description The flank of the worm that a program dresses line by line; absent for others. */
      lines_of_flank?: string | null;
      /** @description Passes. */
      passes: components["schemas"]["PassResult"][];
    };
    /** @description One program. */
    ProgramResult2: {
      /**
       * Format: uint
       * @description Blocks that move.
       */
      blocks: number;
      /** @description Control. */
      control: string;
      /**
       * Format: double
       * @description Time of the whole program, all spaces; changes of tools are not in it.
       */
      duration_s: number;
      /** @description Path below the directory of the run. */
      file: string;
      /** @description How the workpiece is tilted on the table beside what the job's mount says, where the pole asks for it. */
      mount_tilt?: components["schemas"]["MountTilt"] | null;
      /**
       * Format: double
       * @description Time of the first space alone.
       */
      one_space_s: number;
      /** @description Operations in their order, over all spaces. */
      operations: components["schemas"]["ProgramOperation"][];
      /** @description What the text does to the whole part. */
      part: components["schemas"]["PartProof"];
      /**
       * Format: double
       * @description What rounding and straight blocks explain of it.
       */
      proof_allowed_um: number;
      /**
       * Format: double
       * @description Largest difference of a ray milled as the text says from the planned one.
       */
      proof_difference_um: number;
      /** @description What the axes do that is worth knowing: solutions, turning back, the pole. */
      remarks: string[];
      /**
       * Format: double
       * @description What rounding of the numbers does at most.
       */
      rounding_um: number;
      /**
       * Format: double
       * @description What straight blocks of the axes do to the tip at most.
       */
      straight_blocks_um: number;
    };
    /** @description The programs of a run. */
    ProgramsResult: {
      /** @description How far the worm stays clear of the workpiece; absent where it was not checked. */
      clearance?: components["schemas"]["ClearanceResult"] | null;
      /** @description Name of the machine. */
      machine: string;
      /** @description The programs. */
      programs: components["schemas"]["ProgramResult"][];
      /** @description What was proven from their texts. */
      proofs: components["schemas"]["ProofResult"][];
      /** @description Whether the workpiece is clamped with its +z into the -z of its spindle. */
      work_reversed: boolean;
      /** @description Which part of the worm every grinding pass uses, read from the texts; empty where all passes use the area of the plan. */
      worm_use?: components["schemas"]["WormUse"][];
    };
    /** @description What the referee made of a control's texts. */
    ProofResult: {
      /**
       * Format: double
       * @description Difference from the run's own flank that blocks and digits explain.
       */
      allowed_difference_um: number;
      /**
       * Format: uint
       * @description Finishing areas of the worm: each is dressed, and ground with by a program of its own.
       */
      areas: number;
      /**
       * Format: double
       * @description Deviation of straight blocks, dressing and grinding added up.
       */
      chords_um: number;
      /** @description Controls whose texts say the same. */
      controls: string[];
      /** @description By flank. */
      flanks: {
        [key: string]: components["schemas"]["FlankProof"];
      };
      /**
       * Format: uint
       * @description Strokes of a pass between which the workpiece is indexed.
       */
      index_strokes: number;
      /** @description Flanks of the worm that are dressed line by line; empty for other worms. */
      lines?: components["schemas"]["LinesProof"][];
      /** @description What the proof says nothing of. */
      not_covered: string[];
      /**
       * Format: double
       * @description What the digits may add, dressing and grinding added up.
       */
      rounding_um: number;
      /** @description In words. */
      statement: string;
      /** @description Rays on each flank of each thread, over the profile and along the worm; a flank that is dressed by lines has its own. */
      thread_rays: number[];
      /** @description Threads whose dressing was counted and put under rays; empty for a worm that no program dresses. */
      threads: components["schemas"]["ThreadProof"][];
      /**
       * Format: uint32
       * @description Threads of the worm, those left out included.
       */
      threads_of_worm: number;
      /**
       * Format: uint32
       * @description Tooth spaces that the finishing strokes grind.
       */
      tooth_spaces: number;
    };
    /** @description What the referee says of a correction, on the grid, about the mean. */
    ProofResult2: {
      /** @description Measured deviation with the referee's change. */
      after: components["schemas"]["DifferenceResult"];
      /** @description Measured deviation now. */
      before: components["schemas"]["DifferenceResult"];
      /**
       * Format: double
       * @description Largest difference of first order and referee.
       */
      first_order_off_um: number;
    };
    /** @description Counters at the end of the run. */
    PulseFigures: {
      /**
       * Format: uint64
       * @description Inserted at the clock's pace (K).
       */
      corrections: number;
      /**
       * Format: uint64
       * @description Inserted at the spacing of the interval before (Z).
       */
      intermediates: number;
      /**
       * Format: int64
       * @description Sum of the signs of all.
       */
      net_pulses: number;
      /**
       * Format: int64
       * @description Sum of the signs of those of the scale.
       */
      net_references: number;
      /**
       * Format: uint64
       * @description Alarm: intervals that ended, with their own sense, while corrections were still owed.
       */
      overruns: number;
      /**
       * Format: uint64
       * @description Parts of rotation turned, either way.
       */
      parts_turned: number;
      /**
       * Format: int64
       * @description Corrections still owed at the end, with their sign.
       */
      pending_corrections: number;
      /**
       * Format: uint64
       * @description All pulses of the interpolator.
       */
      pulses: number;
      /**
       * Format: uint64
       * @description Of the scale (R).
       */
      references: number;
      /**
       * Format: double
       * @description Additional rotation as an angle.
       */
      rotation_deg: number;
      /**
       * Format: int64
       * @description The rest of it in parts 1/P of a workpiece pulse, 0 to P - 1.
       */
      rotation_rest_parts: number;
      /**
       * Format: int64
       * @description Additional rotation in whole workpiece pulses, rounded down.
       */
      rotation_workpiece_pulses: number;
      /**
       * Format: uint64
       * @description Alarm: intervals of one sense with fewer ticks than pulses.
       */
      too_fast: number;
    };
    /** @description How busy the server is. */
    Queue: {
      /** @description Runs that may wait. */
      most: number;
      /** @description Runs under way. */
      running: number;
      /** @description Runs that wait. */
      waiting: number;
    };
    /** @description What radial feed makes of the same target. */
    RadialFeedResult: {
      /**
       * Format: double
       * @description Twist S that it leaves, normal, material removed; closed form of first order.
       */
      closed_twist_normal_um: number;
      /** @description m - f on the grid of the result. */
      deviation_um?: number[][] | null;
      /**
       * Format: double
       * @description Helix crowning, normal, material removed.
       */
      lead_crowning_normal_um: number;
      /**
       * Format: double
       * @description Largest |m - f| with the profile in the dresser and the best parabola of the centre distance.
       */
      max_deviation_um?: number | null;
      /** @description Why there is no flank, if so. */
      refused?: components["schemas"]["Remark"] | null;
      /**
       * Format: double
       * @description The same by the exact contact of a plain worm; absent where the flank is undercut.
       */
      twist_normal_um?: number | null;
    };
    /** @description Least and greatest of an error. */
    RangeUm: {
      /**
       * Format: double
       * @description Greatest.
       */
      greatest_um: number;
      /**
       * Format: double
       * @description Least.
       */
      least_um: number;
    };
    /** @description Q'_w over flank and feed, the largest over the tooth spaces. */
    RateMapResult: {
      /** @description Feeds z_V2, rising. */
      feed_mm: number[];
      /** @description Each flank that the stroke grinds; null for the other. */
      flanks: components["schemas"]["Sides6"];
    };
    /** @description An edge. */
    RecordedEdge: {
      /** @description Flank of the workpiece that it makes. */
      flank: components["schemas"]["Flank"];
      /**
       * Format: uint32
       * @description Its tooth, from 0.
       */
      tooth: number;
    };
    /** @description Mean profile of all edges of a flank. */
    RecordedFlank: {
      /** @description Places x = -1..1 of the tracks. */
      places: number[];
      /**
       * Format: double
       * @description Standard deviation of such a mean, um.
       */
      sigma_um: number;
      /** @description Mean deviation over the teeth at each, um; > 0 is material beyond the nominal edge. */
      track_mean_um: number[];
    };
    /** @description Profiles of both flanks. */
    RecordedFlanks: {
      /** @description Edges that make left flanks of the workpiece. */
      left: components["schemas"]["RecordedFlank"];
      /** @description Edges that make right flanks. */
      right: components["schemas"]["RecordedFlank"];
    };
    /** @description How the tool was mounted. */
    RecordedMounting: {
      /** @description Eccentricity in x and y of the spindle, um. */
      eccentricity_um: [number, number];
      /** @description Wobble about x and y of the spindle, urad. */
      wobble_urad: [number, number];
    };
    /** @description Pitch of the tooth centres. */
    RecordedPitch: {
      /**
       * Format: double
       * @description f_p,max, um.
       */
      largest_single_um: number;
      /**
       * Format: double
       * @description F_p, um.
       */
      total_um: number;
    };
    /** @description One stretch that is recorded. Angles are those of the tool spindle as the control counts them. */
    RecordingResult: {
      /** @description "left" or "right" flank of the workpiece. */
      flank: string;
      /**
       * Format: double
       * @description Where the switches that count begin.
       */
      from_deg: number;
      /**
       * Format: double
       * @description Where tooth 0 of the ideal tool switches.
       */
      nominal_deg: number;
      /** @description "positive" or "negative" sense of the tool. */
      sense: string;
      /**
       * Format: double
       * @description Where they end, one pitch beyond the whole turns.
       */
      to_deg: number;
      /**
       * Format: uint
       * @description Track, from 1.
       */
      track: number;
    };
    /** @description The direction in which amounts are measured: f_n = f_t cos(beta_b). */
    Reference: "transverse" | "normal";
    /** @description Why a combination is not allowed or has no figures. */
    Refused: {
      /** @description Stable code. */
      code: string;
      /** @description Why. */
      text: string;
      /** @description What would help. */
      way_out: string;
    };
    /** @description A file that was not evaluated. */
    RefusedFile: {
      /** @description Code of the error. */
      code: string;
      /** @description The file. */
      file: string;
      /** @description The error. */
      message: string;
      /** @description What can be done. */
      way_out: string;
    };
    /** @description A file that was not imported. */
    RefusedFile2: {
      /** @description What would be allowed. */
      allowed: string | null;
      /** @description Stable kebab-case code, e.g. `unknown-key`. */
      code: string;
      /** @description Path of the key, e.g. `target.modifications[1].amount_um`. */
      field: string | null;
      /** @description The file. */
      file: string;
      /** @description The cause in one sentence. */
      message: string;
      /** @description The value as given. */
      value: string | null;
      /** @description What to do about it, in one sentence. */
      way_out: string | null;
    };
    /** @description A statement beside the numbers of a run: a warning, or the reason of a verdict. */
    Remark: {
      /** @description Stable code. */
      code: string;
      /** @description What, with its numbers. */
      text: string;
      /** @description What can be done about it. */
      way_out: string;
    };
    /** @description Stock, strokes, load of the worm, time and cost of a run. */
    RemovalResult: {
      /** @description Cost of a part in the shop's currency; absent without its time or without `technology.cost`. */
      cost_per_part?: components["schemas"]["CostResult"] | null;
      /** @description Cycles within the limits; absent without `technology.limits.Qw_roughing` and `Qw_finishing`, and where none keeps them. */
      cycles?: components["schemas"]["CyclesResult"] | null;
      /** @description The last dressing stroke; absent without `technology.dressing`, and for a worm that is not dressed by a disc in line contact. */
      dressing?: components["schemas"]["DressingFiguresResult"] | null;
      /** @description Figures over the shop's limits. A share above 1 says harder than what the shop calls safe, no more. */
      indicators: components["schemas"]["IndicatorResult"][];
      /** @description Time of a part; absent without programs or without `technology.times`. */
      part_time?: components["schemas"]["PartTimeResult"] | null;
      /** @description Before the first stroke. */
      stock: components["schemas"]["StockResult"];
      /** @description In driving order. */
      strokes: components["schemas"]["StrokeResult"][];
      /** @description The worm over its life; absent without `technology.life`. */
      worm_life?: components["schemas"]["WormLifeResult"] | null;
      /** @description The worm's load; absent without `technology.limits.Vw_finishing`. */
      worm_load?: components["schemas"]["WormLoadResult"] | null;
    };
    /** @description What grinding the tool again has to take off. */
    ResharpeningResult: {
      /**
       * Format: double
       * @description The same along the tool's axis.
       */
      axial_depth_mm: number;
      /** @description Broken edges, each with the depth that takes its chip away. */
      broken: components["schemas"]["BrokenEdge"][];
      /**
       * Format: double
       * @description Depth off the rake faces along their normal: for worn and broken edges.
       */
      depth_mm: number;
      /** @description Teeth that lack a switch: how deep they are broken is not known, and the depth does not count them. */
      not_covered: number[];
      /** @description The same without the broken edges, whose chips then stay. */
      without_broken: components["schemas"]["WithoutBroken"];
    };
    /** @description The document of a result: that of the process, of the study or of the inspection. */
    ResultDocument:
      | components["schemas"]["HandedIn"]
      | components["schemas"]["JobResult"]
      | components["schemas"]["ExploreOutcome"]
      | components["schemas"]["CatalogueOutcome"]
      | components["schemas"]["FreeOutcome"]
      | components["schemas"]["DressingStudyOutcome"]
      | components["schemas"]["WormLifeOutcome"]
      | components["schemas"]["TangentialResult"]
      | components["schemas"]["TangentialExploration"]
      | components["schemas"]["GearboxResult"]
      | components["schemas"]["MillingResult"]
      | components["schemas"]["SkivingResult"]
      | components["schemas"]["GearInspectionResult"]
      | components["schemas"]["BevelInspectionResult"]
      | components["schemas"]["InspectionSeriesResult"]
      | components["schemas"]["BlankStockResult"];
    /** @description A part of the root under rays on its drawn section; > 0 stock, null where no ray is met. */
    RootDeviationResult: {
      /**
       * Format: uint
       * @description Rays at which a cutter digs into the drawn root, deeper than the drawn section is off what is swept.
       */
      gouged: number;
      /**
       * Format: double
       * @description Highest stock: the roof between passes.
       */
      max_um: number | null;
      /**
       * Format: double
       * @description Deepest place below the drawn section (or least stock).
       */
      min_um: number | null;
      /**
       * Format: double
       * @description Largest difference of prediction and rays.
       */
      model_difference_um: number | null;
      /**
       * Format: uint
       * @description Rays that no cutter reaches.
       */
      not_reached: number;
      /** @description Least and greatest prediction: what the passes of the root sweep beside the drawn section. */
      planned_um: [number, number];
      /**
       * Format: uint
       * @description Rays.
       */
      rays: number;
      /**
       * Format: double
       * @description Root mean square.
       */
      rms_um: number | null;
      /** @description Rays that no cutter meets, by reason. */
      unmilled: {
        [key: string]: number;
      };
    };
    /** @description The root section at one column. */
    RootResult: {
      /**
       * Format: double
       * @description Contact height of the pass.
       */
      contact_height_mm: number;
      /**
       * Format: double
       * @description Half distance of the lowest points of both fillets.
       */
      half_width_mm: number;
      /**
       * Format: double
       * @description Lean of the axis.
       */
      lean_deg: number;
      /**
       * Format: double
       * @description Straight piece between active flank and fillet.
       */
      straight_mm: number;
    };
    /** @description Figures of both rotary axes along a row. */
    RotaryFigures: {
      /** @description Least and greatest lean of the cutter's axis into the feed. */
      lean_deg: [number, number];
      /** @description Largest rate. */
      max_rate_deg_per_mm: [number, number];
      /** @description Largest second difference. */
      max_second_deg_per_mm2: [number, number];
      /**
       * Format: double
       * @description Length of the row.
       */
      path_mm: number;
      /** @description How often the axes turn back. */
      reversals: number[];
      /** @description Travel. */
      travel_deg: [number, number];
    };
    /** @description How pulses of the slide become rotation. */
    RotationRate: "exact" | "bresenham" | "binary";
    /** @description One round of measuring and correcting. */
    RoundResult: {
      /** @description Axes of the machine that would explain the measurement, each by itself, the one that explains most first. */
      axes?: components["schemas"]["AxisResult2"][];
      /** @description Axes that could not be asked, with the reason. */
      axes_not_asked?: {
        [key: string]: string;
      };
      /** @description Axes that explain the measurement together, where several explain clearly more than the best of them alone. */
      axes_together?: components["schemas"]["AxesTogether"] | null;
      /** @description Which part of every characteristic the teeth share. */
      characteristics: components["schemas"]["CharacteristicResult"][];
      /** @description The correction; absent where nothing is worth one. */
      correction?: components["schemas"]["CorrectionResult3"] | null;
      /** @description Target, process and measurement on the grid, by flank. */
      flanks: {
        [key: string]: components["schemas"]["MeasuredFlankResult"];
      };
      /** @description Why there is none. */
      no_correction?: string | null;
      /**
       * Format: uint
       * @description Round, from 1.
       */
      round: number;
    };
    /** @description One row. */
    RowResult: {
      /** @description Heights that root, edge and opposite flank allow. */
      allowed_mm?: [number, number];
      /**
       * Format: double
       * @description Greatest angle of the cutter's axis out of its column plane.
       */
      axis_out_of_plane_deg: number;
      /**
       * Format: double
       * @description What straight blocks leave in their middle, < 0 gouge.
       */
      chord_um: number;
      /**
       * Format: double
       * @description Contact height above the cutter's tip.
       */
      contact_height_mm: number;
      /**
       * Format: double
       * @description Least curvature of the gap between cutter and flank.
       */
      opening_per_mm: number;
      /**
       * Format: double
       * @description Greatest angle of the normals out of their column planes.
       */
      out_of_plane_deg: number;
      /**
       * Format: uint
       * @description Number, 0 at the root.
       */
      row: number;
      /**
       * Format: double
       * @description Scallop to the next row; absent above the last one.
       */
      scallop_um?: number | null;
      /**
       * Format: double
       * @description What the row leaves along the axis, or the pitch cone, because of the other half of a double-helical gear; absent where it leaves nothing.
       */
      unmilled_mm?: number | null;
    };
    /** @description A run. */
    Run: components["schemas"]["ListedRun"] & {
      /** @description Charts of the result. */
      charts: components["schemas"]["Chart"][];
      document?: null | components["schemas"]["ResultDocument"];
      failure?: null | components["schemas"]["Failure"];
      /** @description Files of the result. */
      files: components["schemas"]["RunFile"][];
      job?: null | components["schemas"]["Job"];
      /** @description Names of the uploaded measurements. */
      measurements: string[];
      /** @description Whether its bodies can be seen in space. */
      scene: boolean;
    };
    /** @description The number of a run that was begun. */
    RunBegun: {
      /**
       * Format: int64
       * @description Its number.
       */
      id: number;
    };
    /** @description A file of a result. */
    RunFile: {
      /**
       * Format: int64
       * @description Its size.
       */
      bytes: number;
      /** @description Its name, with `/`. */
      name: string;
    };
    /** @description The state of a run. */
    RunState: "queued" | "running" | "done" | "failed" | "cancelled" | "interrupted";
    /** @description The state of a run. */
    RunStateAnswer: {
      /** @description The state. */
      state: components["schemas"]["RunState"];
    };
    /** @description A run in a list. */
    RunSummary: {
      /** @description When it was submitted. */
      created: string;
      /** @description When it has ended. */
      ended?: string | null;
      /**
       * Format: int64
       * @description Its number.
       */
      id: number;
      /** @description What is done. */
      kind: components["schemas"]["Task"];
      /** @description Name of the job. */
      name: string;
      /** @description The state. */
      state: components["schemas"]["RunState"];
      /** @description The verdict of its document. */
      status?: components["schemas"]["Status"] | null;
    };
    /**
     * @description A law over the turn of the tool that answers its run-out, by cosine and sine of each order of phi_1, which is 0 where tooth 0 stands
     *     on the common normal.
     */
    RunoutResult: {
      /**
       * Format: double
       * @description Greatest change of the centre distance.
       */
      centre_distance_amplitude_um: number;
      /** @description Added to the centre distance; empty where it stays. */
      centre_distance_um: [number, number][];
      /**
       * Format: double
       * @description Greatest difference between prediction and referee of any tooth with law and correction, without the noise of readings.
       */
      model_difference_um: number;
      /** @description The same under the referee. */
      simulated_spread_um: [number, number];
      /** @description Greatest range of what the teeth leave on a track, without and with the law, as predicted. */
      spread_um: [number, number];
      /**
       * Format: double
       * @description Greatest change of the workpiece's angle.
       */
      work_angle_amplitude_deg: number;
      /** @description Added to the angle of the workpiece; empty where the coupling stays. */
      work_angle_deg: [number, number][];
    };
    /** @description A place of a scan. */
    ScanPlaceResult: {
      /**
       * Format: double
       * @description A.
       */
      a_deg: number;
      /**
       * Format: double
       * @description B.
       */
      b_deg: number;
      /** @description What it finds on each tooth; empty without a simulated tool. */
      deviation_um?: number[];
      /** @description Flank. */
      flank: string;
      /**
       * Format: double
       * @description Angle between stylus and helix of the flank.
       */
      off_flank_deg: number;
      /**
       * Format: double
       * @description x along the edge.
       */
      place: number;
      /** @description X, Y, Z. */
      position_mm: [number, number, number];
      /**
       * Format: double
       * @description Length of roll.
       */
      w_mm: number;
    };
    /** @description The scan of a stylus. */
    ScanResult: {
      /** @description Places. */
      places: components["schemas"]["ScanPlaceResult"][];
      /** @description Teeth that are scanned. */
      teeth: number[];
    };
    /** @description One edge that is scanned. */
    ScanResult2: {
      /** @description "left" or "right" flank of the workpiece. */
      flank: string;
      /**
       * Format: uint
       * @description Places of the scan.
       */
      places: number;
      /**
       * Format: uint
       * @description Tooth, from 0.
       */
      tooth: number;
    };
    /** @description A result that scatters. */
    ScatterResult: {
      /** @description 95 % of the repetitions lie between these. */
      interval: [number, number];
      /**
       * Format: double
       * @description Mean.
       */
      mean: number;
      /** @description What. */
      name: string;
      /**
       * Format: double
       * @description Standard deviation.
       */
      sigma: number;
      /**
       * Format: double
       * @description The prediction from the readings' own standard deviation; absent where there is none.
       */
      stated_sigma?: number | null;
      /** @description Unit. */
      unit: string;
    };
    /** @description Bodies and how they move. Lengths in mm; coordinates of the scene are those of the room in which the process is described. */
    Scene: {
      /** @description The bodies, each in its own coordinates. */
      bodies: components["schemas"]["Body"][];
      /** @description What happens, one stage after the other. */
      stages: components["schemas"]["Stage"][];
    };
    /** @description What was judged and what was not. */
    Scope: {
      /** @description Items that were judged. */
      judged: components["schemas"]["JudgedItem"][];
      /** @description Items that were not. */
      not_judged: components["schemas"]["UnjudgedItem"][];
    };
    /** @description Derivatives by one variable. */
    SensitivityResult: {
      /** @description Flank. */
      flank: string;
      /** @description Unit of the values: `um/um`, or `um/mrad` for gA. */
      unit: string;
      /** @description dm/dc, `[profile][helix]`. */
      values: number[][];
      /** @description Variable. */
      variable: string;
      /** @description Lengths of roll. */
      w_mm: number[];
      /** @description Axial positions. */
      z_mm: number[];
    };
    /** @description Capability indices. */
    SeriesCapability: {
      /**
       * Format: double
       * @description By s of all parts (Pp where the process is not in control).
       */
      Cp?: number | null;
      /**
       * Format: double
       * @description By sigma_MR: without drifts and jumps.
       */
      Cp_MR?: number | null;
      /** @description 95 percent. */
      Cp_interval_95?: [number, number];
      /**
       * Format: double
       * @description By s of all parts (Ppk where the process is not in control).
       */
      Cpk: number;
      /**
       * Format: double
       * @description By sigma_MR.
       */
      Cpk_MR?: number | null;
      /** @description 95 percent. */
      Cpk_interval_95?: [number, number];
      /**
       * Format: double
       * @description Lower bound of 95 percent.
       */
      Cpk_lower_95?: number | null;
      /** @description Only one limit: the index of its side. */
      one_sided: boolean;
      /**
       * Format: double
       * @description Share of parts outside the limits for a normal law, ppm.
       */
      outside_ppm?: number | null;
    };
    /** @description A characteristic over the parts that have it. */
    SeriesCharacteristic: {
      /** @description Capability; absent without limits, or where all parts are equal. */
      capability?: components["schemas"]["SeriesCapability"] | null;
      /** @description Control limits of individual values. */
      control_limits?: [number, number];
      /** @description What it is: `fHa.left.mean`. */
      key: string;
      /**
       * Format: double
       * @description Lower limit.
       */
      lower_limit?: number | null;
      /**
       * Format: double
       * @description Greatest value.
       */
      max?: number;
      /**
       * Format: double
       * @description Mean.
       */
      mean?: number;
      /** @description With 95 percent certainty the mean of the process lies between these. */
      mean_interval_95?: [number, number];
      /**
       * Format: double
       * @description Least value.
       */
      min?: number;
      /** @description Mean distance of neighbouring parts, and its upper control limit. */
      moving_range?: [number, number];
      /**
       * Format: uint
       * @description Parts that have it.
       */
      n: number;
      /** @description Numbers of these parts. */
      parts: number[];
      /**
       * Format: double
       * @description Greatest less least.
       */
      range?: number;
      /** @description Why there are no figures, or no capability; what was left out; what to know. */
      remarks: string[];
      /**
       * Format: double
       * @description Standard deviation.
       */
      s?: number;
      /** @description With 95 percent certainty that of the process lies between these. */
      s_interval_95?: [number, number];
      /**
       * Format: double
       * @description Standard deviation by the distances of neighbouring parts.
       */
      sigma_MR?: number;
      /** @description What the rules for special causes find. */
      special_causes?: components["schemas"]["SeriesFinding"][];
      /** @description Trend; absent for fewer than three parts. */
      trend?: components["schemas"]["SeriesTrend"] | null;
      /** @description Unit of all its figures. */
      unit: string;
      /**
       * Format: double
       * @description Upper limit.
       */
      upper_limit?: number | null;
      /** @description Their values. */
      values: number[];
    };
    /** @description A stretch of parts that a rule has found. */
    SeriesFinding: {
      /**
       * Format: uint
       * @description Number of the first part.
       */
      first: number;
      /**
       * Format: uint
       * @description Number of the last part.
       */
      last: number;
      /** @description What it says, with its source. */
      meaning: string;
      /** @description Code of the rule. */
      rule: string;
    };
    /** @description Parts of one drawing. */
    SeriesGroupResult: {
      /** @description Characteristics. */
      characteristics: components["schemas"]["SeriesCharacteristic"][];
      /** @description What the parts are ordered by: `time` or `name`. */
      ordered_by: string;
      /** @description Parts in their order. */
      parts: components["schemas"]["SeriesPartResult"][];
      /** @description The drawing, else the name of the gear, else teeth and module. */
      series: string;
    };
    /** @description A part. */
    SeriesPartResult: {
      /**
       * Format: int32
       * @description Class of ISO 1328-1 that it reaches.
       */
      class?: number | null;
      /** @description Characteristics beyond their limits. */
      exceeded: string[];
      /** @description Its file. */
      file: string;
      /** @description What the class needs and the file does not hold. */
      not_judged?: string[];
      /**
       * Format: uint
       * @description Its number in the series, from 1.
       */
      number: number;
      /** @description Its number or name. */
      part: string;
      /** @description Path of its sheet below the directory of the series. */
      sheet?: string | null;
      /** @description When it was measured. */
      time?: string | null;
      /** @description Doubts of reading and evaluation. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description A series and how much there is of it. */
    SeriesSummary: {
      /** @description Date of its first part. */
      first: string | null;
      /** @description Date of its last part. */
      last: string | null;
      /**
       * Format: uint64
       * @description Number of parts.
       */
      parts: number;
      /** @description The series. */
      series: string;
    };
    /** @description The straight course over the number of the part. */
    SeriesTrend: {
      /** @description 95 percent. */
      interval_95: [number, number];
      /**
       * Format: double
       * @description Probability of such a slope by chance; absent where all parts are equal.
       */
      p?: number | null;
      /**
       * Format: double
       * @description Change from part to part.
       */
      per_part: number;
      /**
       * Format: double
       * @description Its standard error.
       */
      standard_error: number;
      /**
       * Format: double
       * @description Value of the line at part number 0.
       */
      start: number;
    };
    /** @description An error over time, its mean removed as centring in the machine does. */
    ServoErrorResult: {
      /**
       * Format: double
       * @description The mean that was removed.
       */
      mean_um: number;
      /**
       * Format: double
       * @description Largest amount.
       */
      peak_um: number;
      /**
       * Format: double
       * @description Root of the mean square.
       */
      rms_um: number;
    };
    /** @description What the servo leaves. */
    ServoResult: {
      /** @description Answer to disturbing torques. */
      disturbance_response: components["schemas"]["FlankResponseResult"][];
      /**
       * Format: double
       * @description Greatest torque of the motor.
       */
      greatest_torque_n_m: number;
      /**
       * Format: double
       * @description Largest modulus of the poles of the loop, below 1.
       */
      largest_pole: number;
      /**
       * Format: uint64
       * @description Samples in the figures.
       */
      samples: number;
      /** @description Setpoint of the gearbox less ideal angle, at the flank. */
      setpoint: components["schemas"]["ServoErrorResult"];
      /**
       * Format: double
       * @description Time for which the loop settled before the motion, the worm turning and the slide at rest; in none of the figures.
       */
      settling_s: number;
      /**
       * Format: double
       * @description Share of samples with the torque at its limit.
       */
      torque_limited_share: number;
      /** @description Workpiece less ideal angle, at the flank. */
      workpiece: components["schemas"]["ServoErrorResult"];
    };
    /** @description Scale, clock, interpolation and encoder. */
    SetUpResult: {
      /**
       * Format: double
       * @description Acceleration, at the flank.
       */
      acceleration_um: number;
      /**
       * Format: double
       * @description Clock.
       */
      clock_hz: number;
      /**
       * Format: double
       * @description Clock: period memory and synchroniser, at the flank.
       */
      clock_um: number;
      /**
       * Format: double
       * @description What it costs.
       */
      cost: number;
      /** @description Whether it is accurate and fast enough. */
      feasible: boolean;
      /**
       * Format: double
       * @description Sum of all parts; absent as `rounding_um`.
       */
      flank_um?: number | null;
      /**
       * Format: double
       * @description Greatest speed.
       */
      greatest_speed_mm_per_min: number;
      /**
       * Format: double
       * @description Errors of what is measured, at the flank; 0 without `[errors]`.
       */
      measuring_um: number;
      /**
       * Format: uint32
       * @description P.
       */
      pulses_per_interval: number;
      /**
       * Format: double
       * @description Scale of the feed slide.
       */
      pulses_per_metre: number;
      /**
       * Format: uint32
       * @description Encoder of the workpiece.
       */
      pulses_per_revolution: number;
      /**
       * Format: double
       * @description Staircase of the interpolator, at the flank.
       */
      quantisation_um: number;
      /**
       * Format: uint
       * @description Place in the ranking, from 1.
       */
      rank: number;
      /** @description Why not. */
      refused?: string | null;
      /**
       * Format: double
       * @description Half a part of a workpiece pulse, at the flank.
       */
      resolution_um: number;
      /**
       * Format: double
       * @description Counting and rounding of the rotation, at the flank; absent if the coupling cannot be made.
       */
      rounding_um?: number | null;
    };
    /** @description Settings of grinding and dressing. */
    Settings: {
      /** @description Delta_d over z_V2, um and um/mm^k, in place of `delta_d_um`, where it is no polynomial. */
      delta_d_pieces?: components["schemas"]["Pieces"] | null;
      /**
       * @description Coefficients of Delta_d over z_V2, um/mm^k, k = 0, 1, ...
       * @default []
       */
      delta_d_um: number[];
      /** @description Delta_phi_2 over z_V2, urad and urad/mm^k, in place of `delta_phi_2_urad`. */
      delta_phi_2_pieces?: components["schemas"]["Pieces"] | null;
      /**
       * @description Coefficients of Delta_phi_2 over z_V2, urad/mm^k, k = 0, 1, ...
       * @default []
       */
      delta_phi_2_urad: number[];
      /**
       * Format: double
       * @description Diagonal ratio K of z_V1 = K z_V2 + z_V01; 0 = no shift.
       */
      diagonal_ratio: number;
      /** @description Dressing of the left worm flank; absent: nominal. */
      left?: components["schemas"]["FlankSettings"] | null;
      /** @description Dressing of the right worm flank; absent: nominal. */
      right?: components["schemas"]["FlankSettings"] | null;
      /** @description z_V1 over z_V2 in place of ratio and origin, for a ratio that changes over the feed. */
      shift?: components["schemas"]["Pieces"] | null;
      /**
       * Format: double
       * @description z_V01, mm: tool shift at z_V2 = 0.
       * @default 0
       */
      shift_origin_mm: number;
      /** @description Strokes in which the worm flanks are dressed, with `[dressing.strokes]`, in place of `left` and `right`. */
      strokes?: components["schemas"]["StrokeTables"];
      /** @description Flanks of a tool that is not dressed; absent: unmodified, or as `[worm] modifications` says. */
      tool?: components["schemas"]["ToolTables"];
    };
    /** @description Settings, with how the diagonal ratio was found. */
    SettingsResult: {
      /** @description Candidates judged. */
      candidates: components["schemas"]["CandidateResult"][];
      /**
       * Format: double
       * @description Centre distance of worm and workpiece.
       */
      centre_distance_mm: number;
      /**
       * Format: double
       * @description Crossed-axes angle of worm and workpiece.
       */
      crossed_axes_angle_deg: number;
      /** @description Delta_d over z_V2, um and um/mm^k, in place of `delta_d_um`, where it is no polynomial. */
      delta_d_pieces?: components["schemas"]["Pieces"] | null;
      /**
       * @description Coefficients of Delta_d over z_V2, um/mm^k, k = 0, 1, ...
       * @default []
       */
      delta_d_um: number[];
      /** @description Delta_phi_2 over z_V2, urad and urad/mm^k, in place of `delta_phi_2_urad`. */
      delta_phi_2_pieces?: components["schemas"]["Pieces"] | null;
      /**
       * @description Coefficients of Delta_phi_2 over z_V2, urad/mm^k, k = 0, 1, ...
       * @default []
       */
      delta_phi_2_urad: number[];
      /** @description Ratios that lay the tool's lines onto reliefs and waves of the target, per flank; absent where there are none. */
      demanded_ratios?: components["schemas"]["Sides2"] | null;
      /**
       * Format: double
       * @description Diagonal ratio K of z_V1 = K z_V2 + z_V01; 0 = no shift.
       */
      diagonal_ratio: number;
      /** @description Why this diagonal ratio; absent for a simulation. */
      diagonal_ratio_reason?: string | null;
      /**
       * Format: double
       * @description Nominal centre distance of dresser and worm; absent for a tool that is not dressed.
       */
      dressing_centre_distance_mm?: number | null;
      /** @description Conditions of dressing with what the motion leaves of them; absent where all of them are met exactly. */
      dressing_conditions?: components["schemas"]["ConditionResult"][];
      /**
       * Format: double
       * @description Nominal crossing angle of dresser and worm.
       */
      dressing_crossing_angle_deg?: number | null;
      /** @description Feed stroke z_V2, overrun included. */
      feed_stroke_mm: [number, number];
      /** @description Strokes of a pass, where threads are inactive. */
      index_strokes?: components["schemas"]["StrokePlan"] | null;
      /** @description Widest tip land of the dresser that clears the other flank while the left or right one is dressed. */
      largest_tip_land_mm?: components["schemas"]["Sides"] | null;
      /** @description Ratio at which the worm needs no part linear in w, per flank. */
      lead_correction_ratio?: components["schemas"]["Sides"] | null;
      /** @description Dressing of the left worm flank; absent: nominal. */
      left?: components["schemas"]["FlankSettings"] | null;
      /** @description Areas on the tool; absent for conical bodies. */
      partition?: components["schemas"]["Partition"] | null;
      /** @description Place of the profile crowning. */
      profile_crowning_by?: string | null;
      /** @description Dressing of the right worm flank; absent: nominal. */
      right?: components["schemas"]["FlankSettings"] | null;
      /** @description z_V1 over z_V2 in place of ratio and origin, for a ratio that changes over the feed. */
      shift?: components["schemas"]["Pieces"] | null;
      /**
       * Format: double
       * @description z_V01, mm: tool shift at z_V2 = 0.
       * @default 0
       */
      shift_origin_mm: number;
      /** @description Strokes in which the worm flanks are dressed, with `[dressing.strokes]`, in place of `left` and `right`. */
      strokes?: components["schemas"]["StrokeTables"];
      /** @description Flanks of a tool that is not dressed; absent: unmodified, or as `[worm] modifications` says. */
      tool?: components["schemas"]["ToolTables"];
      /**
       * Format: double
       * @description Length of that part.
       */
      worm_length_mm: number;
      /** @description Part of the worm that is used, z_1. */
      worm_occupation_mm: [number, number];
      /**
       * Format: double
       * @description Pitch diameter of the worm.
       */
      worm_pitch_diameter_mm: number;
      /**
       * Format: double
       * @description Root diameter of the worm.
       */
      worm_root_diameter_mm: number;
    };
    /** @description Settings with what follows from the bodies. */
    SettingsResult2: {
      /** @description What holds for both flanks unless the table of a flank says otherwise. */
      both?: components["schemas"]["FlankValues"] | null;
      /**
       * Format: double
       * @description Centre distance of worm and gear.
       */
      centre_distance_mm: number;
      /** @description FT0* per flank. */
      contact_shift_offset_mm: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Crossed-axes angle of worm and gear.
       */
      crossed_axes_angle_deg: number;
      /**
       * Format: double
       * @description Pitch diameter of the dresser.
       */
      dresser_pitch_diameter_mm: number;
      /**
       * Format: double
       * @description Nominal centre distance of dresser and worm.
       */
      dressing_centre_distance_mm: number;
      /**
       * Format: double
       * @description Nominal crossing angle of dresser and worm.
       */
      dressing_crossing_angle_deg: number;
      /** @description The left flank. */
      left?: components["schemas"]["FlankValues"] | null;
      /**
       * Format: double
       * @description kappa_0; absent for a spur gear, and where the flanks have different ones.
       */
      neutral_shift_ratio?: number | null;
      /** @description kappa_0 of each flank where they differ. */
      neutral_shift_ratio_by_flank?: {
        [key: string]: number;
      };
      /** @description The right flank. */
      right?: components["schemas"]["FlankValues"] | null;
      /**
       * Format: double
       * @description Screw parameter of the worm, mm/rad; < 0 left-handed.
       */
      screw_parameter_mm: number;
      /**
       * Format: double
       * @description kappa without the part that a variable adds.
       */
      shift_ratio: number;
      /**
       * Format: double
       * @description Scale along the worm, b_w.
       */
      shift_width_mm: number;
      /**
       * Format: double
       * @description Worm length needed if the worm is dressed again before every pass.
       */
      worm_length_one_after_the_other_mm: number;
      /**
       * Format: double
       * @description Worm length needed if the worm is dressed once for all passes, each in a zone of its own.
       */
      worm_length_side_by_side_mm: number;
      /**
       * Format: double
       * @description Pitch diameter of the worm.
       */
      worm_pitch_diameter_mm: number;
    };
    /** @description One value for each flank. */
    Sides: {
      /**
       * Format: double
       * @description Value of the left flank.
       */
      left: number | null;
      /**
       * Format: double
       * @description Value of the right flank.
       */
      right: number | null;
    };
    /** @description One value for each flank. */
    Sides2: {
      /** @description Value of the left flank. */
      left: number[];
      /** @description Value of the right flank. */
      right: number[];
    };
    /** @description One value for each flank. */
    Sides3: {
      /** @description Value of the left flank. */
      left: components["schemas"]["FilletResult"] | null;
      /** @description Value of the right flank. */
      right: components["schemas"]["FilletResult"] | null;
    };
    /** @description One value for each flank. */
    Sides4: {
      /**
       * Format: double
       * @description Value of the left flank.
       */
      left: number;
      /**
       * Format: double
       * @description Value of the right flank.
       */
      right: number;
    };
    /** @description One value for each flank. */
    Sides5: {
      /** @description Value of the left flank. */
      left: components["schemas"]["FlankRemovalResult"] | null;
      /** @description Value of the right flank. */
      right: components["schemas"]["FlankRemovalResult"] | null;
    };
    /** @description One value for each flank. */
    Sides6: {
      /** @description Value of the left flank. */
      left: components["schemas"]["FlankRateResult"] | null;
      /** @description Value of the right flank. */
      right: components["schemas"]["FlankRateResult"] | null;
    };
    /** @description One value for each flank. */
    Sides7: {
      /** @description Value of the left flank. */
      left: components["schemas"]["DressingOfLife"] | null;
      /** @description Value of the right flank. */
      right: components["schemas"]["DressingOfLife"] | null;
    };
    /** @description One value for each flank. */
    Sides8: {
      /** @description Value of the left flank. */
      left: [number, number, number];
      /** @description Value of the right flank. */
      right: [number, number, number];
    };
    /** @description One value for each flank. */
    Sides9: {
      /**
       * Format: uint
       * @description Value of the left flank.
       */
      left: number;
      /**
       * Format: uint
       * @description Value of the right flank.
       */
      right: number;
    };
    /** @description Signs of helix slopes. */
    Signs: {
      /**
       * Format: int32
       * @description +1 or -1.
       */
      left: number;
      /**
       * Format: int32
       * @description +1 or -1.
       */
      right: number;
    };
    /**
     * @description A flank of the workpiece at the tracks' lengths of roll; [profile][helix] with one place along the tooth, since every section is the
     *     same.
     */
    SkivedFlankResult: {
      /** @description The same under the referee. */
      corrected_simulated_um?: number[] | null;
      /** @description Predicted after the correction of the setting. */
      corrected_um: number[];
      /**
       * Format: double
       * @description Largest deviation of the referee's flank from the target.
       */
      max_deviation_um: number;
      /**
       * @description Largest difference between prediction and referee, of the mean tooth and of any tooth; of a simulated tool without the noise of
       *     its readings.
       */
      model_difference_um: [number, number];
      /** @description Predicted from the measurement, for the mean tooth. */
      planned_um: number[][];
      /**
       * Format: double
       * @description Root mean square of the same.
       */
      rms_deviation_um: number;
      /** @description Under the referee, for the mean tooth; of a real tool the edges are those that its deviations tell. */
      simulated_um: number[][];
      /** @description Wanted, normal. */
      target_um: number[][];
      /** @description Least and greatest over the teeth of what is predicted. */
      teeth_um: [number, number][];
      /** @description Lengths of roll. */
      w_mm: number[];
      /** @description Face positions: 0. */
      z_mm: number[];
    };
    /** @description The whole document. */
    SkivingResult: {
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description The beam by a mandrel. */
      calibration?: components["schemas"]["CalibrationResult"] | null;
      /** @description The usual way beside it. */
      conventional?: components["schemas"]["ConventionalResult"][];
      /** @description Tooth thickness and class of the workpiece's drawing, which nothing here judges. */
      drawing: components["schemas"]["DrawingResult"];
      /** @description The workpiece to come, by flank. */
      flanks: {
        [key: string]: components["schemas"]["SkivedFlankResult"];
      };
      /** @description Measurements of the tool since it was ground. */
      history?: components["schemas"]["HistoryResult"] | null;
      /** @description Name of the job. */
      job: string;
      /** @description The measured tool; absent where nothing was measured. */
      measurement?: components["schemas"]["MeasurementResult"] | null;
      /**
       * Format: double
       * @description Time of the measurement, s.
       */
      measuring_time_s: number;
      /** @description How results scatter. */
      monte_carlo?: components["schemas"]["MonteCarloResult"] | null;
      /** @description The machined workpiece under a probe. */
      probe?: components["schemas"]["ProbeResult"] | null;
      /** @description Process. */
      process: string;
      /** @description Measuring programs and what was proven of them. */
      programs?: components["schemas"]["ToolProgramResult"][];
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description The run-out of the tool answered by a law over its turn. */
      runout?: components["schemas"]["RunoutResult"] | null;
      /** @description The scan of a stylus. */
      scan?: components["schemas"]["ScanResult"] | null;
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description How tool and workpiece stand while they skive. */
      settings: components["schemas"]["SkivingSettings"];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Tolerance of the workpiece's profile.
       */
      tolerance_um: number;
      /** @description Tracks and poses, by flank. */
      tracks: {
        [key: string]: components["schemas"]["TrackResult"][];
      };
      /** @description Version of flankwright. */
      version: string;
      /** @description Warnings. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description The setting of the machine and what follows from it. */
    SkivingSettings: {
      /**
       * Format: double
       * @description d, < 0 for an internal gear.
       */
      centre_distance_mm: number;
      /**
       * Format: double
       * @description gamma.
       */
      crossed_axes_angle_deg: number;
      /**
       * Format: double
       * @description Sense in which the tool must turn to cut, +1 or -1; of a shaping cutter the sense of its stroke along its own axis.
       */
      cutting_sense: number;
      /**
       * Format: double
       * @description i_21.
       */
      ratio: number;
      /**
       * Format: double
       * @description h_c: depth of the rounding's centres below the rake face.
       */
      rounding_depth_mm: number;
      /**
       * Format: double
       * @description r_1.
       */
      tool_pitch_radius_mm: number;
      /**
       * Format: double
       * @description z_V1.
       */
      tool_shift_mm: number;
    };
    /** @description The smaller worms that today's dressing leaves whole, the addendum kept. */
    SparedWormsResult: {
      /** @description The cut into the smallest that was looked at, if there is one. */
      cut?: components["schemas"]["UnderminedResult"] | null;
      /**
       * Format: double
       * @description Tip diameter of the smallest worm that was looked at: that of `technology.life`, but no smaller than today's root diameter,
       *     which the dresser reaches; smaller worms are whole.
       */
      looked_down_to_mm: number;
      /**
       * Format: double
       * @description Tip diameter of the smallest that is left whole.
       */
      spared_down_to_mm: number;
    };
    /** @description A spline with its values. */
    SplineValues: {
      /**
       * @description The channel; every one but `kap`.
       * @enum {string}
       */
      channel: "Fp" | "FpL" | "FpR" | "Fz" | "dX" | "dA" | "gA" | "gam" | "dist" | "FC" | "FT";
      /** @description Coefficients of the basis functions, mm; of `gA` rad. */
      coefficients: number[];
      /**
       * Format: uint
       * @description Intervals of equal length.
       */
      intervals: number;
    };
    /** @description The rotation as whole pulses and a voltage. */
    SplitResult: {
      /**
       * Format: uint64
       * @description The same backward.
       */
      backward_pulses: number;
      /** @description Voltage less part over the run, at the flank. */
      error: components["schemas"]["RangeUm"];
      /**
       * Format: uint64
       * @description Whole workpiece pulses that went out forward.
       */
      forward_pulses: number;
      /** @description Limits of it over all parts. */
      limits: components["schemas"]["RangeUm"];
      /**
       * Format: uint32
       * @description Parts 1/P at the end.
       */
      part: number;
      /**
       * Format: double
       * @description What reading pulses and voltage at different instants costs at most: a whole workpiece pulse.
       */
      read_apart_um: number;
      /**
       * Format: double
       * @description One part at the flank.
       */
      step_um: number;
      /**
       * Format: double
       * @description Their voltage.
       */
      voltage_v: number;
      /**
       * Format: int64
       * @description Whole workpiece pulses at the end, rounded down.
       */
      whole_pulses: number;
    };
    /** @description A motion from its first to its last frame. */
    Stage: {
      /** @description What the frames are counted by. */
      coordinate: components["schemas"]["Coordinate"];
      /** @description The frames in ascending order of `at`. */
      frames: components["schemas"]["Frame"][];
      /** @description A name that no other stage has. */
      id: string;
      /** @description The same for people. */
      title: string;
    };
    /** @description Whether a target is met. */
    Status: "met" | "missed" | "not_judged";
    /** @description A step on the way to an entry. */
    Step: string | number;
    /** @description Stock of all tooth spaces. */
    StockResult: {
      /** @description Largest on each flank, normal. */
      largest_um: components["schemas"]["Sides4"];
      /** @description Least on each flank, normal; 0 or less where material is missing. */
      least_um: components["schemas"]["Sides4"];
      /**
       * Format: double
       * @description All of it.
       */
      volume_mm3: number;
    };
    /** @description The same in `result.json`. */
    StockResult2: {
      /** @description Least and greatest stock. */
      before_mm: [number, number];
      /**
       * Format: uint
       * @description Rays.
       */
      rays: number;
      /**
       * Format: uint
       * @description Rays at which nothing has cut before.
       */
      uncut: number;
    };
    /** @description A profile dressed in strokes. */
    StrokeCurve: {
      /** @description What tells the bodies from the others; empty where nothing is compared. */
      bodies: string;
      /**
       * Format: double
       * @description Largest distance from the wanted profile; absent where stock stays.
       */
      deviation_um: number | null;
      /** @description Its normal modification: the least of all strokes. */
      f_n_um: number[];
      /** @description Why there is no profile. */
      refused: components["schemas"]["Refused"] | null;
      /** @description The strokes in ascending order of w. */
      strokes: components["schemas"]["StrokeFigures"][];
      /** @description Lengths of roll of the finished profile. */
      w_mm: number[];
      /** @description The wanted one. */
      wanted_um: number[];
    };
    /** @description One stroke: what it dresses and with which correction. */
    StrokeFigures: {
      /**
       * Format: uint
       * @description Number of the active area, from 1.
       */
      area: number;
      /**
       * Format: double
       * @description Correction of the centre distance.
       */
      d_d_mm: number;
      /**
       * Format: double
       * @description Correction of the crossing angle.
       */
      d_gamma_deg: number;
      /**
       * Format: double
       * @description Correction of the worm angle.
       */
      d_phi_S_deg: number;
      /**
       * Format: double
       * @description Correction of the offset.
       */
      d_v_yA_mm: number;
      /** @description Normal modification there, positive = material left. */
      f_n_um: number[];
      /**
       * Format: double
       * @description Lengths of roll on the worm that it dresses.
       */
      from_mm: number;
      /**
       * Format: double
       * @description See `from_mm`.
       */
      to_mm: number;
      /** @description Its own profile: lengths of roll. */
      w_mm: number[];
    };
    /** @description The strokes of a pass with some of the threads left out. */
    StrokePlan: {
      /** @description Threads that grind, counted from 0. */
      active_threads: number[];
      /**
       * Format: double
       * @description Share of the full axial feed at which a tooth space is met as often as with all threads.
       */
      feed_factor: number;
      /** @description Index offsets of the workpiece, one a stroke, in pitches. */
      index_pitches: number[];
      /**
       * Format: uint
       * @description Strokes of one pass.
       */
      strokes_per_pass: number;
    };
    /** @description One stroke. */
    StrokeResult: {
      /**
       * Format: double
       * @description Way before the contact lines on which stock is ground already.
       */
      approach_mm: number;
      /** @description Feed z_V2 of the first and of the last contact. */
      contact_mm: [number, number];
      /**
       * Format: double
       * @description Of the worm's tip.
       */
      cutting_speed_m_per_s: number;
      /**
       * Format: double
       * @description Diagonal ratio; from end to end of the contact where it varies.
       */
      diagonal_ratio: number;
      /** @description "up" for a feed z_V2 that rises, "down". */
      direction: string;
      /**
       * Format: double
       * @description Pause after it.
       */
      dwell_s: number;
      /**
       * Format: double
       * @description Largest height of the feed marks.
       */
      feed_mark_um: number;
      /**
       * Format: double
       * @description Axial feed.
       */
      feed_mm_per_s: number;
      /**
       * Format: double
       * @description Feed per revolution of the workpiece.
       */
      feed_per_revolution_mm: number;
      /** @description Each flank that it grinds; null for the other. */
      flanks: components["schemas"]["Sides5"];
      /**
       * Format: double
       * @description Added to the centre distance.
       */
      infeed_um: number;
      /**
       * Format: double
       * @description Largest removal rate.
       */
      largest_rate_mm3_per_s: number;
      /** @description Stock that it leaves on each flank, normal; null for a flank that it does not grind. */
      left_um: components["schemas"]["Sides"];
      /** @description The limit that it comes nearest to; absent where it takes nothing. */
      nearest_limit?: components["schemas"]["LimitShare"] | null;
      /** @description Q'_w over flank and feed; absent where the stroke takes nothing. */
      rate_map?: components["schemas"]["RateMapResult"] | null;
      /** @description Removal rate at these times. */
      rate_mm3_per_s: number[];
      /** @description "climb" or "conventional". */
      sense: string;
      /** @description "roughing", "finishing" or "spark-out", which takes nothing. */
      stage: string;
      /** @description Times from the first contact on. */
      time_s: number[];
      /**
       * Format: double
       * @description Way from the first to the last contact with the overrun at both ends.
       */
      travel_mm: number;
      /**
       * Format: double
       * @description What it takes.
       */
      volume_mm3: number;
      /**
       * Format: double
       * @description Workpiece.
       */
      work_speed_rpm: number;
      /** @description Place on the worm for the first part. */
      worm_mm: [number, number];
      /**
       * Format: double
       * @description Worm.
       */
      worm_speed_rpm: number;
      /** @description Area of the worm: "all", "roughing" or "finishing". */
      zone: string;
    };
    /**
     * @description One stroke: what of which dresser touches which part of the worm's profile, and its corrections DK(v) as Chebyshev series of the
     *     worm position v_zS.
     */
    StrokeSettings: {
      /** @description Start and end of the active area by the parameter of the dresser's profile, the length of roll that it was designed for, mm. */
      area_mm: [number, number];
      /**
       * @description Chebyshev coefficients of d_d, mm.
       * @default []
       */
      d_d_mm: number[];
      /**
       * @description Chebyshev coefficients of d_gamma, deg.
       * @default []
       */
      d_gamma_deg: number[];
      /**
       * @description Chebyshev coefficients of d_phi_S, deg.
       * @default []
       */
      d_phi_S_deg: number[];
      /**
       * @description Chebyshev coefficients of d_v_yA, mm.
       * @default []
       */
      d_v_yA_mm: number[];
      /**
       * Format: uint
       * @description Number of the dresser: 1 is `[dresser]`, from 2 on the entries of `dresser.others`.
       */
      dresser: number;
      /** @description Lengths of roll of the worm on which the area is laid, mm. */
      range_mm: [number, number];
      /** @description All that touches the worm: the area and what it overlaps with its neighbours by, mm. */
      touching_mm: [number, number];
      /**
       * Format: double
       * @description First worm position v_zS of the series, mm.
       */
      v_from_mm: number;
      /**
       * Format: double
       * @description Last worm position v_zS of the series, mm.
       */
      v_to_mm: number;
    };
    /** @description The strokes of both worm flanks. */
    StrokeTables: {
      /** @description Strokes of the left flank. */
      left?: components["schemas"]["StrokeSettings"][];
      /** @description Strokes of the right flank. */
      right?: components["schemas"]["StrokeSettings"][];
    };
    /** @description A characteristic over the teeth. */
    SummaryResult: {
      /** @description fH, F, ff, C or fKo. */
      characteristic: string;
      /** @description Flank. */
      flank: string;
      /** @description profile or helix. */
      kind: string;
      /**
       * Format: double
       * @description Mean.
       */
      mean_um: number;
      /**
       * Format: double
       * @description Greatest less least; absent with one tooth.
       */
      range_um?: number | null;
      /** @description Mark of the line. */
      tag: string;
      /**
       * Format: uint
       * @description Teeth.
       */
      teeth: number;
    };
    /** @description One combination. Figures are absent where it cannot be made. */
    TangentialCandidate: {
      /**
       * Format: double
       * @description Tip diameter of the dresser.
       */
      dresser_tip_diameter_mm: number;
      /** @description Figures per flank that is ground. */
      flanks: {
        [key: string]: components["schemas"]["ExploredFlank"];
      };
      /**
       * Format: double
       * @description Largest deviation of all flanks.
       */
      max_deviation_um: number | null;
      /** @description Whether all flanks are within the tolerance. */
      met: boolean;
      /**
       * Format: uint
       * @description Place in the ranking, from 1.
       */
      rank: number;
      /** @description Why it cannot be made, if so. */
      refused: components["schemas"]["Refused"] | null;
      /**
       * Format: double
       * @description Tool shift per feed; absent where the bodies do not stand and the job names a rule.
       */
      shift_ratio: number | null;
      /**
       * Format: uint
       * @description Variables that the plan uses in all passes.
       */
      variables: number | null;
      /**
       * Format: double
       * @description Worm length needed if the worm is dressed again before every pass.
       */
      worm_length_mm: number | null;
      /**
       * Format: uint32
       * @description Threads of the worm.
       */
      worm_threads: number;
      /**
       * Format: double
       * @description Tip diameter of the worm; absent where the bodies of the job do not stand and it gives none.
       */
      worm_tip_diameter_mm: number | null;
    };
    /** @description What a study found: the document of `explore.json`. */
    TangentialExploration: {
      /** @description All combinations, the best first. */
      candidates: components["schemas"]["TangentialCandidate"][];
      /** @description Name of the job. */
      job: string;
      /**
       * Format: uint
       * @description Number of candidates within the tolerance.
       */
      met: number;
      /** @description Process. */
      process: string;
      /** @description How the candidates are ranked. */
      ranking: string;
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um: number;
      /** @description What varies: `shift_ratio`, `worm_tip_diameter`, `dresser_tip_diameter`, `worm_threads`. */
      varied: string[];
      /** @description Version of flankwright. */
      version: string;
    };
    /** @description One flank. */
    TangentialFlankResult: {
      /** @description x_D at which the evaluated flank is dressed. */
      dresser_position_mm: [number, number];
      /** @description x_D of the dressing stroke. */
      dressing_stroke_mm: [number, number];
      /**
       * Format: double
       * @description Height of the true feed marks over the envelope (sample of rays); absent without a feed per revolution.
       */
      feed_mark_um?: number | null;
      /** @description z_V2 of the grinding stroke. */
      feed_stroke_mm: [number, number];
      /**
       * Format: double
       * @description Least det J / det J_0.
       */
      least_determinant_ratio: number;
      /** @description How the worm flank is written line by line; absent for every other tool. */
      line_dressing?: components["schemas"]["LineDressingResult"] | null;
      /**
       * Format: double
       * @description Largest |simulated - target|.
       */
      max_deviation_um: number;
      /**
       * Format: double
       * @description Largest |planned - simulated|.
       */
      model_difference_um: number;
      /**
       * Format: double
       * @description Largest part of the target outside the producible class, normal.
       */
      outside_class_um: number;
      /**
       * Format: double
       * @description Largest |planned - target| inside the cells of the grid, where reliefs or waves stand on the tool's lines.
       */
      planned_between_um?: number | null;
      /** @description Exact contact with the worm as dressed, normal. */
      planned_um: number[][];
      /** @description Conventional grinding by radial feed; absent if the job does not ask. */
      radial_feed?: components["schemas"]["RadialFeedResult"] | null;
      /**
       * Format: double
       * @description Bound of the referee's own error.
       */
      referee_error_um: number;
      /**
       * Format: double
       * @description Root mean square of simulated - target.
       */
      rms_deviation_um: number;
      /**
       * Format: double
       * @description Largest |planned - rays| on a sample where the rays ask the dresser itself, without a surface between the stages.
       */
      sample_difference_um: number;
      /**
       * Format: double
       * @description Bound of the sample's own error.
       */
      sample_error_um: number;
      /** @description Characteristics of the simulated flank. */
      simulated_characteristics: components["schemas"]["CharacteristicsUm"];
      /** @description What the referee's rays left, normal. */
      simulated_um: number[][];
      /** @description Characteristics of the target. */
      target_characteristics: components["schemas"]["CharacteristicsUm"];
      /** @description Target, normal, `[profile][helix]`. */
      target_um: number[][];
      /**
       * Format: double
       * @description Largest |simulated - target| over the tolerance at its place; plus what the lines of a disc in point contact leave of the
       *     worm, over the tightest tolerance. The target is met up to 1.
       */
      tolerance_share: number;
      /** @description Traces where the drawing has them, evaluated as those of a measured gear; absent for tangential dressing. */
      traces?: components["schemas"]["TraceResult"][];
      /** @description Lengths of roll of the grid. */
      w_mm: number[];
      /** @description Axial positions on the worm that are used. */
      worm_occupation_mm: [number, number];
      /** @description Axial positions of the grid. */
      z_mm: number[];
    };
    /** @description The whole document. */
    TangentialResult: {
      /** @description Whether the run may be used: met, or nothing was asked for. */
      accepted: boolean;
      /** @description What gearbox and servo leave; absent unless the job describes its control. */
      control?: components["schemas"]["ControlResult"] | null;
      /** @description Tooth thickness and class of the drawing, which nothing here judges. */
      drawing: components["schemas"]["DrawingResult"];
      /** @description Flanks that are ground. */
      flanks: {
        [key: string]: components["schemas"]["TangentialFlankResult"];
      };
      /** @description Name of the job. */
      job: string;
      /** @description The passes in their order. */
      passes: components["schemas"]["PassResult2"][];
      /** @description Process. */
      process: string;
      /** @description NC programs with their proof; absent without a machine. */
      programs?: components["schemas"]["ProgramsResult"] | null;
      /** @description Why it is not met. */
      reason?: components["schemas"]["Remark"] | null;
      /** @description What the status covers. */
      scope: components["schemas"]["Scope"];
      /** @description Derivatives of the unmodified flank by design variables. */
      sensitivities: components["schemas"]["SensitivityResult"][];
      /** @description Settings. */
      settings: components["schemas"]["SettingsResult2"];
      /** @description Whether the target is met. */
      status: components["schemas"]["Status"];
      /** @description Seconds per stage; the only part that differs between two runs. */
      timing_s: {
        [key: string]: number;
      };
      /**
       * Format: double
       * @description Tolerance of the job.
       */
      tolerance_um: number;
      /** @description Version of flankwright. */
      version: string;
      /** @description Warnings. */
      warnings: components["schemas"]["Remark"][];
    };
    /** @description What is to be done with a job. */
    Task: "plan" | "simulate" | "explore" | "inspect";
    /** @description A commented job to start from. */
    TemplateAnswer: {
      /** @description Its text. */
      text: string;
    };
    /** @description One measure of the tooth thickness. */
    ThicknessResult: {
      /**
       * Format: double
       * @description Diameter of balls or rolls.
       */
      diameter_mm?: number | null;
      /** @description Least and greatest between the allowances; absent without them. */
      limits_mm?: [number, number];
      /**
       * Format: double
       * @description Of the gear that is made, in the middle of its allowances.
       */
      size_mm: number;
      /**
       * Format: uint32
       * @description Teeth spanned.
       */
      teeth?: number | null;
    };
    /** @description Profile shift coefficients that the sizes mean. */
    ThicknessResult2: {
      /**
       * Format: double
       * @description By the balls.
       */
      x_from_balls?: number | null;
      /**
       * Format: double
       * @description By the span.
       */
      x_from_span?: number | null;
    };
    /** @description One thread of the worm as proven. */
    ThreadProof: {
      /** @description First and last block of its finishing strokes, from 1. */
      blocks: number[][];
      /** @description Largest difference of each worm flank from that of the job's own motions. */
      difference_um: {
        [key: string]: number;
      };
      /**
       * Format: uint32
       * @description Its number, from 1 in the positive sense about the worm's axis.
       */
      thread: number;
    };
    /** @description Tolerances of a flank tolerance class. */
    ToleranceResult: {
      /**
       * Format: double
       * @description Total profile.
       */
      F_alphaT_um: number;
      /**
       * Format: double
       * @description Total helix.
       */
      F_betaT_um: number;
      /**
       * Format: double
       * @description Total cumulative pitch.
       */
      F_pT_um: number;
      /**
       * Format: double
       * @description Run-out.
       */
      F_rT_um: number;
      /**
       * Format: int32
       * @description The class.
       */
      class: number;
      /**
       * Format: double
       * @description Profile slope.
       */
      f_HalphaT_um: number;
      /**
       * Format: double
       * @description Helix slope.
       */
      f_HbetaT_um: number;
      /**
       * Format: double
       * @description Profile form.
       */
      f_falphaT_um: number;
      /**
       * Format: double
       * @description Helix form.
       */
      f_fbetaT_um: number;
      /**
       * Format: double
       * @description Single pitch.
       */
      f_pT_um: number;
    };
    /** @description One program. */
    ToolProgramResult: {
      /**
       * Format: double
       * @description Of a scan: what straight blocks leave between its places; of a stroke: beside its law.
       */
      between_places_um?: number | null;
      /**
       * Format: uint
       * @description Blocks that move.
       */
      blocks: number;
      /** @description Control. */
      control: string;
      /**
       * Format: double
       * @description Time of the whole program.
       */
      duration_s: number;
      /** @description Path below the directory of the run. */
      file: string;
      /**
       * Format: double
       * @description Of a stroke: greatest difference between the flank of the text under the referee and the planned one.
       */
      flank_difference_um?: number | null;
      /** @description Ways of a mandrel in the light barrier, in the order of the program. */
      mandrel_ways?: components["schemas"]["MandrelWayResult"][];
      /** @description Profiles of the workpiece that a probe scans, in the order of the program. */
      profiles?: components["schemas"]["ProbedProfileResult"][];
      /**
       * Format: double
       * @description What rounding explains of both.
       */
      proof_allowed_um: number;
      /**
       * Format: double
       * @description Greatest distance of the beam's axis from where the contact wants it.
       */
      proof_axis_distance_um: number;
      /**
       * Format: double
       * @description Greatest difference of where the ideal tool touches from its nominal place, with the axes as the text says.
       */
      proof_difference_um: number;
      /** @description What is recorded at a light barrier, in the order of the program. */
      recordings?: components["schemas"]["RecordingResult"][];
      /**
       * Format: double
       * @description What rounding of the numbers does at most.
       */
      rounding_um: number;
      /** @description What is scanned by a stylus, in the order of the program. */
      scans?: components["schemas"]["ScanResult2"][];
    };
    /** @description A tool of the machine's store. */
    ToolResult: {
      /** @description Coolant: "off", "flood", "mist", "flood-and-mist". */
      coolant: string;
      /** @description Its cutting part. */
      cutter: components["schemas"]["CutterResult"];
      /**
       * Format: double
       * @description Greatest feed of its operations.
       */
      feed_mm_per_min: number;
      /**
       * Format: double
       * @description From the nose of the spindle to its tip; absent without a machine.
       */
      length_mm?: number | null;
      /** @description Numbers of its length on controls that have it: H of LinuxCNC and Fanuc, D of Siemens. */
      length_offset: components["schemas"]["LengthNumbers"];
      /**
       * Format: uint32
       * @description Its number.
       */
      number: number;
      /** @description What it does, in the order of cutting. */
      operations: string[];
      /**
       * Format: double
       * @description Feed towards its paths.
       */
      plunge_feed_mm_per_min: number;
      /**
       * Format: double
       * @description Speed of the spindle.
       */
      spindle_rpm: number;
      /**
       * Format: uint32
       * @description Cutting edges; absent where the job does not tell.
       */
      teeth?: number | null;
    };
    /** @description A skiving tool and how often it was measured. */
    ToolSummary: {
      /**
       * Format: uint64
       * @description Number of measurements.
       */
      measurements: number;
      /** @description The tool. */
      tool: string;
    };
    /** @description Modification of a tool's flank, normal, positive = material left, as a table; a cubic spline goes through it. */
    ToolTable: {
      /** @description f_n1 by [w][z]. */
      f_um: number[][];
      /** @description Lengths of roll w_1, ascending. */
      w_mm: number[];
      /** @description Positions z_1 on the tool, ascending. */
      z_mm: number[];
    };
    /** @description Modifications of the flanks of a tool that is not dressed. */
    ToolTables: {
      /** @description Left flank. */
      left?: components["schemas"]["ToolTable"] | null;
      /** @description Right flank. */
      right?: components["schemas"]["ToolTable"] | null;
    };
    /** @description A tooth's flank. */
    ToothOnFlank: {
      /** @description Flank. */
      flank: string;
      /**
       * Format: double
       * @description Largest distance from the compensation curve.
       */
      off_um: number;
      /**
       * Format: uint
       * @description Tooth.
       */
      tooth: number;
    };
    /** @description A line of a chart. */
    Trace: {
      /** @description Deviations, um, normal, > 0 material left; at the places of the flank's `trace_w_mm` or `trace_z_mm`. */
      f_um: number[];
      /**
       * Format: uint
       * @description Tooth, from 0.
       */
      tooth: number;
    };
    /** @description The direction of a trace. */
    TraceDirection: "profile" | "helix";
    /** @description A trace. */
    TraceInspectionResult: {
      /**
       * Format: double
       * @description C: > 0 convex.
       */
      C_um: number;
      /**
       * Format: double
       * @description F.
       */
      F_um: number;
      /** @description How it lies in the band of the job. */
      band?: components["schemas"]["BandResult"] | null;
      /**
       * Format: double
       * @description f_H of material rising along the trace.
       */
      fH_material_um: number;
      /**
       * Format: double
       * @description f_H as printed.
       */
      fH_um: number;
      /**
       * Format: double
       * @description Relief at the tip, < 0 relieved.
       */
      fKo_um?: number | null;
      /**
       * Format: double
       * @description f_f.
       */
      ff_um: number;
      /** @description Flank. */
      flank: string;
      /** @description profile or helix. */
      kind: string;
      /**
       * Format: double
       * @description z of a profile, length of roll of a helix.
       */
      position_mm: number;
      /** @description Evaluated from and to. */
      range_mm: [number, number];
      /** @description Samples that count, and those in the range that were not measured. */
      samples: number[];
      /**
       * Format: double
       * @description Length that the slope refers to.
       */
      slope_length_mm: number;
      /** @description Sign of the printed slope in words. */
      slope_sign: string;
      /** @description Mark of the line. */
      tag: string;
      /**
       * Format: uint32
       * @description Tooth as the machine counts.
       */
      tooth: number;
    };
    /** @description A trace of the simulated flank. um, transverse. */
    TraceResult: {
      /** @description Its direction. */
      direction: components["schemas"]["TraceDirection"];
      /**
       * Format: double
       * @description f_f: range of what is left beside its line by least squares.
       */
      form_um: number;
      /** @description Values that the trace does not tell, each with the reason. */
      not_evaluated?: string[];
      /**
       * Format: double
       * @description Face position of a profile, length of roll of a helix.
       */
      position_mm: number;
      /** @description Evaluated length: lengths of roll or face positions. */
      range_mm: [number, number];
      /**
       * Format: double
       * @description f_H: rise of that line over the evaluated length, > 0 towards the tip or face II.
       */
      slope_um: number;
      /**
       * Format: double
       * @description Largest |simulated - target| over the tolerance at its place.
       */
      tolerance_share: number;
      /**
       * Format: double
       * @description F: range of simulated - target.
       */
      total_um: number;
      /** @description The part of it without reliefs, for which crowning and slope stand. */
      unrelieved_mm: [number, number];
      /** @description What the drawing states, as made. */
      values: components["schemas"]["DrawnValue"][];
    };
    /** @description A track with its pose. */
    TrackResult: {
      /**
       * Format: double
       * @description A.
       */
      a_deg: number;
      /**
       * Format: double
       * @description B: nominal angle of tooth 0.
       */
      b_deg: number;
      /**
       * Format: double
       * @description theta: where on the rounding it touches.
       */
      contact_angle_deg: number;
      /**
       * Format: double
       * @description Z.
       */
      height_mm: number;
      /**
       * Format: double
       * @description L: way of the normal per turn.
       */
      lever_mm_per_rad: number;
      /** @description n_m: its normal. */
      normal: [number, number, number];
      /**
       * Format: double
       * @description eta: angle between beam and helix of the flank.
       */
      off_flank_deg: number;
      /**
       * Format: double
       * @description What comes nearest to the beam besides the edge.
       */
      other_flank_gap_mm: number;
      /**
       * Format: double
       * @description x along the edge.
       */
      place: number;
      /** @description m: contact point in tool coordinates. */
      point_mm: [number, number, number];
      /** @description X, Y, Z. */
      position_mm: [number, number, number];
      /**
       * Format: double
       * @description R.
       */
      radius_mm: number;
      /** @description Where the rounding begins and ends. */
      rounding_deg: [number, number];
      /**
       * Format: double
       * @description Standard deviation of one reading.
       */
      single_sigma_um: number;
      /**
       * Format: double
       * @description phi_1 of the contact.
       */
      tool_angle_deg: number;
      /**
       * Format: uint
       * @description Number, from 1.
       */
      track: number;
      /**
       * Format: double
       * @description Length of roll that it makes.
       */
      w_mm: number;
    };
    /** @description Twist S of a tooth flank, transverse, > 0 removes at the tip of the upper face. */
    TwistResult: {
      /**
       * Format: double
       * @description S_beta: from the helix slopes at two lengths of roll.
       */
      S_by_leads_um?: number | null;
      /**
       * Format: double
       * @description S_alpha: from the profile slopes at two heights.
       */
      S_by_profiles_um?: number | null;
      /**
       * Format: double
       * @description Their difference: what is no bilinear twist.
       */
      difference_um?: number | null;
      /** @description Flank. */
      flank: string;
      /**
       * Format: uint32
       * @description Tooth as the machine counts.
       */
      tooth: number;
    };
    /** @description Where today's dressing cuts into a smaller worm. */
    UnderminedResult: {
      /**
       * Format: double
       * @description Depth, normal.
       */
      depth_um: number;
      /** @description Flank that is dressed. */
      dressed: string;
      /** @description Flank of the smaller worm. */
      flank: string;
      /**
       * Format: double
       * @description Place along the worm.
       */
      z_mm: number;
    };
    /** @description An item that was not judged. */
    UnjudgedItem: {
      /** @description Whether the job asks for it: then the target is not met. */
      asked: boolean;
      /** @description What was not judged. */
      item: string;
      /** @description Why it was not judged. */
      why: string;
    };
    /** @description A variable with its value. */
    VariableValue: {
      /** @description What moves. */
      meaning: string;
      /** @description Name. */
      name: string;
      /** @description Unit. */
      unit: string;
      /**
       * Format: double
       * @description Value in its unit.
       */
      value: number;
    };
    /** @description Load along the cutting edge. */
    WearResult: {
      /**
       * Format: double
       * @description Length of a bin.
       */
      bin_mm: number;
      /** @description Metres of path per mm of edge, bin by bin from the tip. */
      load_m_per_mm: number[];
      /**
       * Format: double
       * @description The highest load over that of one contact height for all rows.
       */
      peak_over_fixed: number;
      /**
       * Format: double
       * @description Length of the edge that is loaded.
       */
      spread_mm: number;
    };
    /** @description What a tool needs whose chips stay. */
    WithoutBroken: {
      /**
       * Format: double
       * @description The same along the tool's axis, mm.
       */
      axial_depth_mm: number;
      /**
       * Format: double
       * @description Depth along the rake faces' normal, mm.
       */
      depth_mm: number;
    };
    /** @description What the control has to hold as work offset. */
    WorkOffsetResult: {
      /** @description The clocking angle of the workpiece, where the control holds it. */
      clocking?: components["schemas"]["HeldAngle"] | null;
      /**
       * Format: uint16
       * @description Its number: 1 is G54.
       */
      number: number;
      /** @description Values of X, Y and Z. */
      position_mm: [number, number, number];
    };
    /** @description An axis of dressing that would be off. */
    WormAxis: {
      /** @description "d_phi_S_deg", "d_gamma_deg", "d_d_mm" or "d_v_yA_mm". */
      axis: string;
      /**
       * Format: double
       * @description Its standard uncertainty: from the noise, or from what is left where that is more; 0 for an axis that is taken to stand right.
       */
      uncertainty: number;
      /**
       * Format: double
       * @description Its deviation in the unit of the name.
       */
      value: number;
    };
    /** @description The dresser on worms of one number of threads, or whatever else is compared. */
    WormCurve: {
      /** @description What tells the bodies from the others; empty where nothing is compared. */
      bodies: string;
      /** @description Worms on which the dresser does not work, with the reason. */
      missing: [number, components["schemas"]["Refused"]][];
      /** @description Points in ascending order. */
      points: components["schemas"]["WormPoint"][];
    };
    /** @description A grinding worm that is there. At least one of the two diameters is needed. Lengths in mm. */
    WormEntry: {
      /** @description Hand of the threads; default the hand of the gear (spur: right). */
      hand?: components["schemas"]["Hand"] | null;
      /** @description What the shop calls it; each name once. */
      name: string;
      /**
       * Format: double
       * @description Normal module; default the one that meshes with the gear. A worm of another one is refused.
       */
      normal_module?: number | null;
      /** @description Normal pressure angle in degrees; default that of the gear. */
      normal_pressure_angle_deg?:
        | number
        | {
            left: number;
            right: number;
          };
      /**
       * Format: double
       * @description Current pitch diameter; default tip diameter less 2.5 normal modules.
       */
      pitch_diameter?: number | null;
      /**
       * Format: double
       * @description Pitch diameter down to which it may be dressed; without this or the next key it is looked at as it is now.
       */
      smallest_pitch_diameter?: number | null;
      /**
       * Format: double
       * @description Tip diameter down to which it may be dressed.
       */
      smallest_tip_diameter?: number | null;
      /**
       * Format: uint32
       * @description Number of threads.
       */
      threads: number;
      /**
       * Format: double
       * @description Current tip diameter; default pitch diameter plus 2.5 normal modules.
       */
      tip_diameter?: number | null;
      /**
       * Format: double
       * @description Usable width along the axis.
       */
      width: number;
    };
    /** @description One flank of the worm over the part of it that grinds. */
    WormFlankResult: {
      /**
       * Format: double
       * @description Largest |simulated - wanted| without what is the same everywhere: that is thread thickness and place, which the infeed sets.
       */
      max_deviation_um: number;
      /**
       * Format: double
       * @description Mean of simulated - wanted.
       */
      mean_deviation_um: number;
      /** @description What the referee's rays left under the dresser, normal. */
      simulated_um: number[][];
      /** @description Lengths of roll of the worm. */
      w_mm: number[];
      /** @description What is wanted, normal, positive = material left, `[profile][length]`. */
      wanted_um: number[][];
      /** @description Positions along the worm. */
      z_mm: number[];
    };
    /** @description What a study found: the document of `explore.json`. */
    WormLifeOutcome: {
      /** @description Name of the job. */
      job: string;
      /**
       * Format: double
       * @description Least tip diameter at which the target is met, and at every larger one that was planned; absent where the new worm misses it.
       */
      last_usable_tip_diameter_mm?: number | null;
      /** @description Process. */
      process: string;
      /**
       * Format: double
       * @description Tolerance of the job, the tightest of its map.
       */
      tolerance_um: number;
      /** @description Version of flankwright. */
      version: string;
      /** @description Whether that is the last diameter of the study: nothing ends the life before. */
      whole_life: boolean;
      /** @description Diameters from the new worm down, those between that look for the last usable one included. */
      worms: components["schemas"]["WormOfLife"][];
    };
    /** @description One worm from its first to its last diameter. */
    WormLifeResult: {
      /** @description Crossed-axes angle of the new and of the last worm. */
      crossed_axes_angle_deg: [number, number];
      /**
       * Format: uint
       * @description States between two dressings.
       */
      dressings: number;
      /**
       * Format: double
       * @description Parts in all.
       */
      parts_per_worm: number;
      /** @description Speed of the new and of the last worm for the same cutting speed. */
      worm_speed_rpm: [number, number];
    };
    /** @description What the worm removes between two dressings. */
    WormLoadResult: {
      /**
       * Format: double
       * @description First place on the worm.
       */
      from_mm: number;
      /**
       * Format: double
       * @description Parts between two dressings if the width were used at its best.
       */
      parts_by_load: number;
      /**
       * Format: uint
       * @description Parts that the width has room for at this jump from part to part; absent without one.
       */
      parts_by_width?: number | null;
      /**
       * Format: uint
       * @description Parts at the job's jump from part to part before a place of the worm has removed more than is allowed.
       */
      parts_per_dressing: number;
      /** @description V'_w of so many parts for each millimetre of the worm's width, the largest over the profile. */
      removed_mm3_per_mm: components["schemas"]["Sides2"];
      /** @description Areas of the worm; widths in balance last equally long. */
      zones: components["schemas"]["ZoneLoadResult"][];
    };
    /** @description A worm and what it leaves of the stretch. */
    WormOfLeastStretch: {
      /**
       * Format: double
       * @description Cone angle.
       */
      cone_angle_deg: number;
      /**
       * Format: double
       * @description Normal pressure angle of the left flank; the right one follows from the module that both share.
       */
      pressure_angle_left_deg: number;
      /**
       * Format: double
       * @description Relative profile stretch of the left flank.
       */
      stretch_left: number;
      /**
       * Format: double
       * @description Relative profile stretch of the right flank.
       */
      stretch_right: number;
    };
    /** @description The worm at one diameter. */
    WormOfLife: {
      /** @description What the plan at this diameter comes to; absent where there is none. */
      plan?: components["schemas"]["PlanOfLife"] | null;
      /** @description Why there is none. */
      refused?: components["schemas"]["Refused"] | null;
      /**
       * Format: double
       * @description Tip diameter.
       */
      tip_diameter_mm: number;
    };
    /** @description The dresser on one worm. */
    WormPoint: {
      /**
       * Format: double
       * @description Pressure angle of the worm at which the profile is not stretched; absent where none is near.
       */
      angle_without_stretch_deg: number | null;
      /**
       * @description The worm of this diameter for both flanks of an asymmetric gear at once; absent over other quantities and for symmetric
       *     gears, whose flanks share the angle above.
       */
      both_flanks?: components["schemas"]["BothFlanks"] | null;
      /**
       * Format: double
       * @description Correction of the centre distance.
       */
      d_d_mm: number;
      /**
       * Format: double
       * @description Correction of the crossing angle.
       */
      d_gamma_deg: number;
      /**
       * Format: double
       * @description Correction of the worm angle.
       */
      d_phi_S_deg: number;
      /**
       * Format: double
       * @description Correction of the offset.
       */
      d_v_yA_mm: number;
      /**
       * Format: double
       * @description Largest distance of the dressed profile from the involute with corrections, normal.
       */
      error_um: number;
      /**
       * Format: double
       * @description Largest tip land that clears the opposite flank; absent where none does.
       */
      largest_tip_land_mm: number | null;
      /**
       * Format: double
       * @description Relative profile stretch with corrections.
       */
      stretch: number;
      /**
       * Format: double
       * @description Profile crowning on the gear that comes about without corrections of crossing angle and offset; absent where these do not
       *     meet both ends of the profile, as on a worm of another pressure angle.
       */
      uncorrected_crowning_um: number | null;
      /**
       * Format: double
       * @description Pitch diameter of the worm (mm) or its pressure angle (deg).
       */
      value: number;
    };
    /** @description What a grinding pass touches on the worm, from its text. mm. */
    WormUse: {
      /** @description "roughing" or "finishing" and the number of the area. */
      area: string;
      /** @description First and last block of the pass, from 1. */
      blocks: number[];
      /** @description The program. */
      file: string;
      /** @description Flank. */
      flank: string;
      /** @description Worm lines z_1 + t_1 w_1 from and to; no line serves both roughing and finishing. */
      lines_mm: [number, number];
      /** @description Worm positions z_1 from and to. */
      z_1_mm: [number, number];
    };
    /** @description An area of the worm, or all of it. */
    ZoneLoadResult: {
      /**
       * Format: double
       * @description Largest V'_w allowed.
       */
      allowed_mm3_per_mm: number;
      /**
       * Format: double
       * @description Width at which all areas last equally long within the width of the worm.
       */
      balanced_width_mm: number;
      /**
       * Format: double
       * @description What one part takes of it.
       */
      per_part_mm3: number;
      /** @description Where the strokes of the first part use it. */
      used_mm: [number, number];
      /** @description "all", "roughing" or "finishing". */
      zone: string;
    };
  };
  responses: never;
  parameters: never;
  requestBodies: never;
  headers: never;
  pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
  about: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["About"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  catalogue: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["CatalogueAnswer"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  check: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody: {
      content: {
        "application/json": components["schemas"]["Job"];
      };
    };
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["CheckAnswer"];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  edit: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody: {
      content: {
        "application/json": components["schemas"]["EditRequest"];
      };
    };
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["EditAnswer"];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  examples: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["ExampleSummary"][];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  example: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description as in the list */
        id: string;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Job"];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  machines: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["MachineSummary"][];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  begin_inspection: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody: {
      content: {
        "multipart/form-data": components["schemas"]["MeasurementsRequest"];
      };
    };
    responses: {
      202: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["RunBegun"];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      429: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  document: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": Table;
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  parts: {
    parameters: {
      query?: {
        /** @description Of this series. */
        series?: string;
        /** @description Measured at this date or later. */
        from?: string;
        /** @description Measured at this date or earlier. */
        to?: string;
        /** @description Of these, so many of the newest, 1 to 10000; 1000 by default. */
        newest?: number;
      };
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["PartSummary"][];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  part: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description SHA-256 of its files */
        digest: string;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["PartRecord"];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  preview: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody: {
      content: {
        "application/json": components["schemas"]["PreviewRequest"];
      };
    };
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["PreviewAnswer"];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  check_program: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody: {
      content: {
        "application/json": components["schemas"]["ProgramRequest"];
      };
    };
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["CheckedProgram"];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  runs: {
    parameters: {
      query?: {
        /** @description Runs in the list, 1 to 1000. */
        most?: number;
      };
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["ListedRun"][];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  begin_run: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody: {
      content: {
        "application/json": components["schemas"]["NewRunRequest"];
      };
    };
    responses: {
      202: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["RunBegun"];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      429: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  run: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description its number */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Run"];
        };
      };
      304: {
        headers: {
          [name: string]: unknown;
        };
        content?: never;
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  remove: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description its number */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      204: {
        headers: {
          [name: string]: unknown;
        };
        content?: never;
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      409: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  again: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description its number */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      202: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["RunBegun"];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      429: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  archive: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description number of the run */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/zip": unknown;
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  cancel: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description its number */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["RunStateAnswer"];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      409: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  chart: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description number of the run */
        id: number;
        /** @description as the run lists it */
        name: string;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "image/svg+xml": unknown;
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  events: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description number of the run */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "text/event-stream": unknown;
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  file: {
    parameters: {
      query?: {
        /** @description To be saved, not shown. */
        download?: boolean;
      };
      header?: never;
      path: {
        /** @description number of the run */
        id: number;
        /** @description as the run lists it */
        name: string;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/octet-stream": unknown;
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  scene: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description number of the run */
        id: number;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Scene"];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  schema: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": Table;
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  series: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["SeriesSummary"][];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  template: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description its word in a job */
        process: string;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["TemplateAnswer"];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  tools: {
    parameters: {
      query?: never;
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["ToolSummary"][];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  history: {
    parameters: {
      query?: never;
      header?: never;
      path: {
        /** @description its name */
        tool: string;
      };
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["HistoryRecord"][];
        };
      };
      404: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
  trends: {
    parameters: {
      query?: {
        /** @description Of this series. */
        series?: string;
        /** @description Symbol, e.g. `fHa`. */
        name?: string;
        /** @description `left` or `right`. */
        flank?: string;
        /** @description E.g. `mean`. */
        statistic?: string;
        /** @description Of so many of the newest parts, 1 to 10000; 1000 by default. */
        newest?: number;
      };
      header?: never;
      path?: never;
      cookie?: never;
    };
    requestBody?: never;
    responses: {
      200: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["MeasuredCharacteristic"][];
        };
      };
      422: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
      /** @description The request is refused. */
      default: {
        headers: {
          [name: string]: unknown;
        };
        content: {
          "application/json": components["schemas"]["Failure"];
        };
      };
    };
  };
}
