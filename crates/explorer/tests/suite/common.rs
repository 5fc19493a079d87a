//! What there is to explore in tests, and a client that sends what it is told.

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::PathBuf;
use std::sync::LazyLock;
use std::thread;
use std::time::Duration;

use serde_json::Value;
use touchdown_explorer::interface::{Complaint, answer};
use touchdown_explorer::named::Named;
use touchdown_explorer::server::{LOOPBACK, Server, random_digits};
use touchdown_input::documents::library::{Library, Source};

/// Longest wait of a client.
const PATIENCE: Duration = Duration::from_secs(60);

/// Files of the repository by their paths in it.
pub fn named(files: &[&str]) -> Named {
    let root = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let files: Vec<PathBuf> = files.iter().map(|file| root.join(file)).collect();
    Named::read(&files, Library::Disk, None).unwrap()
}

/// The explorer's input, made of one table.
pub fn of_table(file: &str, text: &str) -> Named {
    let path = PathBuf::from(file);
    let copies = [Source {
        path: path.clone(),
        text: text.to_owned(),
    }];
    Named::read(&[path], Library::Copies(&copies), None).unwrap()
}

/// The Surveyor, a map and a profile.
pub static NAMED: LazyLock<Named> = LazyLock::new(|| {
    named(&[
        "sweeps/vehicles/surveyor-table-4-1.toml",
        "results/surface-4-20.csv",
        "results/figure-4-09.csv",
    ])
});

pub fn ask(name: &str, request: &Value) -> Result<Value, Complaint> {
    let answered = answer(&NAMED, name, &request.to_string(), &|| false);
    answered.map(|text| serde_json::from_str(&text).unwrap())
}

/// The numbers of a list.
pub fn numbers(value: &Value) -> Vec<f64> {
    let items = value.as_array().unwrap().iter();
    items.map(|item| item.as_f64().unwrap()).collect()
}

/// The distance of two points.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// A point of the vehicle in ground axes, at an instant of a drawing.
pub fn in_ground(instants: &Value, index: usize, point: &Value) -> Vec<f64> {
    let rotation = numbers(&instants["rotation"][index]);
    let (center, point) = (
        numbers(&instants["center_of_gravity"][index]),
        numbers(point),
    );
    (0..3)
        .map(|row| {
            center[row]
                + (0..3)
                    .map(|k| rotation[3 * row + k] * point[k])
                    .sum::<f64>()
        })
        .collect()
}

/// A server of its own, which ends with the tests.
pub struct Client {
    pub address: SocketAddr,
    pub token: String,
}

impl Client {
    pub fn start() -> Self {
        let token = random_digits().unwrap();
        let server = Server::bind((LOOPBACK, 0).into(), NAMED.clone(), token).unwrap();
        let url = server.url();
        thread::spawn(move || server.run().unwrap());
        let (host, token) = url
            .strip_prefix("http://")
            .unwrap()
            .split_once('/')
            .unwrap();
        Self {
            address: host.parse().unwrap(),
            token: token.trim_end_matches('/').to_owned(),
        }
    }

    pub fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(self.address).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        stream.set_write_timeout(Some(PATIENCE)).unwrap();
        stream
    }

    /// A call of the interface as it goes over the wire.
    pub fn call(&self, name: &str, body: &str) -> String {
        let (token, address, length) = (&self.token, self.address, body.len());
        format!(
            "POST /{token}/api/{name} HTTP/1.1\r\nHost: {address}\r\nContent-Type: application/json\r\n\
             Content-Length: {length}\r\nConnection: close\r\n\r\n{body}"
        )
    }

    /// Status and whole answer to what is sent; status 0 where there is none.
    pub fn send(&self, request: &str) -> (u16, String) {
        let mut stream = self.connect();
        // A server that has heard enough may close early.
        let _ = stream.write_all(request.as_bytes());
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let status = text.split(' ').nth(1).and_then(|code| code.parse().ok());
        (status.unwrap_or(0), text)
    }

    /// A call that every server that lives answers.
    pub fn is_alive(&self) -> bool {
        let landing = self.call("landing", r#"{"interval_s": 0.1}"#);
        // Others may have used up what there is for a second.
        (0..50).any(|_| {
            let (status, _) = self.send(&landing);
            if status == 429 {
                thread::sleep(Duration::from_millis(100));
            }
            status == 200
        })
    }
}
