// The schema of jobs, fetched once.

import * as api from "../api/client";
import { Resource } from "../lib/resource.svelte";
import { JobSchema } from "../lib/schema";

export const schemaOfJobs = new Resource<JobSchema>();

export async function loadSchema(): Promise<void> {
  if (!schemaOfJobs.value) await schemaOfJobs.load(async () => new JobSchema(await api.schema()));
}
