// Machine descriptions of the server, fetched once.

import * as api from "../api/client";
import type { MachineHead } from "../api/types";

class Machines {
  list = $state.raw<MachineHead[]>([]);
  #asked = false;

  async load(): Promise<void> {
    if (this.#asked) return;
    this.#asked = true;
    try {
      this.list = await api.machines();
    } catch {
      this.#asked = false;
    }
  }
}

export const machines = new Machines();
