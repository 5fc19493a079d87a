//! Access control: only requests with the token and from a page of this server pass. Tokens and nonces are random.

use std::io;
use std::net::{IpAddr, SocketAddr};

use hyper::header::{HOST, HeaderMap, ORIGIN};
use rand::TryRng;
use rand::rngs::SysRng;

/// Headers in which browsers state where a request comes from and what for.
const FETCH_SITE: &str = "sec-fetch-site";
const FETCH_DEST: &str = "sec-fetch-dest";

/// Number of bytes of a token.
const BYTES: usize = 16;

/// Requirements on requests.
#[derive(Debug)]
pub struct Gate {
    token: String,
    address: SocketAddr,
}

impl Gate {
    /// A gate for requests to this address with this token.
    pub fn new(token: String, address: SocketAddr) -> Self {
        Self { token, address }
    }

    /// True if other machines may ask.
    pub fn listens_beyond(&self) -> bool {
        !self.address.ip().is_loopback()
    }

    /// The path behind the token, if the request may pass.
    pub fn admit<'p>(&self, headers: &HeaderMap, path: &'p str) -> Option<&'p str> {
        let (token, rest) = path.strip_prefix('/')?.split_once('/')?;
        let may_pass = is_same(token, &self.token) && self.is_own(headers);
        may_pass.then_some(rest)
    }

    /// True if a request is meant for this server and comes from one of its pages: neither from another site, unless
    /// somebody follows a link there, nor to a foreign name that resolves here.
    fn is_own(&self, headers: &HeaderMap) -> bool {
        let text = |name: &str| headers.get(name).map(|value| value.to_str().unwrap_or("?"));
        let Some(host) = text(HOST.as_str()).filter(|host| self.is_own_host(host)) else {
            return false;
        };
        let is_single = headers.get_all(HOST).iter().count() == 1;
        let is_own_origin = match text(ORIGIN.as_str()) {
            None => true,
            Some(origin) => origin.strip_prefix("http://") == Some(host),
        };
        let is_own_site = match text(FETCH_SITE) {
            None => true,
            Some(site) => ["same-origin", "none"].contains(&site) || opens_a_page(headers),
        };
        is_single && is_own_origin && is_own_site
    }

    /// True for names of this server: a numeric address or localhost, with its port.
    fn is_own_host(&self, host: &str) -> bool {
        if let Ok(named) = host.parse::<SocketAddr>() {
            let is_reached: bool = match named.ip() {
                ip if ip == self.address.ip() => true,
                IpAddr::V4(ip) if ip.is_loopback() => true,
                IpAddr::V6(ip) if ip.is_loopback() => true,
                _ => self.listens_beyond(),
            };
            return is_reached && named.port() == self.address.port();
        }
        host == format!("localhost:{}", self.address.port())
    }
}

/// True if a browser asks for what it will show as a page of its own.
pub fn opens_a_page(headers: &HeaderMap) -> bool {
    headers
        .get(FETCH_DEST)
        .is_some_and(|dest| dest == "document")
}

/// Compares in a time that does not depend on how much agrees.
fn is_same(given: &str, token: &str) -> bool {
    let bytes = given.bytes().zip(token.bytes());
    let different = bytes.fold(0, |different, (a, b)| different | (a ^ b));
    given.len() == token.len() && different == 0
}

/// Unguessable digits for tokens and nonces, hexadecimal, from the random numbers of the system.
///
/// # Errors
/// If the system provides none.
pub fn random_digits() -> io::Result<String> {
    let mut bytes = [0; BYTES];
    SysRng
        .try_fill_bytes(&mut bytes)
        .map_err(io::Error::other)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use hyper::header::{HeaderName, HeaderValue};

    fn admits(listen: &str, path: &str, headers: &[(&str, &str)]) -> bool {
        let gate = Gate::new("secret".to_owned(), listen.parse().unwrap());
        let mut map = HeaderMap::new();
        for (name, value) in headers {
            let name: HeaderName = name.parse().unwrap();
            map.append(name, HeaderValue::from_str(value).unwrap());
        }
        gate.admit(&map, path) == Some("api/inputs")
    }

    #[test]
    fn only_own_pages_with_the_token_pass() {
        const OWN: &str = "127.0.0.1:8000";
        let path = "/secret/api/inputs";
        let host = ("host", OWN);
        assert!(admits(OWN, path, &[host]));
        assert!(admits(OWN, path, &[("host", "localhost:8000")]));
        assert!(admits(OWN, path, &[("host", "[::1]:8000")]));
        assert!(admits(
            OWN,
            path,
            &[host, ("origin", "http://127.0.0.1:8000")]
        ));
        assert!(admits(
            OWN,
            path,
            &[host, ("sec-fetch-site", "same-origin")]
        ));
        let link = [
            ("sec-fetch-site", "cross-site"),
            ("sec-fetch-dest", "document"),
        ];
        assert!(admits(OWN, path, &[host, link[0], link[1]]));
        for headers in [
            &[][..],
            &[("host", "127.0.0.1:8001")],
            &[("host", "127.0.0.1")],
            &[("host", "evil.example:8000")],
            &[("host", "192.168.0.7:8000")],
            &[host, host],
            &[host, ("origin", "null")],
            &[host, ("origin", "https://127.0.0.1:8000")],
            &[host, ("origin", "http://localhost:8000")],
            &[host, ("origin", "http://evil.example")],
            &[host, ("sec-fetch-site", "cross-site")],
            &[host, ("sec-fetch-site", "same-site")],
            &[host, link[0], ("sec-fetch-dest", "iframe")],
            &[host, link[0], link[1], ("origin", "http://evil.example")],
        ] {
            assert!(!admits(OWN, path, headers), "{headers:?}");
        }
        for path in [
            "/",
            "/secret",
            "/secre/api/inputs",
            "/secrets/api/inputs",
            "//api/inputs",
            "api/inputs",
        ] {
            assert!(!admits(OWN, path, &[host]), "{path}");
        }
    }

    #[test]
    fn whoever_listens_beyond_this_machine_is_asked_by_address() {
        let path = "/secret/api/inputs";
        assert!(admits("0.0.0.0:80", path, &[("host", "192.168.0.7:80")]));
        assert!(!admits("0.0.0.0:80", path, &[("host", "evil.example:80")]));
    }
}
