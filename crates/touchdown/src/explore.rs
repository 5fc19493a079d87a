//! `touchdown explore`: a page in the browser in which a landing answers as sliders move.

use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::process::{Command, Stdio};

use clap::Args;
use touchdown_explorer::named::Named;
use touchdown_explorer::server::{LOOPBACK, Server};
use touchdown_sweep::input_error::InputError;
use touchdown_sweep::library::Library;

use crate::failure::Failure;
use crate::print::print;
use crate::units::UnitsOption;

const EXAMPLES: &str = "\
Examples:
  The Surveyor at the baseline of the 1966 report:
    touchdown explore --open

  A vehicle of your own, a sweep of it, and the map that came of that:
    touchdown explore lander.toml trade.toml results/trade.csv --open

What is named can be looked at and started from: vehicle, scene and sweep files, and tables of transitions and landings as
touchdown sweep writes them, with what stands beside them (bands, edges, surface, record). Nothing else on the disk is
served, and nothing is written.

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
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
    /// Serve the page on this address of the machine, such as 0.0.0.0 for all, to whoever has the link; it goes over the
    /// network unencrypted
    #[arg(long, value_name = "ADDRESS", default_value_t = LOOPBACK.into())]
    listen: IpAddr,
    #[command(flatten)]
    units: UnitsOption,
}

/// Runs `explore`.
pub fn run(options: &Options) -> Result<(), Failure> {
    let units = options.units.given().unwrap_or_default();
    let named = Named::read(&options.files, Library::Disk, units)?;
    let address = SocketAddr::new(options.listen, options.port);
    let server = Server::bind(address, named).map_err(|error| {
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

/// Opens an address in the browser of the desktop; whether there was a way to.
fn opens(url: &str) -> bool {
    let opener = match std::env::consts::OS {
        "macos" => "open",
        "windows" => "explorer",
        _ => "xdg-open",
    };
    Command::new(opener)
        .arg(url)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .is_ok()
}
