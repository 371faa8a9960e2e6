//! Connections: a bounded number of them, none of which may take its time over the head of a request. Knows no path.

use std::pin::Pin;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{Semaphore, watch};
use tokio_io_timeout::TimeoutStream;

/// Connections at once; more of them wait until they are accepted.
const MOST_CONNECTIONS: usize = 256;
/// Longest time between the beginning of a connection, or its last answer, and the end of the next head.
const LONGEST_HEAD: Duration = Duration::from_secs(20);
/// How long answers that are under way are waited for when the server ends.
const FAREWELL: Duration = Duration::from_secs(3);
/// A client that takes nothing of its answer for so long is given up.
const LONGEST_SILENCE: Duration = Duration::from_secs(30);
/// After that time accepting is tried again where the system has nothing left.
const BREATH: Duration = Duration::from_millis(200);

/// A stream that fails where the other side takes nothing for too long.
fn patient(stream: TcpStream) -> Pin<Box<TimeoutStream<TcpStream>>> {
    let mut stream = TimeoutStream::new(stream);
    stream.set_write_timeout(Some(LONGEST_SILENCE));
    Box::pin(stream)
}

/// Answers until the server ends.
pub async fn listen(listener: TcpListener, router: Router, mut ending: watch::Receiver<bool>) {
    let rooms = Arc::new(Semaphore::new(MOST_CONNECTIONS));
    let connections = GracefulShutdown::new();
    let mut server = http1::Builder::new();
    server.timer(TokioTimer::new()).header_read_timeout(LONGEST_HEAD);
    loop {
        let accepted = async {
            let room = rooms.clone().acquire_owned().await;
            (room, listener.accept().await)
        };
        let (room, accepted) = tokio::select! {
            accepted = accepted => accepted,
            _ = ending.wait_for(|ending| *ending) => break,
        };
        let Ok((stream, _)) = accepted else {
            // The client is gone already, or there are no files left to open.
            tokio::time::sleep(BREATH).await;
            continue;
        };
        drop(stream.set_nodelay(true));
        let service = TowerToHyperService::new(router.clone());
        let connection = connections.watch(server.serve_connection(TokioIo::new(patient(stream)), service));
        tokio::spawn(async move {
            let _room = room;
            // What a client does wrong is its own affair.
            drop(connection.await);
        });
    }
    drop(listener);
    drop(tokio::time::timeout(FAREWELL, connections.shutdown()).await);
}
