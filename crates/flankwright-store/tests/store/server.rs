//! The PostgreSQL server of these tests: one for all, with a database for each. It ends with this process.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicU32, Ordering};

use sqlx::{AssertSqlSafe, Connection, PgConnection};

struct Server {
    address: String,
    /// Closed when this process ends, however it does: the server stops then.
    _input: ChildStdin,
    _script: Child,
}

static SERVER: OnceLock<Server> = OnceLock::new();
static DATABASES: AtomicU32 = AtomicU32::new(0);

fn start() -> Server {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts/postgresql");
    let mut child = Command::new(script)
        .arg("serve")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("scripts/postgresql starts");
    let mut address = String::new();
    BufReader::new(child.stdout.take().expect("its output")).read_line(&mut address).expect("a line");
    assert!(!address.is_empty(), "there is no PostgreSQL server: run `scripts/postgresql install`");
    let input = child.stdin.take().expect("its input");
    Server { address: address.trim().to_owned(), _input: input, _script: child }
}

/// The server's address up to the name of a database.
pub fn address() -> &'static str {
    &SERVER.get_or_init(start).address
}

/// The address of a new database.
pub fn database() -> String {
    let name = format!("store_{}", DATABASES.fetch_add(1, Ordering::Relaxed));
    run(&format!("{}postgres", address()), &format!("CREATE DATABASE {name}"));
    format!("{}{name}", address())
}

/// Runs a statement beside the store.
pub fn run(database: &str, statement: &str) {
    block_on(async {
        let mut connection = PgConnection::connect(database).await.expect("a connection");
        sqlx::query(AssertSqlSafe(statement.to_owned())).execute(&mut connection).await.expect("it runs");
        connection.close().await.expect("an end");
    });
}

/// Runs to the end.
pub fn block_on<T>(future: impl Future<Output = T>) -> T {
    tokio::runtime::Builder::new_current_thread().enable_all().build().expect("a runtime").block_on(future)
}
