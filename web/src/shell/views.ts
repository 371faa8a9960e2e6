// The views of the rail, each loaded when it is first opened.

import type { Component } from "svelte";
import type { Sign } from "../ui/signs";

export type ViewName = "job" | "runs" | "inspect" | "explore" | "catalogue" | "history" | "compare";

export interface View {
  name: ViewName;
  sign: Sign;
  load: () => Promise<{ default: Component }>;
}

export const VIEWS: View[] = [
  { name: "job", sign: "job", load: () => import("../job/JobPage.svelte") },
  { name: "runs", sign: "runs", load: () => import("../runs/RunsPage.svelte") },
  { name: "inspect", sign: "inspect", load: () => import("../inspect/InspectPage.svelte") },
  { name: "explore", sign: "explore", load: () => import("../explore/ExplorePage.svelte") },
  { name: "catalogue", sign: "catalogue", load: () => import("../catalogue/CataloguePage.svelte") },
  { name: "history", sign: "history", load: () => import("../history/HistoryPage.svelte") },
  { name: "compare", sign: "compare", load: () => import("../compare/ComparePage.svelte") },
];
