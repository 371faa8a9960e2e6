//! Who may speak to the server. A page of another origin must not, even where a name was bent to this machine (DNS rebinding); off the
//! loopback a token is needed. Knows no request in particular.

use std::net::SocketAddr;
use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::header::{AUTHORIZATION, COOKIE, HOST, LOCATION, ORIGIN, SET_COOKIE};
use axum::http::{HeaderMap, Method, StatusCode};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};
use subtle::ConstantTimeEq;

/// The cookie in which a browser keeps the token.
const COOKIE_NAME: &str = "flankwright";

/// What is allowed.
#[derive(Debug)]
pub struct Gate {
    /// Names and ports under which the server may be addressed, in small letters.
    hosts: Vec<String>,
    token: Option<String>,
}

impl Gate {
    /// For a server that listens at `address`, under further names, with a token or, on the loopback, without.
    pub fn new(address: SocketAddr, names: &[String], token: Option<String>) -> Arc<Self> {
        let port = address.port();
        let mut hosts = vec![address.to_string(), format!("localhost:{port}")];
        if address.ip().is_loopback() {
            hosts.extend([format!("127.0.0.1:{port}"), format!("[::1]:{port}")]);
        }
        hosts.extend(names.iter().map(|name| format!("{}:{port}", name.to_lowercase())));
        // A browser leaves the port of the scheme out.
        if port == 80 {
            let bare: Vec<String> =
                hosts.iter().filter_map(|host| Some(host.strip_suffix(":80")?.to_owned())).collect();
            hosts.extend(bare);
        }
        Arc::new(Self { hosts, token })
    }

    fn is_own(&self, host: &str) -> bool {
        self.hosts.iter().any(|own| own.eq_ignore_ascii_case(host))
    }

    /// Why a request is not answered.
    fn refusal(&self, method: &Method, headers: &HeaderMap) -> Option<(StatusCode, &'static str)> {
        let text = |name| headers.get(name).and_then(|value: &axum::http::HeaderValue| value.to_str().ok());
        let Some(host) = text(HOST) else {
            return Some((StatusCode::BAD_REQUEST, "the request names no host"));
        };
        if !self.is_own(host) {
            return Some((
                StatusCode::MISDIRECTED_REQUEST,
                "the server is not known under this name; see `--host`",
            ));
        }
        if let Some(origin) = headers.get(ORIGIN) {
            let own = origin.to_str().ok().and_then(|origin| origin.strip_prefix("http://"));
            if !own.is_some_and(|origin| self.is_own(origin)) {
                return Some((StatusCode::FORBIDDEN, "the request comes from a page of another origin"));
            }
        } else if !method.is_safe()
            && text("sec-fetch-site".parse().ok()?).is_some_and(|site| site != "same-origin")
        {
            return Some((StatusCode::FORBIDDEN, "the request comes from a page of another origin"));
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
        let text = |name| headers.get(name).and_then(|value: &axum::http::HeaderValue| value.to_str().ok());
        let bearer = text(AUTHORIZATION).and_then(|value| value.strip_prefix("Bearer "));
        let cookies = headers.get_all(COOKIE).iter().filter_map(|value| value.to_str().ok());
        let mut kept = cookies
            .flat_map(|value| value.split(';'))
            .filter_map(|pair| pair.trim().split_once('='))
            .filter(|(name, _)| *name == COOKIE_NAME)
            .map(|(_, value)| value);
        bearer.is_some_and(|token| self.is_token(token)) || kept.any(|token| self.is_token(token))
    }
}

/// Lets a request in, or says why not. `/?token=...` takes the token into a cookie, so that it does not stay in the address.
pub async fn guard(State(gate): State<Arc<Gate>>, request: Request, next: Next) -> Response {
    if let Some((status, why)) = gate.refusal(request.method(), request.headers()) {
        return (status, why).into_response();
    }
    if gate.is_known(request.headers()) {
        return next.run(request).await;
    }
    let given = request.uri().query().and_then(|query| query.strip_prefix("token="));
    if request.uri().path() == "/" && given.is_some_and(|token| gate.is_token(token)) {
        let cookie =
            format!("{COOKIE_NAME}={}; HttpOnly; SameSite=Strict; Path=/", given.unwrap_or_default());
        return (StatusCode::SEE_OTHER, [(SET_COOKIE, cookie), (LOCATION, "/".to_owned())]).into_response();
    }
    (StatusCode::UNAUTHORIZED, "this server asks for its token: open the address that it printed")
        .into_response()
}
