//! The store on both databases: the same tests on files of SQLite and on a real PostgreSQL server, which `scripts/postgresql` starts on
//! loopback. Without a server these tests fail; `scripts/postgresql install` brings one.

mod addresses;
mod catalogue;
mod concurrent;
mod contents;
mod damaged;
mod histories;
mod killed;
mod made;
mod made_file;
mod measurements;
mod opening;
mod parts;
mod place;
mod plans;
mod runs;
mod server;
mod unreachable;
