//! The web application: a server that hands out its pages and carries out what they ask, by the same workflow as the command. Computes
//! nothing of its own.

mod api;
mod app;
mod assets;
mod charts;
mod gate;
mod headers;
mod listen;
mod log;
mod openapi;
mod rooms;
mod router;
mod scratch;
mod shelf;
mod stock;
mod wire;
mod work;

use std::io;
use std::net::{IpAddr, SocketAddr};

use flankwright_store::{Store, StoreAddress, StoreError};
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::sync::watch;

pub use openapi::openapi;

/// The port on which the server listens by default.
pub const PORT: u16 = 8470;

/// How the server is started.
#[derive(Debug)]
pub struct Options {
    /// Where it listens.
    pub host: IpAddr,
    /// On which port; 0 takes a free one.
    pub port: u16,
    /// Further names under which it may be addressed.
    pub names: Vec<String>,
    /// The token that requests need; off the loopback one is made where none is given.
    pub token: Option<String>,
    /// Where parts, plans and runs are kept.
    pub store: StoreAddress,
}

/// Why the server ended.
#[derive(Debug, Error)]
pub enum ServeError {
    /// The address cannot be listened at.
    #[error("{address} cannot be listened at: {source}")]
    Listen {
        /// Where.
        address: SocketAddr,
        /// What the system says.
        source: io::Error,
    },
    /// The store cannot be opened.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The system has no random numbers for a token, no threads, or no room for temporary files.
    #[error("the system refuses what a server needs: {0}")]
    System(String),
}

/// Serves until the process is stopped (Ctrl-C). `listening` gets the addresses to open in a browser, the first one of them on this
/// machine.
///
/// # Errors
/// [`ServeError`].
pub fn serve(options: &Options, listening: impl FnOnce(&[String])) -> Result<(), ServeError> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .map_err(|error| ServeError::System(error.to_string()))?;
    let served = runtime.block_on(serve_in(options, listening));
    // Computations under way are not waited for: their runs are told as interrupted.
    runtime.shutdown_background();
    served
}

async fn serve_in(options: &Options, listening: impl FnOnce(&[String])) -> Result<(), ServeError> {
    let wanted = SocketAddr::new(options.host, options.port);
    let listen = |source| ServeError::Listen { address: wanted, source };
    let listener = TcpListener::bind(wanted).await.map_err(listen)?;
    let address = listener.local_addr().map_err(listen)?;
    let token = match &options.token {
        None if !address.ip().is_loopback() => Some(new_token()?),
        given => given.clone(),
    };
    let store = Store::open(&options.store).await?;
    let (end, ending) = watch::channel(false);
    let interface = openapi().to_string();
    let app = app::App::new(store, options.store.clone(), interface, ending.clone()).await?;
    let gate = gate::Gate::new(address, &options.names, token.clone());
    let router = router::router(app.clone(), gate.clone());
    let entry = token.map_or_else(String::new, |token| format!("?token={token}"));
    let opened: Vec<String> =
        gate.authorities().iter().map(|authority| format!("http://{authority}/{entry}")).collect();
    listening(&opened);
    let work = app.work.clone();
    tokio::spawn(async move {
        told_to_end().await;
        work.end();
        end.send_replace(true);
    });
    listen::listen(listener, router, ending).await;
    app.close().await;
    Ok(())
}

/// Resolves when the process is stopped.
async fn told_to_end() {
    tokio::select! {
        _ = tokio::signal::ctrl_c() => {}
        () = terminated() => {}
    }
}

#[cfg(unix)]
async fn terminated() {
    match tokio::signal::unix::signal(tokio::signal::unix::SignalKind::terminate()) {
        Ok(mut signal) => {
            signal.recv().await;
        }
        Err(_) => std::future::pending().await,
    }
}

#[cfg(not(unix))]
async fn terminated() {
    std::future::pending().await
}

/// 128 random bits in hexadecimal digits.
fn new_token() -> Result<String, ServeError> {
    let mut bytes = [0u8; 16];
    getrandom::fill(&mut bytes).map_err(|error| ServeError::System(error.to_string()))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
