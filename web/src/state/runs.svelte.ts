// How many runs are under way, for the rail.

import * as api from "../api/client";

class RunsUnderWay {
  count = $state(0);

  async refresh(): Promise<void> {
    try {
      const { queue } = await api.about();
      this.count = queue.running + queue.waiting;
    } catch {
      // The view in front tells what fails; the rail stays as it was.
    }
  }
}

export const runsUnderWay = new RunsUnderWay();
