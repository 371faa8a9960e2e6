//! A server with a store of its own.

use std::net::{IpAddr, Ipv4Addr, SocketAddr};
use std::ops::Deref;
use std::sync::{Arc, mpsc};
use std::thread;
use std::time::Duration;

use flankwright_server::{Options, serve};
use flankwright_store::StoreAddress;
use tempfile::TempDir;

use crate::http::At;

/// A server that listens; it ends with the program of the tests.
pub struct Served {
    at: At,
    pub address: SocketAddr,
    pub opened: String,
    store: StoreAddress,
    folder: Arc<TempDir>,
}

impl Served {
    pub fn new() -> Self {
        Self::with(Ipv4Addr::LOCALHOST, None, &[])
    }

    pub fn with(host: Ipv4Addr, token: Option<&str>, names: &[&str]) -> Self {
        let folder = Arc::new(tempfile::tempdir().unwrap());
        let store = StoreAddress::file(folder.path().join("store.sqlite"));
        Self::on(store, folder, host, token, names)
    }

    /// Another server with the same store.
    pub fn beside(&self) -> Self {
        Self::on(self.store.clone(), self.folder.clone(), Ipv4Addr::LOCALHOST, None, &[])
    }

    fn on(
        store: StoreAddress,
        folder: Arc<TempDir>,
        host: Ipv4Addr,
        token: Option<&str>,
        names: &[&str],
    ) -> Self {
        let options = Options {
            host: IpAddr::V4(host),
            port: 0,
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            token: token.map(str::to_owned),
            store: store.clone(),
        };
        let (told, listening) = mpsc::channel();
        thread::spawn(move || serve(&options, |addresses| drop(told.send(addresses[0].clone()))));
        let opened = listening.recv_timeout(Duration::from_secs(30)).expect("the server listens");
        let authority = opened.strip_prefix("http://").and_then(|rest| rest.split('/').next()).unwrap();
        let port = authority.rsplit(':').next().unwrap().parse().unwrap();
        let address = SocketAddr::new(Ipv4Addr::LOCALHOST.into(), port);
        Self { at: At(address), address, opened, store, folder }
    }
}

impl Deref for Served {
    type Target = At;

    fn deref(&self) -> &At {
        &self.at
    }
}
