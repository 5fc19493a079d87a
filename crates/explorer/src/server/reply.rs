//! Replies, with headers that restrict the browser.

use http_body_util::Full;
use hyper::body::Bytes;
use hyper::header::{
    CACHE_CONTROL, CONNECTION, CONTENT_ENCODING, CONTENT_SECURITY_POLICY, CONTENT_TYPE,
    HeaderValue, REFERRER_POLICY, VARY, X_CONTENT_TYPE_OPTIONS,
};
use hyper::{Response, StatusCode};

use super::compressed;
use crate::interface::{Complaint, Fault};
use crate::page::PageFile;

/// A reply.
pub type Reply = Response<Full<Bytes>>;

const JSON: &str = "application/json";
const TEXT: &str = "text/plain; charset=utf-8";
/// Answer to a link that is not that of the explorer.
const NO_PAGE: &[u8] = b"There is no page at this address. touchdown explore prints its link when it starts: another one each time, \
    unless --port and --token-file keep it.\n";
/// Content policy of a page: only files of this server, and scripts in the page itself that carry its nonce.
const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval' NONCE; style-src 'self' 'unsafe-inline'; \
    img-src 'self' data: blob:; font-src 'self'; media-src blob:; connect-src 'self'; worker-src 'self' blob:; \
    base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// An answer of the interface, which may be compressed.
pub fn answer(json: Bytes, is_gzip: bool) -> Reply {
    let mut reply = reply(StatusCode::OK, JSON, json);
    if is_gzip {
        mark_gzip(&mut reply);
    }
    reply
}

/// The answer to whoever may not ask, or asks too often: a sentence for those who open a page. It is the last one of its
/// connection.
pub fn turned_away(is_within: bool, is_page: bool) -> Reply {
    let mut reply = match (is_within, is_page) {
        (true, true) => reply(StatusCode::NOT_FOUND, TEXT, Bytes::from_static(NO_PAGE)),
        (true, false) => refusal(StatusCode::NOT_FOUND, "there is nothing here"),
        (false, _) => too_often(),
    };
    (reply.headers_mut()).insert(CONNECTION, HeaderValue::from_static("close"));
    reply
}

/// An error reply of the interface.
pub fn complaint(complaint: &Complaint) -> Reply {
    let status = match complaint.fault {
        Fault::Request => StatusCode::BAD_REQUEST,
        Fault::Unknown => StatusCode::NOT_FOUND,
        Fault::Over => StatusCode::REQUEST_TIMEOUT,
        Fault::Engine => StatusCode::INTERNAL_SERVER_ERROR,
    };
    reply(status, JSON, Bytes::from(complaint.json()))
}

/// A refusal with another status.
pub fn refusal(status: StatusCode, said: &str) -> Reply {
    let body = Complaint::request(said).json();
    reply(status, JSON, Bytes::from(body))
}

/// The refusal of requests beyond the rate.
pub fn too_often() -> Reply {
    refusal(
        StatusCode::TOO_MANY_REQUESTS,
        "too many requests in a second",
    )
}

/// A file of the page, compressed where the client takes that. The page itself gets this nonce, which is used only once.
pub fn file(file: PageFile, nonce: &str, takes_gzip: bool) -> Reply {
    let text = std::str::from_utf8(file.bytes)
        .ok()
        .filter(|_| file.is_index());
    if let Some(text) = text {
        let page = text.replace("<script", &format!("<script nonce=\"{nonce}\""));
        let mut reply = reply(StatusCode::OK, file.media_type(), Bytes::from(page));
        let policy = POLICY.replace("NONCE", &format!("'nonce-{nonce}'"));
        if let Ok(policy) = HeaderValue::try_from(policy) {
            reply.headers_mut().insert(CONTENT_SECURITY_POLICY, policy);
        }
        return reply;
    }
    let packed = compressed::file(&file).filter(|_| takes_gzip || file.is_gzip);
    let is_gzip = packed.is_some();
    let bytes = packed.unwrap_or(Bytes::from_static(file.bytes));
    let mut reply = reply(StatusCode::OK, file.media_type(), bytes);
    if is_gzip {
        mark_gzip(&mut reply);
    }
    reply
}

fn mark_gzip(reply: &mut Reply) {
    let value = HeaderValue::from_static(compressed::GZIP);
    reply.headers_mut().insert(CONTENT_ENCODING, value);
}

fn reply(status: StatusCode, media_type: &'static str, body: Bytes) -> Reply {
    let mut reply = Response::new(Full::new(body));
    *reply.status_mut() = status;
    let headers = reply.headers_mut();
    if let Ok(policy) = HeaderValue::try_from(POLICY.replace("NONCE", "")) {
        headers.insert(CONTENT_SECURITY_POLICY, policy);
    }
    for (name, value) in [
        (CONTENT_TYPE, media_type),
        (CACHE_CONTROL, "no-store"),
        (REFERRER_POLICY, "no-referrer"),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (VARY, "Accept-Encoding"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    for name in ["cross-origin-opener-policy", "cross-origin-resource-policy"] {
        headers.insert(name, HeaderValue::from_static("same-origin"));
    }
    reply
}
