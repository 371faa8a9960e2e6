//! The web application: a server that hands out its pages and carries out what they ask, by the same workflow as the command. Computes
//! nothing of its own.

mod api;
mod app;
mod assets;
mod gate;
mod headers;
mod openapi;
mod shelf;
mod stock;
mod wire;
mod work;

use std::io;
use std::net::{IpAddr, SocketAddr};
use std::time::Duration;

use flankwright_store::{Store, StoreAddress, StoreError};
use thiserror::Error;
use tokio::net::TcpListener;

pub use openapi::openapi;

/// The port on which the server listens unless told otherwise.
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
    /// The system has no random numbers for a token, or no threads.
    #[error("the system refuses what a server needs: {0}")]
    System(String),
    /// The server stopped.
    #[error("the server stopped: {0}")]
    Stopped(io::Error),
}

/// Serves until the process is told to end (Ctrl-C). `listening` gets the address to open in a browser.
///
/// # Errors
/// [`ServeError`].
pub fn serve(options: &Options, listening: impl FnOnce(&str)) -> Result<(), ServeError> {
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .map_err(|error| ServeError::System(error.to_string()))?;
    let served = runtime.block_on(serve_in(options, listening));
    // Computations under way are not waited for: the next start tells their runs as interrupted.
    runtime.shutdown_background();
    served
}

async fn serve_in(options: &Options, listening: impl FnOnce(&str)) -> Result<(), ServeError> {
    let wanted = SocketAddr::new(options.host, options.port);
    let listen = |source| ServeError::Listen { address: wanted, source };
    let listener = TcpListener::bind(wanted).await.map_err(listen)?;
    let address = listener.local_addr().map_err(listen)?;
    let token = match &options.token {
        None if !address.ip().is_loopback() => Some(new_token()?),
        given => given.clone(),
    };
    let store = Store::open(&options.store).await?;
    let app = app::App::new(store, options.store.clone(), address).await?;
    let opened = match &token {
        Some(token) => format!("http://{address}/?token={token}"),
        None => format!("http://{address}/"),
    };
    let gate = gate::Gate::new(address, &options.names, token);
    let router = app::router(app.clone(), gate);
    listening(&opened);
    let serving = axum::serve(listener, router).with_graceful_shutdown(app.told_to_end()).into_future();
    let served = tokio::select! {
        served = serving => served,
        () = farewell(&app) => Ok(()),
    };
    app.close().await;
    served.map_err(ServeError::Stopped)
}

/// How long answers that are under way are waited for when the server ends.
const FAREWELL: Duration = Duration::from_secs(3);

async fn farewell(app: &app::App) {
    app.ended().await;
    tokio::time::sleep(FAREWELL).await;
}

/// 128 random bits in hexadecimal digits.
fn new_token() -> Result<String, ServeError> {
    let mut bytes = [0u8; 16];
    getrandom::fill(&mut bytes).map_err(|error| ServeError::System(error.to_string()))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}
