//! Serves the page and its interface over HTTP on this machine.

mod calls;
mod compressed;
mod gate;
mod impatient;
mod limits;
mod reply;
mod service;

use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::sync::Arc;
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::runtime::Builder;
use tokio::sync::Semaphore;

use crate::named::Named;

use gate::Gate;
use impatient::Impatient;
use limits::Limits;
use service::Service;

pub use gate::random_digits;

/// Default address: this machine only.
pub const LOOPBACK: Ipv4Addr = Ipv4Addr::LOCALHOST;
/// Pause after a connection could not be accepted, e.g. with too many open files.
const REST: Duration = Duration::from_millis(50);

/// A server bound to its port.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    token: String,
    named: Arc<Named>,
}

impl Server {
    /// Binds to a port; 0 selects a free one. Whoever has the token may ask.
    ///
    /// # Errors
    /// If the address is unavailable.
    pub fn bind(address: SocketAddr, named: Named, token: String) -> io::Result<Self> {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        Ok(Self {
            address: listener.local_addr()?,
            listener,
            token,
            named: Arc::new(named),
        })
    }

    /// Address of the page. Anyone who has it may send requests.
    pub fn url(&self) -> String {
        let mut address = self.address;
        if address.ip().is_unspecified() {
            address.set_ip(LOOPBACK.into());
        }
        format!("http://{address}/{}/", self.token)
    }

    /// Serves until the program ends.
    ///
    /// # Errors
    /// If the system cannot start the server.
    pub fn run(self) -> io::Result<()> {
        let limits = Limits::of_this_machine();
        let runtime = Builder::new_current_thread()
            .enable_all()
            .max_blocking_threads(limits.threads())
            .build()?;
        runtime.block_on(self.serve(limits))
    }

    async fn serve(self, limits: Limits) -> io::Result<()> {
        let listener = tokio::net::TcpListener::from_std(self.listener)?;
        let places = Arc::new(Semaphore::new(limits::CONNECTIONS));
        let service = Arc::new(Service {
            gate: Gate::new(self.token, self.address),
            named: self.named,
            limits,
        });
        loop {
            let Ok(place) = Arc::clone(&places).acquire_owned().await else {
                return Ok(());
            };
            let Ok((stream, _)) = listener.accept().await else {
                tokio::time::sleep(REST).await;
                continue;
            };
            // Answers are written in one piece, so there is no point in waiting for more. A failure only delays them.
            let _ = stream.set_nodelay(true);
            let service = Arc::clone(&service);
            tokio::spawn(async move {
                let answer = service_fn(|request| service.answer(request));
                // Failures of a connection concern only the client.
                let _ = http1::Builder::new()
                    .timer(TokioTimer::new())
                    .header_read_timeout(limits::HEADER_TIME)
                    .max_headers(limits::HEADERS)
                    .max_buf_size(limits::HEADER_BYTES)
                    .serve_connection(TokioIo::new(Impatient::of(stream)), answer)
                    .await;
                drop(place);
            });
        }
    }
}
