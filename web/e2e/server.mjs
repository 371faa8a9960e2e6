// A server of its own for tests: started on a store in a new folder, asked over its interface, killed and started again.

import { spawn } from "node:child_process";
import { mkdtemp, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const PROGRAM = process.env.PROGRAM ?? join(ROOT, "target/demo/flankwright");
const START_MS = 20_000;

/** The path of a file of the repository. */
export const inRepository = (path) => join(ROOT, path);

/** The text of an example as it lies in the repository. */
export const exampleText = (path) => readFile(inRepository(`examples/${path}`), "utf8");

export class Server {
  #child;
  #folder;
  #options;
  #environment;
  /** Without a slash at its end. */
  address = "";
  port = 0;

  /** Starts a server with these options of `flankwright serve` and variables of the environment. */
  static async start(options = [], environment = {}) {
    const server = new Server();
    server.#folder = await mkdtemp(join(tmpdir(), "flankwright-e2e-"));
    server.#options = options;
    server.#environment = environment;
    await server.startAgain();
    return server;
  }

  get store() {
    return `sqlite:${join(this.#folder, "store.sqlite")}`;
  }

  /** On the same store, and at the same port if it was there before. */
  async startAgain() {
    const child = spawn(PROGRAM, ["serve", "--port", String(this.port), "--store", this.store, "--json", ...this.#options], {
      env: { ...process.env, ...this.#environment },
      stdio: ["ignore", "pipe", "pipe"],
    });
    this.#child = child;
    let said = "";
    child.stderr.on("data", (text) => (said += text));
    this.address = await new Promise((resolve, reject) => {
      let printed = "";
      const late = setTimeout(() => reject(new Error(`${PROGRAM} printed no address: ${said}`)), START_MS).unref();
      child.once("error", reject);
      child.once("exit", (status) => reject(new Error(`${PROGRAM} ended with ${status}: ${said}`)));
      child.stdout.on("data", (text) => {
        printed += text;
        if (!printed.includes("}")) return;
        clearTimeout(late);
        resolve(new URL(JSON.parse(printed).address).origin);
      });
    });
    this.port = Number(new URL(this.address).port);
  }

  /** Ends it as a failing computer does, without a word. */
  kill() {
    const child = this.#child;
    if (child.exitCode !== null || child.signalCode !== null) return Promise.resolve();
    const ended = new Promise((resolve) => child.once("exit", resolve));
    child.kill("SIGKILL");
    return ended;
  }

  async stop() {
    await this.kill();
    await rm(this.#folder, { recursive: true, force: true });
  }

  async #ask(path, init) {
    const response = await fetch(`${this.address}/api/${path}`, init);
    if (!response.ok) throw new Error(`${path}: ${response.status} ${await response.text()}`);
    return response;
  }

  async get(path) {
    return (await this.#ask(path)).json();
  }

  async bytes(path) {
    return Buffer.from(await (await this.#ask(path)).arrayBuffer());
  }

  async post(path, body) {
    const init = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
    return (await this.#ask(path, init)).json();
  }

  /** Runs an example, with its text changed by `change`, and tells the number of the run when it has ended. */
  async run(kind, example, change = (text) => text) {
    const job = await this.get(`examples/${example}`);
    const { id } = await this.post("runs", { kind, job: { ...job, text: change(job.text) } });
    return this.ended(id);
  }

  /** Hands in a measurement, with a job or without, and tells the number of the run when it has ended. */
  async inspect(name, text, options, job) {
    const form = new FormData();
    form.append("file", new Blob([text]), name);
    if (job) form.append("job", new Blob([JSON.stringify(job)], { type: "application/json" }));
    form.append("options", new Blob([JSON.stringify(options)], { type: "application/json" }));
    const { id } = await (await this.#ask("measurements", { method: "POST", body: form })).json();
    return this.ended(id);
  }

  /** The stream of events ends with the run. */
  async ended(id) {
    await (await this.#ask(`runs/${id}/events`)).text();
    return id;
  }

  /** Runs another command of the program on the store of this server. */
  command(...words) {
    return new Promise((resolve, reject) => {
      const child = spawn(PROGRAM, [...words, "--store", this.store, "--quiet"], { stdio: ["ignore", "ignore", "inherit"] });
      child.once("error", reject);
      child.once("exit", (status) => (status === 0 ? resolve() : reject(new Error(`${words.join(" ")} ended with ${status}`))));
    });
  }
}
