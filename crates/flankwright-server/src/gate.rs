//! Who may speak to the server. A page of another origin must not, even where a name was bent to this machine (DNS rebinding); off the
//! loopback a token is needed. Knows no request in particular.

use std::net::{IpAddr, SocketAddr};
use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::header::{AUTHORIZATION, COOKIE, HOST, LOCATION, ORIGIN, SET_COOKIE};
use axum::http::{HeaderMap, HeaderName, HeaderValue, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use subtle::ConstantTimeEq;

use crate::api::error::Refused;

/// How the cookie in which a browser keeps the token begins; the port follows, by which browsers do not tell cookies apart.
const COOKIE_NAME: &str = "flankwright";
/// Where requests of scripts go; nothing there is opened from a page of somebody else.
const API: &str = "/api/";

/// What is allowed.
#[derive(Debug)]
pub struct Gate {
    /// Names and ports under which the server may be addressed, in small letters.
    hosts: Vec<String>,
    /// The port, where the server listens at all addresses of the machine: any of them may be meant.
    any_address: Option<u16>,
    /// Names and ports to open, the first one on this machine.
    authorities: Vec<String>,
    cookie: String,
    token: Option<String>,
}

impl Gate {
    /// For a server that listens at `address`, under further names (with a port where it is not the server's own, as behind a proxy),
    /// with a token or, on the loopback, without.
    pub fn new(address: SocketAddr, names: &[String], token: Option<String>) -> Arc<Self> {
        let port = address.port();
        let named: Vec<String> = names
            .iter()
            .map(|name| name.to_lowercase())
            .map(|name| match name.rsplit_once(':') {
                Some((_, own)) if own.parse::<u16>().is_ok() => name,
                _ => format!("{name}:{port}"),
            })
            .collect();
        // Nobody can open the address that stands for all of them.
        let own =
            if address.ip().is_unspecified() { format!("localhost:{port}") } else { address.to_string() };
        let authorities: Vec<String> = [own].into_iter().chain(named).collect();
        let mut hosts = vec![address.to_string(), format!("localhost:{port}")];
        if address.ip().is_loopback() {
            hosts.extend([format!("127.0.0.1:{port}"), format!("[::1]:{port}")]);
        }
        hosts.extend_from_slice(&authorities);
        // A browser leaves the port of the scheme out.
        let bare: Vec<String> = hosts
            .iter()
            .filter_map(|host| host.strip_suffix(":80").or(host.strip_suffix(":443")))
            .map(str::to_owned)
            .collect();
        hosts.extend(bare);
        let any_address = address.ip().is_unspecified().then_some(port);
        Arc::new(Self { hosts, any_address, authorities, cookie: format!("{COOKIE_NAME}-{port}"), token })
    }

    /// Names and ports to open, the first one on this machine.
    pub fn authorities(&self) -> &[String] {
        &self.authorities
    }

    /// Whether a request may be meant for this server. An address in figures was not looked up, so that no name server can have redirected it.
    fn is_own(&self, host: &str) -> bool {
        let listed = self.hosts.iter().any(|own| own.eq_ignore_ascii_case(host));
        let bare = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(host);
        let figures = |port| match host.parse::<SocketAddr>() {
            Ok(of) => of.port() == port,
            // A browser leaves the port of the scheme out.
            Err(_) => [80, 443].contains(&port) && bare.parse::<IpAddr>().is_ok(),
        };
        listed || self.any_address.is_some_and(figures)
    }

    /// Why a request is not answered.
    fn refusal(&self, request: &Request) -> Option<(StatusCode, &'static str)> {
        let headers = request.headers();
        let text = |name: HeaderName| headers.get(name).and_then(|value: &HeaderValue| value.to_str().ok());
        let Some(host) = text(HOST) else {
            return Some((StatusCode::BAD_REQUEST, "the request names no host"));
        };
        if !self.is_own(host) {
            return Some((
                StatusCode::MISDIRECTED_REQUEST,
                "the server is not known under this name: start it with --name",
            ));
        }
        let other = Some((StatusCode::FORBIDDEN, "the request comes from a page of another origin"));
        match headers.get(ORIGIN) {
            Some(origin) => {
                let origin = origin.to_str().unwrap_or_default();
                let authority = origin.strip_prefix("http://").or_else(|| origin.strip_prefix("https://"));
                if authority.is_none_or(|authority| !authority.eq_ignore_ascii_case(host)) {
                    return other;
                }
            }
            None => {
                // Whoever opens a page by its address comes from nowhere.
                let site = text(HeaderName::from_static("sec-fetch-site"));
                let foreign = site.is_some_and(|site| site != "same-origin");
                let opened = request.method().is_safe()
                    && (site == Some("none") || !request.uri().path().starts_with(API));
                if foreign && !opened {
                    return other;
                }
            }
        }
        None
    }

    fn is_token(&self, given: &str) -> bool {
        self.token.as_ref().is_some_and(|token| token.as_bytes().ct_eq(given.as_bytes()).into())
    }

    fn is_known(&self, headers: &HeaderMap) -> bool {
        if self.token.is_none() {
            return true;
        }
        let text = |name| headers.get(name).and_then(|value: &HeaderValue| value.to_str().ok());
        let bearer = text(AUTHORIZATION).and_then(|value| value.strip_prefix("Bearer "));
        let cookies = headers.get_all(COOKIE).iter().filter_map(|value| value.to_str().ok());
        let mut kept = cookies
            .flat_map(|value| value.split(';'))
            .filter_map(|pair| pair.trim().split_once('='))
            .filter(|(name, _)| *name == self.cookie)
            .map(|(_, value)| value);
        bearer.is_some_and(|token| self.is_token(token)) || kept.any(|token| self.is_token(token))
    }
}

/// Lets a request in, or says why not. `/?token=...` takes the token into a cookie, so that it does not stay in the address.
pub async fn guard(State(gate): State<Arc<Gate>>, request: Request, next: Next) -> Response {
    if let Some((status, why)) = gate.refusal(&request) {
        let way_out = "open the address that the server has printed";
        return Refused::with(status, "not-admitted", why, way_out).into_response();
    }
    let given = request.uri().query().and_then(|query| query.strip_prefix("token="));
    if let Some(token) = given.filter(|token| request.uri().path() == "/" && gate.is_token(token)) {
        // Lax: who follows a link to a run from elsewhere is known, but what pages of others load or send is not.
        let cookie = format!("{}={token}; HttpOnly; SameSite=Lax; Path=/", gate.cookie);
        return (StatusCode::SEE_OTHER, [(SET_COOKIE, cookie), (LOCATION, "/".to_owned())]).into_response();
    }
    if gate.is_known(request.headers()) {
        return next.run(request).await;
    }
    let told = "this server asks for its token: open the address that it printed";
    if request.uri().path().starts_with(API) {
        let way_out =
            "send it as `Authorization: Bearer ...`, or open the address that the server has printed";
        return Refused::with(StatusCode::UNAUTHORIZED, "token-needed", told, way_out).into_response();
    }
    (StatusCode::UNAUTHORIZED, told).into_response()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_browser_leaves_the_port_of_the_scheme_out() {
        let own = |address: &str, host: &str| Gate::new(address.parse().unwrap(), &[], None).is_own(host);
        for host in ["192.168.0.7", "[fd00::7]", "192.168.0.7:80", "localhost"] {
            assert!(own("0.0.0.0:80", host), "{host}");
        }
        for host in ["evil.example", "192.168.0.7:81", "192.168.0.7.evil.example"] {
            assert!(!own("0.0.0.0:80", host), "{host}");
        }
        assert!(!own("0.0.0.0:8470", "192.168.0.7") && own("0.0.0.0:8470", "192.168.0.7:8470"));
    }
}
