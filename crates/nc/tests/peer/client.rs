//! LinuxCNC as `scripts/linuxcnc-client` unpacks it: its interpreter `rs274` and its Python module `gcode`.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Mutex, PoisonError};

/// What a test says that cannot run: `.ci/run` repeats lines that begin so.
pub const ABSENT: &str = "LinuxCNC client absent";

/// Programs of LinuxCNC share memory: when two of them run at a time, the one that ends takes it from the other, which dies by a
/// signal. Others on this computer cannot be asked to wait, so that such a death is tried again.
fn run_alone(command: &mut Command) -> std::io::Result<Output> {
    static ONE: Mutex<()> = Mutex::new(());
    let _guard = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    let mut output = command.output()?;
    for _ in 0..5 {
        if output.status.code().is_some() {
            break;
        }
        output = command.output()?;
    }
    Ok(output)
}

pub struct Client {
    root: PathBuf,
}

impl Client {
    /// The client, if it is there and can start.
    pub fn find() -> Option<Self> {
        let target = std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let client = Self { root: workspace.join(target).join("linuxcnc") };
        // Without a library that it needs the loader ends with 127.
        let probe = client.command(&client.root.join("usr/bin/rs274")).arg("-h").output().ok()?;
        (probe.status.code() != Some(127)).then_some(client)
    }

    fn command(&self, program: &Path) -> Command {
        let mut command = Command::new(program);
        let library = |path: &str| self.root.join(path).into_os_string();
        let mut libraries = library("usr/lib");
        libraries.push(":");
        libraries.push(library("usr/lib/x86_64-linux-gnu"));
        command.env("LD_LIBRARY_PATH", libraries);
        command.env("PYTHONPATH", self.root.join("usr/lib/python3/dist-packages"));
        command
    }

    /// Runs `rs274` on a file; the output holds the canonical text.
    pub fn interpret(&self, file: &Path, directory: &Path) -> Output {
        self.interpret_with_tools(file, directory, "")
    }

    /// The same with a tool table.
    pub fn interpret_with_tools(&self, file: &Path, directory: &Path, tools: &str) -> Output {
        let table = directory.join("tools.tbl");
        std::fs::write(&table, tools).expect("a tool table");
        let mut command = self.command(&self.root.join("usr/bin/rs274"));
        // The interpreter keeps its tools in a file of the home directory, which runs beside it would share.
        command
            .env("HOME", directory)
            .arg("-t")
            .arg(&table)
            .arg("-v")
            .arg(directory.join("run.var"))
            .arg("-g")
            .arg(file);
        run_alone(&mut command).expect("rs274 starts")
    }

    /// Runs the module `gcode` on a file; none if no Python of the right version is here.
    fn module(&self, file: &Path, directory: &Path, timed: bool) -> Option<Output> {
        let parameters = directory.join("module.var");
        std::fs::write(&parameters, "").ok()?;
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../nc/tests/peer/interpret.py");
        ["/usr/bin/python3", "python3.11", "python3"].into_iter().find_map(|python| {
            let mut command = self.command(Path::new(python));
            command.arg("-B").arg(&script).args(timed.then_some("--time")).arg(file).arg(&parameters);
            let output = run_alone(&mut command).ok()?;
            let message = String::from_utf8_lossy(&output.stderr);
            let foreign = message.contains("ImportError") || message.contains("ModuleNotFoundError");
            (!foreign).then_some(output)
        })
    }

    /// What the module makes of a file: one event a line, or its message.
    pub fn parse(&self, file: &Path, directory: &Path) -> Option<Result<String, String>> {
        let output = self.module(file, directory, false)?;
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Some(if output.status.success() { Ok(text(&output.stdout)) } else { Err(text(&output.stderr)) })
    }

    /// Seconds that the module took for a file.
    #[allow(dead_code, reason = "the bench asks for it")]
    pub fn parse_time(&self, file: &Path, directory: &Path) -> Option<f64> {
        let output = self.module(file, directory, true)?;
        String::from_utf8_lossy(&output.stdout).trim().parse().ok()
    }
}
