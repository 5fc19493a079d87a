//! `touchdown explore`: a page in the browser in which a landing answers as sliders move.

use std::io::{self, Write};
use std::net::{IpAddr, SocketAddr};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;
use std::{fs, thread};

use clap::Args;
use touchdown_explorer::export;
use touchdown_explorer::named::Named;
use touchdown_explorer::server::{LOOPBACK, Server, random_digits};
use touchdown_input::documents::input_error::InputError;
use touchdown_input::documents::library::Library;
use touchdown_sweep::output::file_writer::Folder;
use touchdown_sweep::output::output_guard::OutputGuard;

use crate::options::UnitsOption;
use crate::summary;
use crate::terminal::{Failure, print};

const EXAMPLES: &str = "\
Examples:
  The Surveyor at the baseline of the 1966 report:
    touchdown explore --open

  A vehicle of your own, a sweep of it, and the map that came of that:
    touchdown explore lander.toml trade.toml results/trade.csv --open

  The same as one file for somebody who has not got this program:
    touchdown explore results/trade.csv --export trade.html

What is named can be looked at and started from: vehicle, scene and sweep files, and tables of transitions and landings as
touchdown sweep writes them, with what stands beside them (bands, edges, surface, record). Nothing else on the disk is served.

  Under the same link after every start:
    touchdown explore lander.toml --port 8123 --token-file explorer-token

The page is served to this machine alone, under an address that nobody can guess. Ctrl-C ends it.";

/// Options of `explore`.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Vehicle, scene and sweep files (.toml), and tables of results (.csv) [default: the Surveyor]
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Port of the address [default: any that is free]
    #[arg(
        long,
        value_name = "PORT",
        default_value_t = 0,
        hide_default_value = true
    )]
    port: u16,
    /// File that holds the token of the address, so that with --port links survive a restart; written with a new token if
    /// there is none
    #[arg(long, value_name = "FILE")]
    token_file: Option<PathBuf>,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
    /// Serve the page on this address of the machine, such as 0.0.0.0 for all, to whoever has the link; it goes over the
    /// network unencrypted
    #[arg(long, value_name = "ADDRESS", default_value_t = LOOPBACK.into())]
    listen: IpAddr,
    /// Write the page with all that was named into one file, which works without this program and without a network
    #[arg(long, value_name = "FILE.html", conflicts_with_all = ["port", "open", "listen", "token_file"], help_heading = "Output")]
    export: Option<PathBuf>,
    /// Also replace an existing file that is not an exported page
    #[arg(long, requires = "export", help_heading = "Output")]
    overwrite: bool,
    #[command(flatten)]
    units: UnitsOption,
}

/// How an exported page begins.
const PAGE: &str = "<!doctype html>";
/// Length of a token in a file.
const TOKEN: RangeInclusive<usize> = 16..=128;
/// Time for a browser to read the file that leads it to the page.
const READING: Duration = Duration::from_secs(60);

/// Runs `explore`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let named = Named::read(&options.files, Library::Disk, options.units.given)?;
    for file in &named.skipped {
        let file = file.display();
        eprintln!(
            "touchdown: warning: {file}: skipped, as it has neither transitions nor landings"
        );
    }
    if let Some(file) = &options.export {
        return export(options, &named, file);
    }
    let address = SocketAddr::new(options.listen, options.port);
    let token = match &options.token_file {
        Some(file) => kept_token(file)?,
        None => random_digits().map_err(Failure::running)?,
    };
    let server = Server::bind(address, named, token).map_err(|error| {
        let said = format!("{address} cannot be listened on: {error}");
        InputError::other(said)
    })?;
    let url = server.url();
    print(&format!("{url}\n"))?;
    if !options.listen.is_loopback() {
        eprintln!(
            "touchdown: warning: whoever has this link can use the page, and it is not encrypted"
        );
    }
    if options.open && !opens(&url) {
        eprintln!("touchdown: warning: no browser could be opened; open the link yourself");
    }
    server.run().map_err(Failure::running)
}

fn export(options: &Options, named: &Named, file: &Path) -> Result<(), Failure> {
    let inputs: Vec<&Path> = options.files.iter().map(PathBuf::as_path).collect();
    let guard = OutputGuard {
        inputs: &inputs,
        overwrite: options.overwrite,
    };
    guard.check(file, |line| line.starts_with(PAGE))?;
    let (folder, name) = Folder::and_name(file)?;
    let page = export::page(named).map_err(Failure::running)?;
    let written = folder.write_files(&[(name, page.into_bytes())])?;
    print(&summary::written(&written))
}

/// The token in a file, which gets a new one if it is not there.
fn kept_token(file: &Path) -> Result<String, Failure> {
    let refuse = |complaint: String| InputError::in_file(file, &complaint);
    match fs::read_to_string(file) {
        Ok(text) => {
            let token = text.trim();
            let is_plain = token.bytes().all(|byte| byte.is_ascii_alphanumeric());
            match is_plain && TOKEN.contains(&token.len()) {
                true => Ok(token.to_owned()),
                false => {
                    let [least, most] = [TOKEN.start(), TOKEN.end()];
                    let complaint =
                        format!("expected a token of {least} to {most} letters and digits");
                    Err(refuse(complaint).into())
                }
            }
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            let token = random_digits().map_err(Failure::running)?;
            own_file(file, &format!("{token}\n")).map_err(|error| refuse(error.to_string()))?;
            Ok(token)
        }
        Err(error) => Err(refuse(error.to_string()).into()),
    }
}

/// Writes a new file that nobody else can read.
fn own_file(file: &Path, text: &str) -> io::Result<()> {
    let mut options = fs::OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    options.open(file)?.write_all(text.as_bytes())
}

/// Opens an address in the browser of the desktop; whether there was a way to. Everybody on the machine sees the words of a
/// command, and so it is given a file that leads to the address.
fn opens(url: &str) -> bool {
    let Ok(digits) = random_digits() else {
        return false;
    };
    let file = std::env::temp_dir().join(format!("touchdown-{digits}.html"));
    let page = format!(
        "{PAGE}<meta charset=\"utf-8\"><title>touchdown</title><meta http-equiv=\"refresh\" content=\"0;url={url}\">\
         <a href=\"{url}\">Open the explorer</a>\n"
    );
    if own_file(&file, &page).is_err() {
        return false;
    }
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    let is_opened = Command::new(opener)
        .arg(&file)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .is_ok();
    thread::spawn(move || {
        thread::sleep(READING);
        let _ = fs::remove_file(file);
    });
    is_opened
}
