//! The page and its interface over HTTP, for this machine.

mod calls;
mod gate;
mod limits;
mod random;
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
use limits::Limits;
use random::random_digits;
use service::Service;

/// Where it listens unless told otherwise: this machine alone.
pub const LOOPBACK: Ipv4Addr = Ipv4Addr::LOCALHOST;
/// Rest after a connection could not be taken, as when there are too many files open.
const REST: Duration = Duration::from_millis(50);

/// A server that is bound to its port.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    token: String,
    named: Arc<Named>,
}

impl Server {
    /// Takes a port; 0 is any that is free.
    ///
    /// # Errors
    /// When the address cannot be had, or the system gives no random numbers.
    pub fn bind(address: SocketAddr, named: Named) -> io::Result<Self> {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        Ok(Self {
            address: listener.local_addr()?,
            listener,
            token: random_digits()?,
            named: Arc::new(named),
        })
    }

    /// The address of the page. Whoever has it can ask.
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
    /// When the system gives no means to.
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
            // Answers are written whole: nothing is gained by waiting for more. Should this fail, they only come later.
            let _ = stream.set_nodelay(true);
            let service = Arc::clone(&service);
            tokio::spawn(async move {
                let answer = service_fn(|request| service.answer(request));
                // What becomes of a connection is the client's business.
                let _ = http1::Builder::new()
                    .timer(TokioTimer::new())
                    .header_read_timeout(limits::HEADER_TIME)
                    .max_headers(limits::HEADERS)
                    .max_buf_size(limits::HEADER_BYTES)
                    .serve_connection(TokioIo::new(stream), answer)
                    .await;
                drop(place);
            });
        }
    }
}
