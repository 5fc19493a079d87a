//! Clients that ask and never read. The server waits for them for as long as it may, so this begins first: tests start by their names.

use std::io::Write;

use crate::common::Client;

#[test]
fn clients_that_ask_and_never_read_are_left() {
    let client = Client::start();
    // Without the token one answer ends a connection, so that nothing piles up.
    let strange = client
        .call("landing", "{}")
        .replacen(&client.token, &"0".repeat(32), 1);
    let strange = strange.replace("Connection: close", "Connection: keep-alive");
    let (status, told) = client.send(&strange.repeat(3));
    assert_eq!(status, 404);
    assert_eq!(told.matches("HTTP/1.1").count(), 1, "{told}");
    // With it, more connections than there may be at once ask for more than any socket holds.
    let asking = client.call("landing", r#"{"interval_s": 0.001}"#);
    let asking = asking
        .replace("Connection: close", "Connection: keep-alive")
        .repeat(8);
    let page = format!(
        "GET /{}/vendor/three.js HTTP/1.1\r\nHost: {}\r\n\r\n",
        client.token, client.address
    )
    .repeat(8);
    let deaf: Vec<_> = (0..530)
        .map(|index| {
            let mut stream = client.connect();
            let call = if index % 20 == 0 { &asking } else { &page };
            let _ = stream.write_all(call.as_bytes());
            stream
        })
        .collect();
    assert!(client.is_alive());
    drop(deaf);
}
