//! Handles single requests: through the gate, to the page or the interface.

use std::convert::Infallible;
use std::sync::Arc;

use http_body_util::{BodyExt, LengthLimitError, Limited};
use hyper::body::Incoming;
use hyper::header::CONTENT_TYPE;
use hyper::{Method, Request, StatusCode};
use tokio::time::timeout;

use super::calls;
use super::compressed;
use super::gate::{self, Gate, random_digits};
use super::limits::{BODY_BYTES, BODY_TIME, Limits};
use super::reply::{self, Reply};
use crate::interface::Complaint;
use crate::named::Named;
use crate::page::PageFile;

/// Path of the interface.
const API: &str = "api/";

/// State shared by all connections.
#[derive(Debug)]
pub struct Service {
    /// Access control.
    pub gate: Gate,
    /// The named inputs.
    pub named: Arc<Named>,
    /// Resource limits.
    pub limits: Limits,
}

impl Service {
    /// Answers a request.
    ///
    /// # Errors
    /// None: every answer is a reply.
    pub async fn answer(&self, request: Request<Incoming>) -> Result<Reply, Infallible> {
        Ok(self.reply(request).await)
    }

    async fn reply(&self, request: Request<Incoming>) -> Reply {
        let path = request.uri().path().to_owned();
        let Some(path) = self.gate.admit(request.headers(), &path) else {
            let is_page = gate::opens_a_page(request.headers());
            return reply::turned_away(self.limits.strangers.allow(), is_page);
        };
        if !self.limits.admitted.allow() {
            return reply::too_often();
        }
        let method = request.method();
        let takes_gzip = compressed::is_taken(request.headers());
        match (path.strip_prefix(API), PageFile::at(path)) {
            (Some(name), _) if method == Method::POST => self.call(name, request).await,
            (None, Some(file)) if method == Method::GET => match random_digits() {
                Ok(nonce) => reply::file(file, &nonce, takes_gzip),
                Err(error) => reply::complaint(&Complaint::engine(error)),
            },
            (None, None) => reply::refusal(StatusCode::NOT_FOUND, "there is no such file"),
            _ => {
                let said = "expected GET for files and POST for requests of the interface";
                reply::refusal(StatusCode::METHOD_NOT_ALLOWED, said)
            }
        }
    }

    async fn call(&self, name: &str, request: Request<Incoming>) -> Reply {
        // On this machine it takes longer to compress than to send.
        let compresses = self.gate.listens_beyond() && compressed::is_taken(request.headers());
        let media_type = request.headers().get(CONTENT_TYPE);
        let media_type = media_type
            .and_then(|value| value.to_str().ok())
            .unwrap_or_default();
        if media_type.split(';').next() != Some("application/json") {
            let said = "expected the header Content-Type: application/json";
            return reply::refusal(StatusCode::UNSUPPORTED_MEDIA_TYPE, said);
        }
        let body = Limited::new(request.into_body(), BODY_BYTES).collect();
        let body = match timeout(BODY_TIME, body).await {
            Ok(Ok(body)) => body.to_bytes(),
            Ok(Err(error)) if error.is::<LengthLimitError>() => {
                let said = format!("expected a request of at most {BODY_BYTES} bytes");
                return reply::refusal(StatusCode::PAYLOAD_TOO_LARGE, &said);
            }
            Ok(Err(_)) => {
                return reply::refusal(StatusCode::BAD_REQUEST, "the request broke off");
            }
            Err(_) => {
                return reply::refusal(
                    StatusCode::REQUEST_TIMEOUT,
                    "the request took too long to come",
                );
            }
        };
        let Ok(body) = String::from_utf8(body.into()) else {
            return reply::refusal(StatusCode::BAD_REQUEST, "not a request: expected UTF-8");
        };
        calls::answer(&self.named, &self.limits, name, body, compresses).await
    }
}
