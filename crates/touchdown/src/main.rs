//! The program `touchdown`.

use std::process::ExitCode;

fn main() -> ExitCode {
    touchdown::main()
}
