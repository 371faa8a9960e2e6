//! The server as a browser sees it: a real one on the loopback, asked over sockets.

mod client;
mod description;
mod http;
mod interface;
mod jobs;
mod measurements;
mod runs;
mod security;
