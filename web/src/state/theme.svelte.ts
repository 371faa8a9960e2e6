// Light or dark: as the system says, or as chosen here.

import { readSetting, writeSetting } from "./settings";

export type Theme = "system" | "light" | "dark";

class ThemeState {
  choice = $state<Theme>(startTheme());
  #system = $state(false);
  isDark = $derived(this.choice === "dark" || (this.choice === "system" && this.#system));

  constructor() {
    const query = matchMedia("(prefers-color-scheme: dark)");
    this.#system = query.matches;
    query.addEventListener("change", () => {
      this.#system = query.matches;
      this.apply();
    });
  }

  set(choice: Theme): void {
    this.choice = choice;
    writeSetting("theme", choice);
    this.apply();
  }

  apply(): void {
    document.documentElement.dataset["theme"] = this.isDark ? "dark" : "light";
  }
}

function startTheme(): Theme {
  const kept = readSetting("theme");
  return kept === "light" || kept === "dark" ? kept : "system";
}

export const theme = new ThemeState();
