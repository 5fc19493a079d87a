//! A connection whose client has to read what is written to it.

use std::io::{self, IoSlice};
use std::pin::Pin;
use std::task::{Context, Poll};

use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};
use tokio::net::TcpStream;
use tokio::time::{Sleep, sleep};

use super::limits::WRITE_TIME;

/// A stream on which everything written until a flush must be taken by the client within [`WRITE_TIME`].
#[derive(Debug)]
pub struct Impatient {
    stream: TcpStream,
    /// Runs while the client does not take what is written.
    limit: Option<Pin<Box<Sleep>>>,
}

impl Impatient {
    /// Waits for the client of a stream.
    pub fn of(stream: TcpStream) -> Self {
        Self {
            stream,
            limit: None,
        }
    }

    /// The result of writing, or a fault if the client has not read for too long.
    fn limited(
        &mut self,
        context: &mut Context<'_>,
        written: Poll<io::Result<usize>>,
    ) -> Poll<io::Result<usize>> {
        if written.is_ready() {
            return written;
        }
        let limit = (self.limit).get_or_insert_with(|| Box::pin(sleep(WRITE_TIME)));
        let is_over = limit.as_mut().poll(context);
        is_over.map(|()| Err(io::ErrorKind::TimedOut.into()))
    }
}

impl AsyncRead for Impatient {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        into: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(context, into)
    }
}

impl AsyncWrite for Impatient {
    fn poll_write(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<io::Result<usize>> {
        let written = Pin::new(&mut self.stream).poll_write(context, bytes);
        self.limited(context, written)
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        parts: &[IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        let written = Pin::new(&mut self.stream).poll_write_vectored(context, parts);
        self.limited(context, written)
    }

    /// Answers are then written from where they are: a copy would not count as unread.
    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    /// The server flushes once all is written, which ends the limit.
    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        self.limit = None;
        Pin::new(&mut self.stream).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(context)
    }
}

#[cfg(test)]
mod tests {
    use std::future::poll_fn;
    use std::io::Read;
    use std::net::{Ipv4Addr, TcpListener};
    use std::thread;

    use super::*;

    #[test]
    fn a_flush_ends_the_limit_and_a_shutdown_the_stream() {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let mut client = std::net::TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        client.set_read_timeout(Some(WRITE_TIME)).unwrap();
        let (server, _) = listener.accept().unwrap();
        server.set_nonblocking(true).unwrap();
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_all()
            .build()
            .unwrap();
        runtime.block_on(async {
            let mut stream = Impatient::of(TcpStream::from_std(server).unwrap());
            // Nobody reads: at some point the system takes no more.
            let mut sent = 0;
            poll_fn(|context| {
                loop {
                    match Pin::new(&mut stream).poll_write(context, &[0; 1 << 16]) {
                        Poll::Ready(written) => sent += written.unwrap(),
                        Poll::Pending => return Poll::Ready(()),
                    }
                }
            })
            .await;
            assert!(stream.limit.is_some());
            let reading = thread::spawn(move || {
                let mut taken = Vec::new();
                client.read_to_end(&mut taken).map(|_| taken.len())
            });
            poll_fn(|context| Pin::new(&mut stream).poll_flush(context))
                .await
                .unwrap();
            assert!(stream.limit.is_none());
            poll_fn(|context| Pin::new(&mut stream).poll_shutdown(context))
                .await
                .unwrap();
            // The stream is still open here: it was the shutdown that told the client of the end.
            assert_eq!(reading.join().unwrap().unwrap(), sent);
            drop(stream);
        });
    }
}
