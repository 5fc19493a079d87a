//! `touchdown completions` and `touchdown man`.

use clap::{Args, Command};
use clap_complete::Shell;
use touchdown_input::documents::input_error::InputError;

use crate::terminal::{Failure, print};

/// Options of `completions`.
#[derive(Debug, Args)]
pub struct Completions {
    /// The shell
    shell: Shell,
}

/// Options of `man`.
#[derive(Debug, Args)]
pub struct Manual {
    /// Print the page of this command instead of that of the program
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

/// Prints the completions of a program.
pub fn completions(options: &Completions, mut program: Command) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut program, "touchdown", &mut script);
    print(&String::from_utf8_lossy(&script))
}

/// Prints the manual page of a program, or of one of its commands.
pub fn manual(options: &Manual, mut program: Command) -> Result<(), Failure> {
    program.build();
    let page = match &options.command {
        None => program,
        Some(name) => {
            let command = program.find_subcommand(name).cloned();
            let names = program.get_subcommands().map(Command::get_name);
            let names = names.collect::<Vec<_>>().join(", ");
            command.ok_or_else(|| {
                InputError::other(format!("there is no command {name}: expected {names}"))
            })?
        }
    };
    let mut text = Vec::new();
    clap_mangen::Man::new(page)
        .render(&mut text)
        .map_err(Failure::running)?;
    print(&String::from_utf8_lossy(&text))
}
