//! `flankwright serve`: the web application.

use std::net::{IpAddr, Ipv4Addr};

use clap::Args;
use flankwright::exchange::Diagnostic;
use flankwright_server::{Options, PORT, ServeError, serve};
use serde_json::json;

use super::store::place::{PlaceArguments, failed};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output;

/// The environment variable that holds the token, so that it need not stand in a command line.
const TOKEN: &str = "FLANKWRIGHT_TOKEN";
/// Characters of the shortest token.
const SHORTEST_TOKEN: usize = 16;

/// Arguments of `serve`.
#[derive(Args, Debug)]
#[command(
    after_help = "Example:\n  flankwright serve\n  flankwright serve --host 0.0.0.0 --name panel-17.shop\n\n\
    Listens at 127.0.0.1 by default. Anywhere else a token is needed: it is made and printed as a part of the address, or taken \
    from FLANKWRIGHT_TOKEN (letters, digits, - and _, at least 16). Ctrl-C ends it; runs under way are then listed as interrupted."
)]
pub struct ServeArguments {
    /// Address to listen at
    #[arg(long, value_name = "ADDRESS", default_value_t = IpAddr::V4(Ipv4Addr::LOCALHOST))]
    pub host: IpAddr,
    /// Port to listen at; 0 takes a free one
    #[arg(long, default_value_t = PORT)]
    pub port: u16,
    /// A further name under which the server may be addressed; may be repeated
    #[arg(long = "name", value_name = "NAME")]
    pub names: Vec<String>,
    /// Where runs and parts are kept, and arguments that every command has.
    #[command(flatten)]
    pub place: PlaceArguments,
}

/// Serves until Ctrl-C.
///
/// # Errors
/// A token that is none, an address that cannot be listened at, a store that cannot be opened.
pub fn run(arguments: &ServeArguments) -> Result<Exit, Failure> {
    let options = Options {
        host: arguments.host,
        port: arguments.port,
        names: arguments.names.clone(),
        token: token()?,
        store: arguments.place.address().map_err(failed)?,
    };
    let common = &arguments.place.common;
    let made = options.token.is_none() && !arguments.host.is_loopback();
    let told = |addresses: &[String]| {
        let text = if common.json {
            json!({ "address": addresses[0], "addresses": addresses }).to_string() + "\n"
        } else if common.quiet && made {
            // Without the token that was made, no client is admitted.
            format!("{}\n", addresses[0])
        } else if common.quiet {
            String::new()
        } else {
            let elsewhere =
                "  from elsewhere under any address of this machine in figures, and under names of --name\n";
            let elsewhere = if arguments.host.is_unspecified() { elsewhere } else { "" };
            format!("flankwright is at {}\n{elsewhere}  Ctrl-C ends it\n", addresses.join("\n  and at "))
        };
        // If the address cannot be printed, the server runs all the same.
        drop(output::print(&text));
    };
    match serve(&options, told) {
        Ok(()) => Ok(Exit::Done),
        Err(ServeError::Store(error)) => Err(failed(error)),
        Err(error @ ServeError::Listen { .. }) => {
            let finding = Diagnostic::with_code("address-not-available", error.to_string())
                .field("--host, --port")
                .value(format!("{}:{}", arguments.host, arguments.port))
                .way_out("choose another port with --port, or end the program that listens there");
            Err(Failure::new(Exit::BadInput, finding))
        }
        Err(error) => Err(Failure::internal(error.to_string())),
    }
}

fn token() -> Result<Option<String>, Failure> {
    let Some(given) = std::env::var_os(TOKEN).filter(|given| !given.is_empty()) else { return Ok(None) };
    let plain = |text: &&str| {
        text.len() >= SHORTEST_TOKEN
            && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_')
    };
    match given.to_str().filter(plain) {
        Some(token) => Ok(Some(token.to_owned())),
        None => {
            let finding =
                Diagnostic::with_code("invalid-token", "the token is too short or has other characters")
                    .field(TOKEN)
                    .allowed(format!("letters, digits, - and _, at least {SHORTEST_TOKEN} of them"))
                    .way_out("leave it out: the server makes one and prints it");
            Err(Failure::new(Exit::BadInput, finding))
        }
    }
}
