// What every part of the form needs: the schema, and an id for the field at a path.

import { getContext, setContext } from "svelte";
import type { JobSchema } from "../../lib/schema";
import { pathText, type Path } from "../../lib/path";

const KEY = Symbol("form");

export const provideSchema = (schema: JobSchema): JobSchema => setContext(KEY, schema);
export const useSchema = (): JobSchema => getContext<JobSchema>(KEY);
export const fieldId = (path: Path): string => `field-${pathText(path).replace(/[^A-Za-z0-9_-]/g, "-")}`;
