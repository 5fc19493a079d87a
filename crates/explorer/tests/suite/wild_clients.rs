//! Clients that mean no good, or do not know what they do.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::io::{Read, Write};
use std::net::Shutdown;
use std::thread;

use crate::common::Client;

#[test]
fn files_and_answers_come_with_their_protections() {
    let client = Client::start();
    let (token, address) = (&client.token, client.address);
    let get = |path: &str| {
        client.send(&format!(
            "GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n"
        ))
    };
    let (status, page) = get(&format!("/{token}/"));
    assert_eq!(status, 200);
    for header in [
        "content-security-policy: default-src 'none'",
        "x-content-type-options: nosniff",
        "referrer-policy: no-referrer",
        "cache-control: no-store",
    ] {
        assert!(page.contains(header), "{header} is not in {page}");
    }
    assert!(!page.to_lowercase().contains("access-control-allow"));
    for path in [
        "/",
        "/index.html",
        "/favicon.ico",
        &format!("/{token}"),
        "/wrong/",
        &format!("/{token}/../Cargo.toml"),
        &format!("/{token}/%2e%2e/Cargo.toml"),
        &format!("/{token}//etc/passwd"),
        &format!("/{token}/api/landing/x"),
        &format!("/{token}/results/surface-4-20.csv"),
    ] {
        let (status, _) = get(path);
        assert!([404, 405].contains(&status), "{path}: {status}");
    }
    let (status, _) = get(&format!("/{token}/api/landing"));
    assert_eq!(status, 405);
    let (status, told) = client.send(&client.call("landing", "{}"));
    assert_eq!(status, 200);
    assert!(told.contains("\"outcome\":\"stable-subsided\""));
}

#[test]
fn other_sites_and_names_are_turned_away() {
    let client = Client::start();
    let good = client.call("inputs", "{}");
    assert_eq!(client.send(&good).0, 200);
    let host = format!("Host: {}", client.address);
    for (from, to, expected) in [
        (host.as_str(), "Host: evil.example".to_owned(), 404),
        (&host, format!("{host}\r\nOrigin: http://evil.example"), 404),
        (&host, format!("{host}\r\nOrigin: null"), 404),
        (&host, format!("{host}\r\nSec-Fetch-Site: cross-site"), 404),
        (
            "Content-Type: application/json",
            "Content-Type: text/plain".to_owned(),
            415,
        ),
        (
            "Content-Type: application/json",
            "Accept: */*".to_owned(),
            415,
        ),
        ("POST", "PUT".to_owned(), 405),
        (&client.token, "0".repeat(32), 404),
    ] {
        let (status, _) = client.send(&good.replacen(from, &to, 1));
        assert_eq!(status, expected, "{to}");
    }
}

#[test]
fn requests_that_are_none_get_a_complaint() {
    let client = Client::start();
    let deep = "[".repeat(100_000);
    let wide = format!(
        r#"{{"touchdown": {{"values": {{"friction": {}1}}}}}}"#,
        "0".repeat(1000)
    );
    for (name, body, expected) in [
        ("landing", "", 400),
        ("landing", "{", 400),
        ("landing", "NaN", 400),
        ("landing", "null", 400),
        ("landing", deep.as_str(), 400),
        ("landing", wide.as_str(), 400),
        ("landing", r#"{"interval_s": NaN}"#, 400),
        ("landing", r#"{"interval_s": 1e999}"#, 400),
        (
            "landing",
            r#"{"touchdown": {"values": {"friction": 1e309}}}"#,
            400,
        ),
        (
            "landing",
            r#"{"touchdown": {"values": {"friction": "NaN"}}}"#,
            400,
        ),
        ("landing", "\u{0}\u{1}\u{2}", 400),
        (
            "strip",
            r#"{"from_fps": 0, "to_fps": 10000, "resolution_fps": 1e-9}"#,
            400,
        ),
        ("map", r#"{"results": "../../etc/passwd"}"#, 400),
        ("nothing", "{}", 404),
        ("", "{}", 404),
    ] {
        let (status, told) = client.send(&client.call(name, body));
        assert_eq!(
            status,
            expected,
            "{name} {}: {told}",
            &body[..body.len().min(60)]
        );
        assert!(told.contains("{\"error\":{\"message\":"), "{told}");
    }
    let huge = format!(
        r#"{{"touchdown": {{"vehicle": "{}"}}}}"#,
        "x".repeat(300_000)
    );
    let (status, _) = client.send(&client.call("landing", &huge));
    assert!([413, 0].contains(&status), "{status}");
    assert!(client.is_alive());
}

#[test]
fn a_hundred_wild_clients_neither_end_nor_block_it() {
    let client = Client::start();
    let client = &client;
    // Sockets that never finish what they begin, and are kept.
    let begun: Vec<_> = (0..100)
        .map(|index| {
            let mut stream = client.connect();
            let call = client.call("landing", "{}");
            let part = &call.as_bytes()[..index * call.len() / 101];
            let _ = stream.write_all(part);
            if index % 3 == 0 {
                let _ = stream.shutdown(Shutdown::Write);
            }
            stream
        })
        .collect();
    thread::scope(|scope| {
        for index in 0..100 {
            scope.spawn(move || match index % 6 {
                0 => {
                    let _ = client.send(&client.call("landing", &"{\"a\":".repeat(index * 100)));
                }
                1 => {
                    let _ = client.send("GARBAGE\r\n\r\n\u{0}\u{1}");
                }
                2 => {
                    let _ = client.send(&format!("GET / HTTP/1.1\r\n{}\r\n", "X: y\r\n".repeat(10_000)));
                }
                3 => {
                    // Gone before there is an answer.
                    let mut stream = client.connect();
                    let _ = stream.write_all(client.call("bands", "{}").as_bytes());
                    let _ = stream.shutdown(Shutdown::Both);
                }
                4 => {
                    // Says that there is more to come than there is.
                    let call = client.call("strip", "{}").replace("Content-Length: 2", "Content-Length: 999");
                    let mut stream = client.connect();
                    let _ = stream.write_all(call.as_bytes());
                    let _ = stream.shutdown(Shutdown::Write);
                    let _ = stream.read(&mut [0; 64]);
                }
                _ => {
                    let values = r#"{"touchdown": {"values": {"vertical_velocity_fps": 5000, "solver.tolerance": 1e-10}}}"#;
                    let _ = client.send(&client.call("landing", values));
                }
            });
        }
    });
    assert!(client.is_alive());
    drop(begun);
}

#[test]
fn a_thousand_requests_at_once_are_answered_or_refused() {
    let client = Client::start();
    let client = &client;
    let statuses: Vec<u16> = thread::scope(|scope| {
        let callers: Vec<_> = (0..1000)
            .map(|_| {
                let call = client.call("landing", r#"{"history": false, "drawing": false}"#);
                scope.spawn(move || client.send(&call).0)
            })
            .collect();
        callers
            .into_iter()
            .map(|caller| caller.join().unwrap())
            .collect()
    });
    let count = |status: u16| statuses.iter().filter(|one| **one == status).count();
    assert_eq!(count(200) + count(429), 1000, "{statuses:?}");
    assert!(count(200) >= 64, "{}", count(200));
    assert!(client.is_alive());
}

#[test]
fn files_come_compressed_to_those_who_take_that() {
    let client = Client::start();
    let size = |accept: &str| {
        let (token, address) = (&client.token, client.address);
        let (status, told) = client.send(&format!(
            "GET /{token}/vendor/three.js HTTP/1.1\r\nHost: {address}\r\n{accept}Connection: close\r\n\r\n"
        ));
        assert_eq!(status, 200);
        let head = told.split("\r\n\r\n").next().unwrap().to_lowercase();
        let length = head.split("content-length: ").nth(1).unwrap();
        let length: usize = length.split("\r\n").next().unwrap().parse().unwrap();
        (head.contains("content-encoding: gzip"), length)
    };
    let (is_plain, whole) = size("");
    let (is_packed, packed) = size("Accept-Encoding: br, gzip\r\n");
    assert_eq!((is_plain, is_packed), (false, true));
    assert!(3 * packed < whole, "{packed} of {whole} bytes");
}

#[test]
fn a_link_from_elsewhere_opens_the_page_and_an_old_one_gets_a_sentence() {
    let client = Client::start();
    let open = |token: &str| {
        let address = client.address;
        client.send(&format!(
            "GET /{token}/ HTTP/1.1\r\nHost: {address}\r\nSec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\n\
             Sec-Fetch-Dest: document\r\nConnection: close\r\n\r\n"
        ))
    };
    let (status, page) = open(&client.token);
    assert_eq!(status, 200);
    assert!(page.contains("<title>touchdown"), "{page}");
    let (status, said) = open(&"0".repeat(32));
    assert_eq!(status, 404);
    assert!(said.contains("There is no page at this address."), "{said}");
}
