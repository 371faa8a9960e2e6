//! Where a store is: a file of SQLite or a PostgreSQL server. Shows itself without what is secret; opens nothing.

use std::fmt;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use sqlx::postgres::PgConnectOptions;

use crate::error::StoreError;

/// What an address may look like, in words.
const FORMS: &str = "`sqlite:PATH`, a plain path, or `postgres://USER:PASSWORD@HOST:PORT/DATABASE`";

/// What is most often wrong with the address of a server.
const UNWRITTEN: &str = "it is no address of a PostgreSQL server; characters such as / ? # @ : in a name or a password are written \
    %2F %3F %23 %40 %3A";

/// The address of a store. Neither `Display` nor `Debug` shows a password.
#[derive(Clone)]
pub struct StoreAddress(pub(crate) Place);

/// The two kinds of databases.
#[derive(Clone)]
pub(crate) enum Place {
    /// A file.
    Sqlite(PathBuf),
    /// A server; the text is the address without its secrets.
    Postgres { options: Box<PgConnectOptions>, shown: String },
}

impl StoreAddress {
    /// The environment variable that names a store, so that a password need not stand in a command line.
    pub const VARIABLE: &str = "FLANKWRIGHT_STORE";

    /// A file of SQLite.
    pub fn file(path: impl Into<PathBuf>) -> Self {
        Self(Place::Sqlite(path.into()))
    }

    /// The user's own store: `flankwright/store.sqlite` in `$XDG_DATA_HOME`, or in `~/.local/share` where that is not set.
    ///
    /// # Errors
    /// `no-data-directory` where the surroundings name neither.
    pub fn of_user() -> Result<Self, StoreError> {
        let absolute =
            |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
        let data =
            absolute("XDG_DATA_HOME").or_else(|| absolute("HOME").map(|home| home.join(".local/share")));
        let data = data.ok_or(StoreError::NoDataDirectory)?;
        Ok(Self::file(data.join("flankwright/store.sqlite")))
    }

    /// The store that a program uses: the given address, else that in the environment variable [`StoreAddress::VARIABLE`], else the user's
    /// own.
    ///
    /// # Errors
    /// `invalid-store-address`, `no-data-directory`.
    pub fn chosen(given: Option<&str>) -> Result<Self, StoreError> {
        match (given, std::env::var(Self::VARIABLE)) {
            (Some(text), _) => text.parse(),
            (None, Ok(text)) if !text.is_empty() => text.parse(),
            (None, Err(std::env::VarError::NotUnicode(path))) => Ok(Self::file(path)),
            _ => Self::of_user(),
        }
    }

    /// The file of SQLite; `None` for a server.
    pub fn path(&self) -> Option<&Path> {
        match &self.0 {
            Place::Sqlite(path) => Some(path),
            Place::Postgres { .. } => None,
        }
    }
}

/// `sqlite:PATH`, a plain path, or `postgres://...` with everything that PostgreSQL's own addresses may have.
impl FromStr for StoreAddress {
    type Err = StoreError;

    fn from_str(text: &str) -> Result<Self, StoreError> {
        let invalid = |reason: &str| {
            Err(StoreError::InvalidAddress { address: without_secrets(text), reason: reason.to_owned() })
        };
        if text.contains('\0') {
            return invalid("it has a character NUL");
        }
        let scheme = text.split_once("://").map(|(scheme, _)| scheme);
        if matches!(scheme, Some("postgres" | "postgresql")) {
            let beyond = text.splitn(4, ['/', '?', '#']).nth(3).unwrap_or_default();
            if beyond.contains('@') {
                // Most likely a password that would be taken for host and database.
                return invalid(UNWRITTEN);
            }
            // What the parser says may quote what it did not understand, a password among it.
            let Ok(options) = text.parse::<PgConnectOptions>() else {
                return invalid(UNWRITTEN);
            };
            return Ok(Self(Place::Postgres { options: Box::new(options), shown: without_secrets(text) }));
        }
        let path = match (text.strip_prefix("sqlite:"), scheme) {
            (Some(rest), _) => rest.strip_prefix("//").unwrap_or(rest),
            (None, Some(_)) => return invalid(&format!("its kind is not known; take {FORMS}")),
            (None, None) => text,
        };
        match path {
            "" => invalid("it names no file"),
            ":memory:" => invalid("a store in memory would not outlive the run"),
            _ => Ok(Self::file(path)),
        }
    }
}

impl StoreAddress {
    /// By which a store is distinguished from others on this machine, however it was named. A file has to be there already.
    pub fn identity(&self) -> String {
        match &self.0 {
            Place::Sqlite(path) => {
                std::fs::canonicalize(path).unwrap_or_else(|_| path.clone()).display().to_string()
            }
            Place::Postgres { shown, .. } => shown.clone(),
        }
    }
}

impl fmt::Display for StoreAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Place::Sqlite(path) => write!(f, "{}", path.display()),
            Place::Postgres { shown, .. } => f.write_str(shown),
        }
    }
}

impl fmt::Debug for StoreAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "StoreAddress({self})")
    }
}

/// An address without password and parameters, whatever else is wrong with it: everything from the first colon behind the kind to the
/// last @ goes, and everything from a question mark on.
fn without_secrets(text: &str) -> String {
    let Some((scheme, rest)) = text.split_once("://") else { return text.to_owned() };
    let (user, rest) = match rest.rsplit_once('@') {
        Some((secret, rest)) => {
            (secret.split([':', '/', '?', '#']).next().map(|user| format!("{user}@")), rest)
        }
        None => (None, rest),
    };
    let rest = rest.split(['?', '#']).next().unwrap_or_default();
    format!("{scheme}://{}{rest}", user.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> StoreAddress {
        text.parse().unwrap_or_else(|error| panic!("{text}: {error}"))
    }

    #[test]
    fn files_are_named_in_three_ways() {
        for (text, path) in [
            ("store.sqlite", "store.sqlite"),
            ("/a b/ö.sqlite", "/a b/ö.sqlite"),
            ("sqlite:store.sqlite", "store.sqlite"),
            ("sqlite:/a/store.sqlite?x=1", "/a/store.sqlite?x=1"),
            ("sqlite:///a/store.sqlite", "/a/store.sqlite"),
        ] {
            assert_eq!(parsed(text).path(), Some(Path::new(path)), "{text}");
            assert_eq!(parsed(text).to_string(), path);
        }
    }

    #[test]
    fn what_is_no_address_is_refused() {
        for text in [
            "",
            "sqlite:",
            "sqlite://",
            "sqlite::memory:",
            ":memory:",
            "mysql://h/d",
            "a\0b",
            "postgres://h:port/d",
        ] {
            let error = text.parse::<StoreAddress>().unwrap_err();
            assert_eq!(error.code(), "invalid-store-address", "{text:?}: {error}");
        }
    }

    #[test]
    fn secrets_are_never_shown() {
        for text in [
            "postgres://shop:geheim@host:5432/gears",
            "postgres://shop:geheim@host/gears?password=geheim",
            "postgresql://shop@host/gears?password=geheim",
            "postgres://shop:geh%2Feim%40geheim@host/gears",
            "postgres://shop:geheim@geheim@host:wrong/gears",
            "postgres://shop:1/geheim@host/gears",
            "postgres://shop:ge?geheim@host/gears",
            "mysql://shop:geheim@host/gears",
        ] {
            let shown = match text.parse::<StoreAddress>() {
                Ok(address) => format!("{address} {address:?}"),
                Err(error) => format!("{error} {error:?} {}", error.way_out()),
            };
            assert!(shown.contains("://shop@host"), "{shown}");
            assert!(!shown.contains("geh") && !shown.contains("eim"), "{shown}");
        }
    }
}
