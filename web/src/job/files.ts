// Jobs and their data files come from and go to files of the user.

import { jobStore } from "../state/job.svelte";
import { looksLikeJob } from "./text";

/** Gives a text to the user as a file. */
export function download(name: string, text: string, type = "text/plain"): void {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** The texts of files by their bare names. */
export async function readFiles(files: File[]): Promise<Record<string, string>> {
  const read = files.map(async (file) => [file.name, await file.text()] as const);
  return Object.fromEntries(await Promise.all(read));
}

/** Opens what was chosen or dropped: a job with its tables, or further tables for the job that is open. */
export async function takeFiles(files: File[]): Promise<void> {
  const texts = await readFiles(files);
  const job = Object.entries(texts).find(([name, text]) => looksLikeJob(name, text));
  if (job) {
    const [name, text] = job;
    const others = Object.fromEntries(Object.entries(texts).filter(([other]) => other !== name));
    jobStore.replace({ text, files: others }, name);
  } else if (files.length > 0) {
    jobStore.setFiles({ ...jobStore.present.files, ...texts });
  }
}

/** Gives the job to the user under the name of its file, or of the job. */
export function saveJob(): void {
  const { text, fileName } = jobStore.present;
  const isJson = text.trimStart().startsWith("{");
  const name = fileName || `${jobStore.name ?? "job"}${isJson ? ".json" : ".toml"}`;
  download(name, text);
}
