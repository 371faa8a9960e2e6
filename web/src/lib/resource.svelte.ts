// Something that is fetched: what came, or the failure. Asking again drops the answer to an older question.

import { asFailure, type RequestFailure } from "../api/failure";

export class Resource<T> {
  value = $state.raw<T>();
  failure = $state.raw<RequestFailure>();
  isLoading = $state(false);
  #turn = 0;

  async load(fetcher: () => Promise<T>): Promise<void> {
    const turn = ++this.#turn;
    this.isLoading = true;
    try {
      const value = await fetcher();
      if (turn !== this.#turn) return;
      this.value = value;
      this.failure = undefined;
    } catch (error) {
      if (turn !== this.#turn) return;
      this.failure = asFailure(error);
    } finally {
      if (turn === this.#turn) this.isLoading = false;
    }
  }
}
