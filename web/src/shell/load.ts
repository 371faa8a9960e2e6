// Loads parts of the pages. Where that fails, the server is asked why: it is gone, wants a token, or has other pages by now.

import * as api from "../api/client";
import { RequestFailure } from "../api/failure";

export async function loaded<T>(load: () => Promise<T>): Promise<T> {
  try {
    return await load();
  } catch {
    await api.about();
    throw new RequestFailure("outdated", 0, []);
  }
}
